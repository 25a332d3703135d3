// How much light gets from a surface to a light.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "base/numerics.h"
#include "base/ray.h"
#include "base/vec.h"
#include "bvh/accel.h"
#include "shade/transport/lit_world.h"

namespace lray::shade {

/// The share of the way that is not looked at before a light: what it lies on, a rounding before
/// it, does not hide it.
inline constexpr float kBeforeLight = 0x1p-13f;
/// Roundings of coordinates by which a light may be behind the surface it lies on.
inline constexpr int kCoordinateRoundings = 8;

/// Returns the stretch of a ray to a light in which things cast shadows: it ends a little before a
/// light at that distance, which may lie on a surface and is a rounding away from it.
inline Interval shadow_interval(const Ray& ray, float distance) {
    if (distance == kInfinity) return {};
    const auto reach = [&](float origin, float dir) {
        return std::max(std::fabs(origin), std::fabs(origin + distance * dir));
    };
    const float farthest =
        std::max(reach(ray.origin.x, ray.dir.x),
                 std::max(reach(ray.origin.y, ray.dir.y), reach(ray.origin.z, ray.dir.z)));
    return {0.0f, distance - distance * kBeforeLight - gamma(kCoordinateRoundings) * farthest};
}

/// What lets light through on its way: nothing, holes alone (opacity), or `transmit` as well.
enum class ShadowKind : std::uint8_t { opaque, through_holes, coloured };

/// Returns how exact shadows in a world have to be.
ShadowKind shadow_kind(const LitWorld& lit, bool transparent_shadows);

/// Finds what share of light comes along each ray of its interval: 1 if nothing that casts a shadow
/// is in the way, 0 behind what is opaque. What is met of blockers that let light through counts
/// once each: its holes and (coloured) `transmit` times its absorption along the way inside.
/// Shape: all of the same length, at most kMaxWaveSize.
void find_light_shares(const LitWorld& lit, ShadowKind kind, std::span<const Ray> rays,
                       std::span<const Interval> intervals, std::span<Color> shares,
                       bvh::TraceCounts& counts);

}  // namespace lray::shade
