// A signed number without separator or unit, read straight from the text: what the short cuts for
// literal data accept. Everything else is left to the lexer.
#pragma once

#include "base/parse_number.h"
#include "parser/syntax/characters.h"

namespace lray::parser {

struct NumberLiteral {
    double value = 0.0;
    const char* end = nullptr;  // null: not such a number
};

inline NumberLiteral read_number_literal(const char* at) {
    const bool is_negative = *at == '-';
    const ParsedNumber parsed = parse_decimal(is_negative ? at + 1 : at);
    if (!parsed.is_found() || parsed.is_too_large()) return {};
    if (is_a(*parsed.end, kLetter | kDigit) || *parsed.end == '.') return {};
    return {is_negative ? -parsed.value : parsed.value, parsed.end};
}

}  // namespace lray::parser
