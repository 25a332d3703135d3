// Runs programs of the language for its tests: what they print, and what is said about them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/parser/loaded.h"

namespace lray::test {

/// A scene that was run.
struct Ran {
    Loaded loaded{};
    std::string printed{};  // a line each
    std::vector<std::string> usage_mistakes{};
    std::vector<parser::ParamValue> params{};
    std::string directory{};  // where its files were

    /// What was printed, then a line for each diagnostic, "E0401 1:10 message"; those that only say
    /// what is missing from the scene are left out.
    std::string told() const;
};

Ran run(std::string_view scene, parser::LoadSettings settings = {},
        const std::vector<Companion>& companions = {});

/// Ran::told() of the scene.
std::string told_by(std::string_view scene, const parser::LoadSettings& settings = {},
                    const std::vector<Companion>& companions = {});

std::string repeated(std::string_view text, std::size_t count);

}  // namespace lray::test
