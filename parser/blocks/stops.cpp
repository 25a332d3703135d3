#include "parser/blocks/stops.h"

#include "base/assert.h"
#include "parser/values/operators.h"

namespace lray::parser {

std::optional<scene::ColorStop> read_stop(const Value& value) {
    const bool is_pair = value.is_list() && !value.is(ValueKind::rows) && value.count == 2;
    if (!is_pair) return std::nullopt;
    const Value at = element(value, 0);
    const Value color = element(value, 1);
    if (!at.is(ValueKind::number)) return std::nullopt;
    if (color.is(ValueKind::number)) return scene::ColorStop{at.number, Color{DVec3{color.number}}};
    if (!color.is(ValueKind::color) && !color.is_vector(3)) return std::nullopt;
    return scene::ColorStop{at.number, Color{color.vec3()}};
}

std::vector<scene::ColorStop> read_stops(const Value& stops) {
    std::vector<scene::ColorStop> result;
    result.reserve(stops.count);
    for (std::uint32_t i = 0; i < stops.count; ++i) {
        const std::optional<scene::ColorStop> stop = read_stop(element(stops, i));
        LRAY_ASSERT(stop);
        result.push_back(*stop);
    }
    return result;
}

}  // namespace lray::parser
