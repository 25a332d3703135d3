// What comes in place of a scene as the first argument: `lray diff A B`.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cli/options.h"

namespace lray::cli {

/// A command takes files, and of the options those that it names.
struct Command {
    std::string_view name{};
    std::string_view arguments{};  // as --help shows them
    std::string_view help{};
    std::string_view example{};
    std::string_view takes{};  // its files, in words
    Mode mode = Mode::render;
    std::size_t least_paths = 1;
    std::size_t most_paths = 1;
    std::span<const std::string_view> options{};  // names, without dashes
};

/// All commands in the order of --help.
std::span<const Command> commands();

/// Returns the command of that name; null if there is none. A scene that is called like a command
/// is given as `-i diff` or `./diff`.
const Command* find_command(std::string_view name);

/// True if an option is one of a command's; all take those of messages.
bool takes_option(const Command& command, std::string_view option);

/// Returns what is wrong with the number of files; empty if nothing is.
std::optional<Failure> check_paths(const Command& command, std::size_t path_count);

}  // namespace lray::cli
