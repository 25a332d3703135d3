// What an intersection kernel returns, and how the crossings of the kinds that are solved in
// double become a hit.
#pragma once

#include <array>

#include "base/ray.h"

namespace lray::bvh {

/// A hit of a known primitive; t is +infinity when there is none (no interval contains that).
struct KernelHit {
    float t = kInfinity;
    float u = 0.0f;
    float v = 0.0f;
    Vec3 normal{0.0f};  // of triangles and rectangles: Hit::normal

    bool is_none() const { return !(t < kInfinity); }
};

/// A place where a ray crosses a surface, before t is rounded. `part` says which surface of the
/// primitive it is (docstring of each kernel).
struct Crossing {
    double t = 0.0;
    int part = 0;
};

/// At most two crossings: every kind but the triangles is convex or flat. Ascending in t.
struct Crossings {
    std::array<Crossing, 2> values{};
    int count = 0;

    void add(double t, int part = 0) {
        values[static_cast<std::size_t>(count)] = {t, part};
        ++count;
    }
};

/// Returns the first crossing whose t, rounded to float, lies in the open interval; u is its part.
/// A t of NaN is no hit.
inline KernelHit first_in(const Crossings& crossings, Interval interval) {
    for (int i = 0; i < crossings.count; ++i) {
        const Crossing& crossing = crossings.values[static_cast<std::size_t>(i)];
        const float t = static_cast<float>(crossing.t);
        if (interval.contains(t)) return {.t = t, .u = static_cast<float>(crossing.part)};
    }
    return {};
}

}  // namespace lray::bvh
