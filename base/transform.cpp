#include "base/transform.h"

#include <cmath>

#include "base/angle.h"
#include "base/assert.h"

namespace lray {

Transform Transform::translation(DVec3 offset) {
    Transform result;
    result.offset_ = offset;
    return result;
}

Transform Transform::rotation(DVec3 axis, double angle_degrees) {
    // Rodrigues' formula. Scaling by the largest component first keeps the length finite.
    const double largest =
        std::max(std::fabs(axis.x), std::max(std::fabs(axis.y), std::fabs(axis.z)));
    LRAY_ASSERT(largest > 0.0);
    const DVec3 u = glm::normalize(axis / largest);
    const double c = cos_degrees(angle_degrees);
    const double s = sin_degrees(angle_degrees);
    const double k = 1.0 - c;
    Transform result;
    result.linear_[0] = DVec3{c + u.x * u.x * k, u.y * u.x * k + u.z * s, u.z * u.x * k - u.y * s};
    result.linear_[1] = DVec3{u.x * u.y * k - u.z * s, c + u.y * u.y * k, u.z * u.y * k + u.x * s};
    result.linear_[2] = DVec3{u.x * u.z * k + u.y * s, u.y * u.z * k - u.x * s, c + u.z * u.z * k};
    return result;
}

Transform Transform::rotation_x(double angle_degrees) {
    return rotation(DVec3{1.0, 0.0, 0.0}, angle_degrees);
}

Transform Transform::rotation_y(double angle_degrees) {
    return rotation(DVec3{0.0, 1.0, 0.0}, angle_degrees);
}

Transform Transform::rotation_z(double angle_degrees) {
    return rotation(DVec3{0.0, 0.0, 1.0}, angle_degrees);
}

Transform Transform::scaling(double factor) {
    Transform result;
    result.linear_ = DMat3{factor};
    result.scale_ = std::fabs(factor);
    return result;
}

Transform Transform::scaling(DVec3 factors) {
    Transform result;
    result.linear_[0][0] = factors.x;
    result.linear_[1][1] = factors.y;
    result.linear_[2][2] = factors.z;
    result.is_similarity_ = false;
    return result;
}

Transform Transform::affine(const DMat3& linear, DVec3 offset) {
    Transform result;
    result.linear_ = linear;
    result.offset_ = offset;
    result.is_similarity_ = false;
    return result;
}

Transform Transform::then(const Transform& next) const {
    Transform result;
    result.linear_ = next.linear_ * linear_;
    result.offset_ = next.linear_ * offset_ + next.offset_;
    result.scale_ = next.scale_ * scale_;
    result.is_similarity_ = is_similarity_ && next.is_similarity_;
    return result;
}

DVec3 Transform::normal(DVec3 n) const {
    // The cofactor matrix is det * inverse transpose; its sign is mended so that no mirroring
    // turns the normal inside out. No division: a nearly singular map stays well-behaved.
    const DMat3& m = linear_;
    const DMat3 cofactors{cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
    const DVec3 mapped = cofactors * n;
    return is_mirrored() ? -mapped : mapped;
}

std::optional<Transform> Transform::inverse() const {
    // Equilibrated by the largest entry, so that the determinant neither over- nor underflows for
    // scales that are representable.
    double largest = 0.0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            largest = std::max(largest, std::fabs(linear_[column][row]));
        }
    }
    if (!(largest > 0.0) || !std::isfinite(largest)) return std::nullopt;
    const DMat3 unit = linear_ / largest;
    const double determinant = glm::determinant(unit);
    if (determinant == 0.0 || !std::isfinite(determinant)) return std::nullopt;
    Transform result;
    result.linear_ = glm::inverse(unit) / largest;
    result.offset_ = -(result.linear_ * offset_);
    result.scale_ = 1.0 / scale_;
    result.is_similarity_ = is_similarity_;
    if (!result.is_finite()) return std::nullopt;
    return result;
}

double Transform::similarity_scale() const {
    LRAY_ASSERT(is_similarity_);
    return scale_;
}

bool Transform::is_mirrored() const {
    return glm::determinant(linear_) < 0.0;
}

bool Transform::is_finite() const {
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            if (!std::isfinite(linear_[column][row])) return false;
        }
    }
    return std::isfinite(offset_.x) && std::isfinite(offset_.y) && std::isfinite(offset_.z);
}

}  // namespace lray
