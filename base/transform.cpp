#include "base/transform.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/assert.h"
#include "base/numerics.h"

namespace lray {
namespace {

/// Returns the largest magnitude in a column or matrix, +0 for none; NaN entries are passed over.
double largest_entry(const DVec3& v) {
    return std::max(std::fabs(v.x), std::max(std::fabs(v.y), std::fabs(v.z)));
}
double largest_entry(const DMat3& m) {
    return std::max(largest_entry(m[0]), std::max(largest_entry(m[1]), largest_entry(m[2])));
}

/// Returns the matrix divided by its largest entry, a positive factor, so that products of its
/// entries do not overflow; the zero matrix as it is.
DMat3 equilibrated(const DMat3& m) {
    const double largest = largest_entry(m);
    return largest > 0.0 && std::isfinite(largest) ? m / largest : m;
}

/// Columns are those of det(m) * inverse(transpose(m)).
DMat3 cofactors(const DMat3& m) {
    return {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
}

}  // namespace

Transform Transform::translation(DVec3 offset) {
    Transform result;
    result.offset_ = offset;
    return result;
}

Transform Transform::rotation(DVec3 axis, double angle_degrees) {
    // Rodrigues' formula. Scaling by the largest component first keeps the length finite. The
    // diagonal is written so that a turn about a coordinate axis leaves that axis exactly alone.
    const double largest = largest_entry(axis);
    LRAY_ASSERT(largest > 0.0);
    const DVec3 u = glm::normalize(axis / largest);
    const double c = cos_degrees(angle_degrees);
    const double s = sin_degrees(angle_degrees);
    const double k = 1.0 - c;
    const DVec3 uu = u * u;
    const DVec3 diagonal = uu + (1.0 - uu) * c;
    Transform result;
    result.linear_[0] = DVec3{diagonal.x, u.y * u.x * k + u.z * s, u.z * u.x * k - u.y * s};
    result.linear_[1] = DVec3{u.x * u.y * k - u.z * s, diagonal.y, u.z * u.y * k + u.x * s};
    result.linear_[2] = DVec3{u.x * u.z * k + u.y * s, u.y * u.z * k - u.x * s, diagonal.z};
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

std::optional<Transform> Transform::similarity(const DMat3& linear, DVec3 offset, double scale) {
    if (!(scale > 0.0) || !std::isfinite(scale)) return std::nullopt;
    const DMat3 unit = linear / scale;
    const DMat3 gram = glm::transpose(unit) * unit;  // the identity, of a rotation or mirroring
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            const double error = std::fabs(gram[column][row] - (row == column ? 1.0 : 0.0));
            if (!(error <= kSimilarityTolerance)) return std::nullopt;  // NaN too
        }
    }
    Transform result;
    result.linear_ = linear;
    result.offset_ = offset;
    result.scale_ = scale;
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
    const DVec3 mapped = cofactors(equilibrated(linear_)) * n;
    return is_mirrored() ? -mapped : mapped;
}

std::optional<Transform> Transform::inverse() const {
    // Each column is divided by its largest entry, linear = unit * diagonal(sizes), so that the
    // determinant neither over- nor underflows, however different the scales along the axes.
    DVec3 sizes{0.0};
    DMat3 unit{1.0};
    for (int column = 0; column < 3; ++column) {
        sizes[column] = largest_entry(linear_[column]);
        if (!(sizes[column] > 0.0) || !std::isfinite(sizes[column])) return std::nullopt;
        unit[column] = linear_[column] / sizes[column];
    }
    const DMat3 cofactor = cofactors(unit);
    const double determinant = dot(unit[0], cofactor[0]);
    // A determinant within its own rounding error may as well be 0. Eight roundings: the three
    // quotients in a product, its two multiplications, a difference and two sums.
    const DMat3 magnitude{glm::abs(unit[0]), glm::abs(unit[1]), glm::abs(unit[2])};
    const DVec3 a = magnitude[1];
    const DVec3 b = magnitude[2];
    const double permanent = dot(
        magnitude[0], DVec3{a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x});
    if (!(std::fabs(determinant) > gamma<double>(8) * permanent)) return std::nullopt;
    Transform result;
    result.linear_ = glm::transpose(cofactor) / determinant;
    for (int column = 0; column < 3; ++column) result.linear_[column] /= sizes;
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
    return glm::determinant(equilibrated(linear_)) < 0.0;
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
