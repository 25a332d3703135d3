// Loads a scene for the window, again and again: the pipeline up to what is traced.
#pragma once

#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/exit_code.h"
#include "cli/options.h"
#include "cli/report.h"
#include "gui/program.h"

namespace lray::cli {

/// Calls are made by one thread at a time; info() by any.
class WindowSceneLoader {
 public:
    explicit WindowSceneLoader(const Options& options) : options_(options) {}

    /// Loads it for the first time. Errors: how the program ends, having said why.
    std::optional<ExitCode> load_first(gui::LoadedScene& loaded);

    /// Loads it again, with values for some params over those of the command line; params that are
    /// no more, or do not take their value any more, get their own. What is wrong is said on stderr
    /// and in the messages.
    gui::LoadedScene load_again(std::span<const gui::ParamText> params);

    /// Returns the `info` of the scene loaded last, and the files it was read from.
    std::vector<std::pair<std::string, std::string>> info() const;
    std::vector<std::string> files() const;

 private:
    struct Attempt {
        gui::LoadedScene loaded{};
        std::vector<std::string> usage_mistakes{};
        std::optional<ExitCode> end{};  // after errors
    };

    Attempt load(const Options& options);
    Attempt load_or_run_out_of_memory(const Options& options);

    Options options_;
    DiagnosticsReport report_;
    mutable std::mutex mutex_;
    std::vector<std::pair<std::string, std::string>> info_;
    std::vector<std::string> files_;
};

}  // namespace lray::cli
