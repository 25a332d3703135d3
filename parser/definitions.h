// Values of params from the command line: `-D name=value`.
#pragma once

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "parser/check/checker.h"
#include "parser/load.h"
#include "parser/syntax/parser.h"
#include "parser/values/value.h"

namespace lray::parser {

/// Returns the value of each param that is defined; the last definition of a name counts. A value
/// is a literal: a number, a colour (also `rgb(1, 0.5, 0)`), a list, true, a string (its quotes may
/// be left out).
/// Errors: a sentence for each definition that names no param or holds no value.
std::unordered_map<const LetItem*, Value> read_definitions(std::span<const Definition> definitions,
                                                           const Checked& checked,
                                                           ParseContext& context,
                                                           std::vector<std::string>& mistakes);

}  // namespace lray::parser
