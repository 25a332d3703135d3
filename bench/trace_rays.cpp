#include "bench/trace_rays.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/portable_math.h"
#include "base/random.h"

namespace lray::bench {

namespace {

/// How far rays begin off what they leave, in parts of the farthest coordinate of a hit: beyond the
/// errors of either side, so that both see the same.
constexpr double kOffset = 1e-5;

/// Returns every other bit of a Morton code: its column; of `code >> 1`, its row.
int every_other_bit(int code) {
    return (code & 1) | (code >> 1 & 2) | (code >> 2 & 4);
}

/// Where a ray leaves a surface again.
struct Departure {
    DVec3 origin{};
    DVec3 normal{};  // unit, on the side of the ray that came
};

std::optional<Departure> departure(const Ray& ray, const bvh::Hit& found) {
    if (found.is_none()) return std::nullopt;
    const DVec3 dir{ray.dir};
    DVec3 normal = glm::normalize(DVec3{found.normal});
    if (dot(normal, dir) > 0.0) normal = -normal;
    const DVec3 p = DVec3{ray.origin} + static_cast<double>(found.t) * dir;
    const double reach = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    return Departure{p + kOffset * reach * normal, normal};
}

/// Returns a unit vector across a unit vector.
DVec3 across(DVec3 n) {
    return glm::normalize(std::fabs(n.x) < 0.5 ? DVec3{0.0, n.z, -n.y} : DVec3{-n.z, 0.0, n.x});
}

}  // namespace

RaySet primary_rays(const TraceScene& scene, int width) {
    const DVec3 eye{scene.eye};
    const DVec3 ahead = glm::normalize(DVec3{scene.target} - eye);
    const DVec3 right = glm::normalize(cross(ahead, DVec3{0.0, 1.0, 0.0}));
    const DVec3 up = cross(right, ahead);
    RaySet result{"primary", false, {}, {}};
    for (int y = 0; y < width; y += kTileWidth) {
        for (int x = 0; x < width; x += kTileWidth) {
            for (int i = 0; i < kTileWidth * kTileWidth; ++i) {
                const double column = (x + every_other_bit(i) + 0.5) / width - 0.5;
                const double row = 0.5 - (y + every_other_bit(i >> 1) + 0.5) / width;
                const DVec3 dir = ahead + scene.view_width * (column * right + row * up);
                result.rays.push_back({scene.eye, Vec3{glm::normalize(dir)}});
            }
        }
    }
    result.intervals.resize(result.size());
    return result;
}

RaySet shadow_rays(const TraceScene& scene, const RaySet& primary, std::span<const bvh::Hit> hits) {
    RaySet result{"shadow", true, {}, {}};
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const auto from = departure(primary.rays[i], hits[i]);
        if (!from) continue;
        const DVec3 to_light = DVec3{scene.light} - from->origin;
        const double distance = glm::length(to_light);
        result.rays.push_back({Vec3{from->origin}, Vec3{to_light / distance}});
        result.intervals.push_back({0.0f, static_cast<float>(distance)});
    }
    return result;
}

RaySet bounce_rays(const RaySet& primary, std::span<const bvh::Hit> hits) {
    RaySet result{"bounce", false, {}, {}};
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const auto from = departure(primary.rays[i], hits[i]);
        if (!from) continue;
        const KeyedRandom random = KeyedRandom{}.with("bounce").with_bits(i);
        // Source: Malley's method; Pharr, Jakob, Humphreys 2023, 4th ed., sec. A.5.3.
        const double squared = random.with_bits(0).number();
        const DVec2 disk = std::sqrt(squared) * unit_circle_point(random.with_bits(1).number());
        const DVec3 side = across(from->normal);
        const DVec3 dir = disk.x * side + disk.y * cross(from->normal, side) +
                          std::sqrt(1.0 - squared) * from->normal;
        result.rays.push_back({Vec3{from->origin}, Vec3{glm::normalize(dir)}});
    }
    result.intervals.resize(result.size());
    return result;
}

}  // namespace lray::bench
