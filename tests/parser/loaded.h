// Loads scenes for the tests of the language, and puts diagnostics into comparable text.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/file_access.h"
#include "base/source.h"
#include "parser/load.h"
#include "scene/flatten.h"
#include "scene/lint.h"
#include "scene/scene.h"
#include "tests/support/temp_directory.h"

namespace lray::test {

/// A scene that was loaded, with all that was said about it.
struct Loaded {
    Sources sources{};
    Diagnostics diagnostics{};
    std::optional<scene::Scene> scene{};

    bool has_errors() const { return diagnostics.has_errors(); }

    /// The codes in the order of printing: "E0401 W1201".
    std::string codes() const;

    /// One line for each diagnostic, in the order of printing: "E0401 1:10 message".
    std::string text() const;
};

/// A file that a scene names.
struct Companion {
    std::string_view name{};
    std::string_view content{};
};

/// Settings with these limits.
inline parser::LoadSettings with_limits(const parser::LoadLimits& limits) {
    parser::LoadSettings settings;
    settings.limits = limits;
    return settings;
}

Loaded load_file(const std::string& path, const parser::LoadSettings& settings = {},
                 const WarningLevels& levels = {});

/// Also those warnings that are silent by default.
WarningLevels all_warnings();

/// Flattens what was loaded and looks at it as a whole, as the program does.
std::optional<scene::World> flatten_and_lint(Loaded& loaded,
                                             const scene::FlattenLimits& limits = {},
                                             const scene::LintSettings& settings = {});

/// Loads the text as `main.lrs` in a directory with the companions.
Loaded load_text(std::string_view text, const parser::LoadSettings& settings = {},
                 const std::vector<Companion>& companions = {});

inline Loaded load_text(std::string_view text, const parser::LoadLimits& limits,
                        const std::vector<Companion>& companions = {}) {
    return load_text(text, with_limits(limits), companions);
}

/// "1:10"; "files/part.lrs:1:10" outside of the main file; "-" for nowhere.
std::string place_of(const Sources& sources, Span span);

/// A copy of examples/, where scenes can be changed and loaded with what they name.
class Examples {
 public:
    Examples();

    /// The scenes, as paths below the directory, sorted.
    const std::vector<std::string>& names() const { return names_; }
    std::string text(const std::string& name) const { return directory_.read(name); }

    /// Loads a scene of this name with another text, and puts the old one back.
    Loaded load_changed(const std::string& name, std::string_view text,
                        const parser::LoadSettings& settings = {}) const;

 private:
    TempDirectory directory_;
    std::vector<std::string> names_;
};

}  // namespace lray::test
