#include "parser/values/transform_values.h"

#include <cmath>

#include "base/angle.h"
#include "base/assert.h"

namespace lray::parser {

namespace {

/// Turns the object about where its origin is by now, so that its -Z axis points at the target and
/// its Y axis up as far as it can.
Transform looking_at(const Transform& before, DVec3 target) {
    const DVec3 origin = before.offset();
    const DVec3 forward = target - origin;
    if (forward == DVec3{0.0}) return before;
    // Made of a pitch and a heading, so that it counts as the rotation it is.
    const double heading = degrees(std::atan2(-forward.x, -forward.z));
    const double pitch = degrees(std::atan2(forward.y, std::hypot(forward.x, forward.z)));
    const Transform turn = Transform::rotation_x(pitch).then(Transform::rotation_y(heading));
    return before.then(Transform::translation(-origin))
        .then(turn)
        .then(Transform::translation(origin));
}

bool is_identity(const Transform& transform) {
    return transform.is_similarity() && transform.similarity_scale() == 1.0 &&
           transform.linear() == DMat3{1.0} && transform.offset() == DVec3{0.0};
}

}  // namespace

Transform scaling_of(const Value& value) {
    return value.is(ValueKind::number) ? Transform::scaling(value.number)
                                       : Transform::scaling(value.vec3());
}

Transform matrix_of(const Value& rows) {
    LRAY_ASSERT(rows.is(ValueKind::rows) && rows.width == 4 && rows.count >= 3);
    DMat3 linear{1.0};
    DVec3 offset{0.0};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            linear[column][row] = rows.numbers[4 * row + column];
        }
        offset[row] = rows.numbers[4 * row + 3];
    }
    return Transform::affine(linear, offset);
}

Transform with_step(const Transform& before, CommonProperty step, const Value& value) {
    switch (step) {
        case CommonProperty::translate:
            return before.then(Transform::translation(value.vec3()));
        case CommonProperty::scale:
            return before.then(scaling_of(value));
        case CommonProperty::rotate_x:
            return before.then(Transform::rotation_x(value.number));
        case CommonProperty::rotate_y:
            return before.then(Transform::rotation_y(value.number));
        case CommonProperty::rotate_z:
            return before.then(Transform::rotation_z(value.number));
        case CommonProperty::rotate:
            if (value.is(ValueKind::transform)) return before.then(*value.transform);
            return before.then(Transform::rotation_x(value.numbers[0]))
                .then(Transform::rotation_y(value.numbers[1]))
                .then(Transform::rotation_z(value.numbers[2]));
        case CommonProperty::matrix:
            return before.then(matrix_of(value));
        case CommonProperty::transform: {
            if (value.is(ValueKind::transform)) {
                // A product with the identity would change the signs of zeros.
                return is_identity(before) ? *value.transform : before.then(*value.transform);
            }
            Transform result = before;
            for (std::uint32_t i = 0; i < value.count; ++i) {
                result = result.then(*value.elements[i].transform);
            }
            return result;
        }
        case CommonProperty::look_at:
            return looking_at(before, value.vec3());
        case CommonProperty::material:
        case CommonProperty::visible:
        case CommonProperty::casts_shadow:
            break;
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::parser
