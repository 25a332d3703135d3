// Functions that make transforms, and apply them.
#include <fmt/format.h>

#include <array>
#include <optional>

#include "parser/builtins/facing.h"
#include "parser/builtins/families.h"
#include "parser/builtins/results.h"
#include "parser/values/transform_values.h"

namespace lray::parser {

namespace {

Value make_translation(Call& call) {
    return of_transform(call, Transform::translation(call[0].vec3()));
}
Value make_rotation(Call& call) {
    if (call[0].vec3() == DVec3{0.0}) return no_value(call, "an axis of length 0 has no direction");
    const Transform turn = Transform::rotation(call[0].vec3(), call.number(1));
    if (call[2].is(ValueKind::none)) return of_transform(call, turn);
    const DVec3 about = call[2].vec3();
    return of_transform(
        call, Transform::translation(-about).then(turn).then(Transform::translation(about)));
}
Value make_rotation_x(Call& call) {
    return of_transform(call, Transform::rotation_x(call.number(0)));
}
Value make_rotation_y(Call& call) {
    return of_transform(call, Transform::rotation_y(call.number(0)));
}
Value make_rotation_z(Call& call) {
    return of_transform(call, Transform::rotation_z(call.number(0)));
}
Value make_scaling(Call& call) {
    return of_transform(call, scaling_of(call[0]));
}
Value make_matrix(Call& call) {
    return of_transform(call, matrix_of(call[0]));
}
Value make_similarity(Call& call) {
    const Transform map = matrix_of(call[0]);
    const auto similarity = Transform::similarity(map.linear(), map.offset(), call.number(1));
    if (similarity) return of_transform(call, *similarity);
    return no_value(call,
                    fmt::format("these rows do not keep shapes, or do not multiply lengths by {}; "
                                "`matrix` takes any rows",
                                format_number(call.number(1))));
}
Value make_inverse(Call& call) {
    const std::optional<Transform> inverse = call[0].transform->inverse();
    if (inverse) return of_transform(call, *inverse);
    call.diagnostics.error(Code::E0310, call.span, "this transform cannot be inverted");
    return Value::poison();
}
Value make_look_at(Call& call) {
    const std::optional<Transform> turn = facing(call[1].vec3() - call[0].vec3());
    if (turn) return of_transform(call, turn->then(Transform::translation(call[0].vec3())));
    return no_value(call, "`position` and `target` are the same point, or infinitely far apart");
}
Value apply_transform(Call& call) {
    return of_vec3(call, call[0].transform->point(call[1].vec3()));
}

using enum ParameterType;

constexpr Parameter kAngle{"angle", number};

// clang-format off
constexpr std::array kBuiltins = {
    Builtin{"translation", {{{"offset", vec3}}}, make_translation, "moves"},
    Builtin{"rotation", {{{"axis", vec3}, {"angle", number}, {"about", vec3, true}}}, make_rotation, "turns about an axis through a point"},
    Builtin{"rotation_x", {kAngle}, make_rotation_x, "turns about X"},
    Builtin{"rotation_y", {kAngle}, make_rotation_y, "turns about Y"},
    Builtin{"rotation_z", {kAngle}, make_rotation_z, "turns about Z"},
    Builtin{"scaling", {{{"factor", any_scale}}}, make_scaling, "scales by a number or by three"},
    Builtin{"matrix", {{{"rows", rows}}}, make_matrix, "3 or 4 rows of 4 numbers"},
    Builtin{"similarity", {{{"rows", rows}, {"scale", number}}}, make_similarity, "a matrix that turns, moves, and scales by `scale` alone; written by `--dump`"},
    Builtin{"look_at", {{{"position", vec3}, {"target", vec3}}}, make_look_at, "puts the origin at position, with -Z towards target and Y upwards"},
    Builtin{"inverse", {{{"t", transform}}}, make_inverse, "undoes a transform"},
    Builtin{"apply", {{{"t", transform}, {"p", vec3}}}, apply_transform, "where a point goes"},
};
// clang-format on

}  // namespace

std::span<const Builtin> transform_builtins() {
    return kBuiltins;
}

}  // namespace lray::parser
