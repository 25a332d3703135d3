// The one table of options: parsing, suggestions and --help are made from it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "cli/options.h"

namespace lray::cli {

struct OptionSpec {
    const char* name = "";   // without dashes
    const char* value = "";  // of its value in --help; empty: it takes none; "[=X]": X or none
    const char* help = "";   // empty: another name of the option before it

    /// Stores the value. Returns an empty string, or what is wrong as the end of a sentence that
    /// begins with the option's name.
    std::string (*apply)(Options& options, std::string_view value) = nullptr;

    /// Of a limit: its value now.
    std::uint64_t (*value_of)(const Options& options) = nullptr;

    bool takes_value() const { return *value != '\0'; }
    bool may_take_value() const { return *value == '['; }
};

struct OptionGroup {
    const char* title = "";
    std::span<const OptionSpec> options{};
};

/// All options in the order of --help.
std::span<const OptionGroup> option_groups();

/// The name with its dashes: `-ps`, `--size`.
std::string spelled(std::string_view option_name);

}  // namespace lray::cli
