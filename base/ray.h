// Rays and the stretch of a ray that is looked at.
#pragma once

#include "base/numerics.h"
#include "base/vec.h"

namespace lray {

/// A half line. `dir` is unit in world space, so that `t` is a distance. In object space it keeps
/// the length the transform gives it, so that `t` stays the world's.
struct Ray {
    Vec3 origin{};
    Vec3 dir{};
};

/// The open interval (lo, hi) in which hits count: neither end belongs to it.
struct Interval {
    float lo = 0.0f;
    float hi = kInfinity;

    bool is_empty() const { return !(lo < hi); }
    bool contains(float t) const { return t > lo && t < hi; }  // false for NaN
};

}  // namespace lray
