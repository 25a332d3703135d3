// The types of the parameters of built-in functions: which values fit, and what they are called.
#pragma once

#include <cstdint>
#include <string_view>

#include "parser/values/value.h"

namespace lray::parser {

enum class ParameterType : std::uint8_t {
    number,
    elements,  // a number, or a list of numbers taken element by element
    vector,    // 2 to 4 numbers
    vec3,
    color,
    transform,
    rows,       // 3 or 4 rows of 4 numbers
    any_scale,  // a number or three
    any,
    integer,
    string,
    list,
    numbers,  // a list of numbers of any length
    function,
    node,
    position,  // a number, or a vector of 2 or 3
    boolean,
    blendable,  // a number, a list of numbers, or a colour
    points,     // rows of 3 numbers
    key,        // a number or a string, of random numbers
};

bool fits(ParameterType type, const Value& value);

/// Returns what a message asks for: "a number".
std::string_view in_words(ParameterType type);

}  // namespace lray::parser
