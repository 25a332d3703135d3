#include "parser/builtins/parameter_type.h"

#include <cmath>

#include "base/assert.h"

namespace lray::parser {

using enum ParameterType;

namespace {

/// The empty list is one of numbers too.
bool is_list_of_numbers(const Value& value) {
    return value.is(ValueKind::numbers) || (value.is(ValueKind::list) && value.count == 0);
}

}  // namespace

bool fits(ParameterType type, const Value& value) {
    switch (type) {
        case number:
            return value.is(ValueKind::number);
        case elements:
            return value.is(ValueKind::number) || is_list_of_numbers(value);
        case vector:
            return value.is(ValueKind::numbers) && value.count >= 2 && value.count <= 4;
        case vec3:
            return value.is_vector(3);
        case color:
            return value.is(ValueKind::color) || value.is(ValueKind::number) || value.is_vector(3);
        case transform:
            return value.is(ValueKind::transform);
        case rows:
            return value.is(ValueKind::rows) && value.width == 4 &&
                   (value.count == 3 || value.count == 4);
        case any_scale:
            return value.is(ValueKind::number) || value.is_vector(3);
        case any:
            return true;
        case integer:
            return value.is(ValueKind::number) && value.number == std::floor(value.number);
        case string:
            return value.is(ValueKind::string);
        case list:
            return value.is_list();
        case numbers:
            return is_list_of_numbers(value);
        case function:
            return value.is(ValueKind::function);
        case node:
            return value.is(ValueKind::node);
        case position:
            return value.is(ValueKind::number) || value.is_vector(2) || value.is_vector(3);
        case boolean:
            return value.is(ValueKind::boolean);
        case blendable:
            return value.is(ValueKind::number) || value.is(ValueKind::color) ||
                   is_list_of_numbers(value);
        case points:
            return value.is(ValueKind::rows) && value.width == 3;
        case key:
            return value.is(ValueKind::number) || value.is(ValueKind::string);
    }
    LRAY_ASSERT(false);
}

std::string_view in_words(ParameterType type) {
    switch (type) {
        case number:
            return "a number";
        case elements:
            return "a number or a vector";
        case vector:
            return "a vector";
        case vec3:
            return "3 numbers, like [1, 2, 3]";
        case color:
            return "a colour";
        case transform:
            return "a transform";
        case rows:
            return "3 or 4 rows of 4 numbers";
        case any_scale:
            return "a number or three";
        case any:
            return "a value";
        case integer:
            return "a whole number";
        case string:
            return "a string";
        case list:
            return "a list";
        case numbers:
            return "a list of numbers";
        case function:
            return "a function";
        case node:
            return "a node, like a group or a sphere";
        case position:
            return "a number or a vector of 2 or 3";
        case boolean:
            return "true or false";
        case blendable:
            return "a number, a vector or a colour";
        case points:
            return "a list of points, like [[0, 0, 0], [1, 2, 3]]";
        case key:
            return "a number or a string";
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::parser
