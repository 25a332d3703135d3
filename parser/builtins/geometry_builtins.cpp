// Functions of shapes in the scene, and of curves.
#include <array>
#include <optional>

#include "base/assert.h"
#include "parser/builtins/curve.h"
#include "parser/builtins/facing.h"
#include "parser/builtins/families.h"
#include "parser/builtins/results.h"
#include "scene/node_bounds.h"

namespace lray::parser {

namespace {

Value box_record(Call& call, DVec3 min, DVec3 max) {
    struct Field {
        std::string_view name{};
        DVec3 value{};
    };
    const std::array<Field, 4> fields = {
        {{"min", min}, {"max", max}, {"size", max - min}, {"center", min * 0.5 + max * 0.5}}};
    if (!take_bytes(call.budget, fields.size() * sizeof(RecordField), call.span,
                    call.diagnostics)) {
        return Value::poison();
    }
    std::array<RecordField, 4> record{};
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const Value value = of_vec3(call, fields[i].value);
        if (value.is(ValueKind::poison)) return value;
        record[i] = {call.runtime.intern(fields[i].name), value};
    }
    return Value::of_record(call.arena.copy(std::span<const RecordField>(record)), 1);
}

Value bounds_of(Call& call) {
    using enum scene::NodeBounds::Outcome;
    const scene::NodeId id(call[0].made->id);
    const scene::NodeBounds bounds =
        scene::node_bounds(call.runtime.scene(), id, call.budget.steps);
    // One more than there is says that there is no more.
    const std::uint64_t steps = bounds.work + (bounds.outcome == too_large ? 1 : 0);
    if (!take_steps(call, steps)) return Value::poison();
    switch (bounds.outcome) {
        case box:
            return box_record(call, bounds.min, bounds.max);
        case empty:
            call.diagnostics.error(Code::E0505, call.spans[0],
                                   "this has no bounds: nothing in it has a size");
            return Value::poison();
        case infinite:
            call.diagnostics
                .error(Code::E0503, call.spans[0], "this has no bounds: it is infinitely large")
                .with_help("planes are infinite; a rectangle has a size");
            return Value::poison();
        case too_large:
            break;
    }
    LRAY_ASSERT(false);
}

CurvePoint point_on(Call& call) {
    return curve_point({call[0].numbers, std::size_t{call[0].count} * 3}, call.number(1));
}

Value curve_of(Call& call) {
    return of_vec3(call, point_on(call).position);
}

Value path_frame_of(Call& call) {
    const CurvePoint at = point_on(call);
    const std::optional<Transform> turn = facing(at.tangent);
    if (turn) return of_transform(call, turn->then(Transform::translation(at.position)));
    return no_value(call, "the curve has no direction here: neighbouring points are the same");
}

using enum ParameterType;

// clang-format off
constexpr std::array kBuiltins = {
    Builtin{"bounds", {{{"node", node}}}, bounds_of, "the box around a node after its own steps: a record of min, max, size and center"},
    Builtin{"curve", {{{"points", points}, {"t", number}}}, curve_of, "a point of a smooth curve through the points, from the first at t = 0 to the last at t = 1"},
    Builtin{"path_frame", {{{"points", points}, {"t", number}}}, path_frame_of, "puts the origin at that point, with -Z along the curve and Y upwards"},
};
// clang-format on

}  // namespace

std::span<const Builtin> geometry_builtins() {
    return kBuiltins;
}

}  // namespace lray::parser
