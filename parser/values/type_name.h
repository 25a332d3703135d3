// Type annotations and the values they allow.
#pragma once

#include <string_view>

#include "parser/syntax/ast.h"
#include "parser/values/value.h"

namespace lray::parser {

bool has_type(TypeName type, const Value& value);

/// "a number", "3 numbers": what a value of the type is.
std::string_view in_words(TypeName type);

}  // namespace lray::parser
