#include "parser/values/value.h"

#include <fmt/format.h>

#include "base/assert.h"
#include "parser/blocks/schema.h"

namespace lray::parser {

std::string describe(const Value& value) {
    switch (value.kind) {
        case ValueKind::none:
        case ValueKind::poison:
            return "nothing";
        case ValueKind::number:
            return "a number";
        case ValueKind::boolean:
            return value.boolean ? "true" : "false";
        case ValueKind::string:
            return "a string";
        case ValueKind::numbers:
            return value.count == 1 ? "a list of 1 number"
                                    : fmt::format("a list of {} numbers", value.count);
        case ValueKind::rows:
            return fmt::format("a list of {} list{}", value.count, value.count == 1 ? "" : "s");
        case ValueKind::list:
            return value.count == 0 ? "an empty list"
                                    : fmt::format("a list of {} element{}", value.count,
                                                  value.count == 1 ? "" : "s");
        case ValueKind::color:
            return "a colour";
        case ValueKind::transform:
            return "a transform";
        case ValueKind::texture:
            return "a texture";
        case ValueKind::record:
            return "a record";
        case ValueKind::function:
            return "a function";
        case ValueKind::material:
            return "a material";
        case ValueKind::node:
            return fmt::format("a {}", value.made->schema->name);
    }
    LRAY_ASSERT(false);
}

std::string format_number(double number) {
    return fmt::format("{}", number);
}

}  // namespace lray::parser
