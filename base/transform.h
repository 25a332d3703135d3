// Affine maps in double precision. What a map is known to preserve is carried along by the kinds
// of steps it was made of, never guessed from its numbers.
#pragma once

#include <optional>

#include "base/vec.h"

namespace lray {

/// An affine map p -> linear * p + offset, read as `a_from_b`. Default: the identity.
class Transform {
 public:
    Transform() = default;

    static Transform translation(DVec3 offset);

    /// Counter-clockwise seen from the tip of the axis. `axis` need not be unit; it must not be 0.
    static Transform rotation(DVec3 axis, double angle_degrees);
    static Transform rotation_x(double angle_degrees);
    static Transform rotation_y(double angle_degrees);
    static Transform rotation_z(double angle_degrees);

    /// A uniform scale is a similarity; factors may be negative.
    static Transform scaling(double factor);
    static Transform scaling(DVec3 factors);

    /// Columns of `linear` are the images of the axes. Never counted as a similarity.
    static Transform affine(const DMat3& linear, DVec3 offset);

    /// A map that is known to be a similarity which multiplies lengths by `scale`.
    /// Errors: empty when `linear` is none, by more than kSimilarityTolerance of the scale.
    static std::optional<Transform> similarity(const DMat3& linear, DVec3 offset, double scale);

    /// Far above what millions of steps gather in rounding errors, far below what is seen.
    static constexpr double kSimilarityTolerance = 1e-6;

    /// Returns the map that does this one first and `next` after it.
    Transform then(const Transform& next) const;

    DVec3 point(DVec3 p) const { return linear_ * p + offset_; }
    DVec3 vector(DVec3 v) const { return linear_ * v; }

    /// Maps a normal by the inverse transpose, up to a positive factor: it points to the same side
    /// of the surface as before, also under a mirroring. Not unit.
    DVec3 normal(DVec3 n) const;

    /// Returns the inverse; empty when the map is singular, when rounding alone could make it so,
    /// or when its inverse is not finite.
    std::optional<Transform> inverse() const;

    /// Made of translations, rotations and uniform scales alone: a sphere stays a sphere.
    bool is_similarity() const { return is_similarity_; }

    /// The uniform scale's magnitude. Asserts is_similarity().
    double similarity_scale() const;

    /// True if orientation is reversed (negative determinant).
    bool is_mirrored() const;

    bool is_finite() const;

    const DMat3& linear() const { return linear_; }
    DVec3 offset() const { return offset_; }

 private:
    DMat3 linear_{1.0};
    DVec3 offset_{0.0};
    double scale_ = 1.0;
    bool is_similarity_ = true;
};

}  // namespace lray
