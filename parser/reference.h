// The reference of blocks and functions as text, made from the tables that the checker uses.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "parser/blocks/schema.h"
#include "parser/builtins/parameter_type.h"

namespace lray::parser {

/// Returns what a property or parameter takes, in a few words: "2 numbers".
std::string_view type_name(PropertyType type);
std::string_view type_name(ParameterType type);

/// Returns what a block is and a table of its properties: type, default, meaning; empty if there
/// is no block of that name.
std::optional<std::string> describe_block(std::string_view name);

/// Returns the signature of a built-in function and what it gives; empty if there is none of that
/// name.
std::optional<std::string> describe_function(std::string_view name);

}  // namespace lray::parser
