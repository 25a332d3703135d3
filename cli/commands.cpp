#include "cli/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace lray::cli {

namespace {

constexpr std::array<std::string_view, 5> kOptionsOfAll = {"h", "help", "quiet", "color",
                                                           "max-memory"};

constexpr std::array<std::string_view, 6> kDiffOptions = {
    "o", "threshold", "format", "jpeg-quality", "png-bits", "max-output-pixels"};

constexpr std::array<std::string_view, 5> kMergeOptions = {"o", "format", "jpeg-quality",
                                                           "png-bits", "max-output-pixels"};

constexpr std::size_t kMostParts = 1000;

constexpr std::array kCommands{
    Command{"diff", "A B", "how much two pictures differ; -o FILE is a picture of it",
            "lray diff before.png after.png", "two pictures", Mode::diff, 2, 2, kDiffOptions},
    Command{"merge", "PARTS", "add up films, rendered by --samples A:B -o part.film, to -o FILE",
            "lray merge a.film b.film -o image.png", "films", Mode::merge, 1, kMostParts,
            kMergeOptions},
};

}  // namespace

std::span<const Command> commands() {
    return kCommands;
}

const Command* find_command(std::string_view name) {
    const auto found = std::ranges::find(kCommands, name, &Command::name);
    return found == kCommands.end() ? nullptr : &*found;
}

bool takes_option(const Command& command, std::string_view option) {
    return std::ranges::count(kOptionsOfAll, option) > 0 ||
           std::ranges::count(command.options, option) > 0;
}

std::optional<Failure> check_paths(const Command& command, std::size_t path_count) {
    if (path_count >= command.least_paths && path_count <= command.most_paths) return std::nullopt;
    return Failure{
        ExitCode::usage,
        fmt::format("`lray {}` takes {}, not {}", command.name, command.takes, path_count),
        std::string(command.example)};
}

}  // namespace lray::cli
