#include "cli/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/diagnostic_printer.h"

namespace lray::cli {

ExitCode print_requested(std::string_view text) {
    const bool is_written =
        std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (is_written) return ExitCode::done;
    return report_failure(
        {ExitCode::output, fmt::format("cannot write to stdout: {}", std::strerror(errno)), {}});
}

void print_message(std::string_view text) {
    // If stderr is gone there is nobody left to tell.
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
    static_cast<void>(std::fflush(stderr));
}

ExitCode report_failure(const Failure& failure) {
    std::string text = fmt::format("lray: {}\n", escape_for_terminal(failure.message));
    if (!failure.help.empty()) text += fmt::format("  {}\n", escape_for_terminal(failure.help));
    print_message(text);
    return failure.exit_code;
}

void print_warning(std::string_view text) {
    print_message(fmt::format("lray: warning: {}\n", escape_for_terminal(text)));
}

void print_note(std::string_view text) {
    print_message(fmt::format("lray: note: {}\n", escape_for_terminal(text)));
}

bool use_color(ColorMode mode) {
    switch (mode) {
        case ColorMode::always:
            return true;
        case ColorMode::never:
            return false;
        case ColorMode::automatic:
            break;
    }
    const char* const no_color = std::getenv("NO_COLOR");
    const char* const terminal = std::getenv("TERM");
    return stderr_is_terminal() && (no_color == nullptr || *no_color == '\0') &&
           terminal != nullptr && std::string_view(terminal) != "dumb";
}

bool stderr_is_terminal() {
    return isatty(STDERR_FILENO) == 1;
}

}  // namespace lray::cli
