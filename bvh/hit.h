// What a ray finds, and which of two finds counts.
#pragma once

#include "base/numerics.h"
#include "base/ray.h"
#include "scene/world.h"

namespace lray::bvh {

/// t is +infinity and the id none when nothing was hit. u and v are the primitive's own surface
/// parameters (docstring of each kernel). `normal` is the geometric normal of triangles and
/// rectangles, as long as twice the area of the triangle met, in the space of the geometry that
/// holds the primitive; 0 of other kinds, whose normal surface_at() works out.
struct Hit {
    float t = kInfinity;
    float u = 0.0f;
    float v = 0.0f;
    scene::PrimitiveId primitive_id{};
    scene::PlaceOffset place = 0;  // of the geometry that holds the primitive
    Vec3 normal{0.0f};

    bool is_none() const { return primitive_id.is_none(); }
};

/// The rule for ties: the lesser t wins, at equal t the lesser place, there the lesser primitive
/// id. It does not depend on the order in which primitives are tested, so every hierarchy finds the
/// same hit.
inline bool is_closer(float t, scene::PlaceOffset place, scene::PrimitiveId id, const Hit& than) {
    if (t != than.t) return t < than.t;
    if (place != than.place) return place < than.place;
    return id < than.primitive_id;
}

inline bool is_closer(const Hit& a, const Hit& b) {
    return is_closer(a.t, a.place, a.primitive_id, b);
}

/// Returns what of an interval may still hold a closer hit: up to and including the best t, where
/// the lesser place and id win.
inline Interval up_to(const Hit& best, Interval interval) {
    if (best.is_none()) return interval;
    const float hi = next_up(best.t);
    return {interval.lo, hi < interval.hi ? hi : interval.hi};
}

}  // namespace lray::bvh
