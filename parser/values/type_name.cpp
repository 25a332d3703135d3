#include "parser/values/type_name.h"

#include <cmath>

#include "base/assert.h"

namespace lray::parser {

bool has_type(TypeName type, const Value& value) {
    switch (type) {
        case TypeName::any:
            return true;
        case TypeName::number:
            return value.is(ValueKind::number);
        case TypeName::integer:
            return value.is(ValueKind::number) && value.number == std::floor(value.number);
        case TypeName::boolean:
            return value.is(ValueKind::boolean);
        case TypeName::string:
            return value.is(ValueKind::string);
        case TypeName::vec2:
            return value.is_vector(2);
        case TypeName::vec3:
            return value.is_vector(3);
        case TypeName::vec4:
            return value.is_vector(4);
        case TypeName::color:
            return value.is(ValueKind::color) || value.is(ValueKind::number) || value.is_vector(3);
        case TypeName::list:
            return value.is_list();
        case TypeName::transform:
            return value.is(ValueKind::transform);
        case TypeName::texture:
            return value.is(ValueKind::texture);
        case TypeName::material:
            return value.is(ValueKind::material);
        case TypeName::node:
            return value.is(ValueKind::node);
        case TypeName::record:
            return value.is(ValueKind::record);
        case TypeName::function:
            return value.is(ValueKind::function);
    }
    LRAY_ASSERT(false);
}

std::string_view in_words(TypeName type) {
    switch (type) {
        case TypeName::any:
            return "a value";
        case TypeName::number:
            return "a number";
        case TypeName::integer:
            return "a whole number";
        case TypeName::boolean:
            return "true or false";
        case TypeName::string:
            return "a string";
        case TypeName::vec2:
            return "2 numbers";
        case TypeName::vec3:
            return "3 numbers";
        case TypeName::vec4:
            return "4 numbers";
        case TypeName::color:
            return "a colour";
        case TypeName::list:
            return "a list";
        case TypeName::transform:
            return "a transform";
        case TypeName::texture:
            return "a texture";
        case TypeName::material:
            return "a material";
        case TypeName::node:
            return "a node, like a group or a sphere";
        case TypeName::record:
            return "a record";
        case TypeName::function:
            return "a function";
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::parser
