// The reference of blocks and functions as text, made from the tables that the checker uses.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lray::parser {

/// Returns what a block is and a table of its properties: type, default, meaning; empty if there
/// is no block of that name.
std::optional<std::string> describe_block(std::string_view name);

/// Returns the signature of a built-in function and what it gives; empty if there is none of that
/// name.
std::optional<std::string> describe_function(std::string_view name);

}  // namespace lray::parser
