// The direction halfway between two others, and mirroring at it.
#pragma once

#include "base/vec.h"

namespace lray::shade {

/// Returns a direction that is unit but for rounding to float with the length of 1 to 1e-14: half
/// vectors and mirror directions lean to the longer one of two otherwise.
/// A step of Newton's method for 1 / sqrt(w.w) at 1.
inline DVec3 exactly_unit(const Vec3& w) {
    const DVec3 v(w);
    return v * (1.5 - 0.5 * dot(v, v));
}

/// Mirrors wo at the unit half vector h.
inline Vec3 mirrored_at(Vec3 wo, DVec3 h) {
    const DVec3 v(wo);
    return Vec3(2.0 * dot(v, h) * h - v);
}

}  // namespace lray::shade
