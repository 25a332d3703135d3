#include "shade/transport/boundary.h"

#include <vector>

#include "scene/place.h"
#include "shade/transport/dielectric.h"

namespace lray::shade {

namespace {

constexpr float kIorOfSpace = 1.0f;
/// So many surfaces are looked at to find out what is around a point.
constexpr int kMaxCrossings = 1024;
/// In which direction: along nothing that is built, so that it grazes nothing.
constexpr Vec3 kWayOut{0.36514837f, 0.91287093f, 0.18257419f};  // (2, 5, 1) / sqrt(30)

float ior_in(const LitWorld& lit, std::uint32_t medium) {
    return medium == Media::kNone ? kIorOfSpace : lit.materials.average(medium).ior;
}

Vec3 mirror_direction(const ShadingPoint& point) {
    const Vec3 direction = mirrored(point.wo, point.normal);
    return point.is_before(direction) ? direction : mirrored(point.wo, point.facing());
}

}  // namespace

Boundary boundary_at(const LitWorld& lit, const TransportRay& ray, const ShadingPoint& point) {
    const MaterialPoint& material = point.material;
    Boundary boundary;
    boundary.mirror_weight = material.reflect;
    if (material.transmit != Color{0.0f}) {
        boundary.media_through = ray.media;
        float before = ior_in(lit, ray.media.innermost());
        if (point.is_outside) {
            boundary.media_through.enter(point.material_id);
        } else {
            if (!ray.media.contains(point.material_id)) before = material.ior;
            boundary.media_through.leave(point.material_id);
        }
        const float eta = ior_in(lit, boundary.media_through.innermost()) / before;
        const float reflectance = fresnel_reflectance(dot(point.normal, point.wo), eta);
        std::optional<Vec3> onward = refracted(point.wo, point.normal, eta);
        if (onward && point.is_before(*onward)) onward = refracted(point.wo, point.facing(), eta);
        const float mirrored_share = onward ? reflectance : 1.0f;
        boundary.mirror_weight += mirrored_share * material.transmit;
        boundary.through_weight = (1.0f - mirrored_share) * material.transmit;
        if (onward) boundary.through_direction = *onward;
    }
    if (boundary.mirror_weight != Color{0.0f}) boundary.mirror_direction = mirror_direction(point);
    return boundary;
}

Media media_at(const LitWorld& lit, Vec3 position, bvh::TraceCounts& counts) {
    Media media;
    if (!lit.materials.has_transmission()) return media;
    const Ray ray{position, kWayOut};
    Interval interval;
    std::vector<std::uint32_t> left;     // the innermost first
    std::vector<std::uint32_t> entered;  // on the way
    for (int crossing = 0; crossing < kMaxCrossings; ++crossing) {
        const bvh::Hit hit = lit.accel.nearest_hit(ray, interval, counts);
        if (hit.is_none() || counts.is_ended) break;
        interval.lo = hit.t;
        const std::uint32_t material = scene::material_at(lit.world, hit.place, hit.primitive_id);
        if (lit.materials.average(material).transmit == Color{0.0f}) continue;
        const bool is_entered = dot(bvh::surface_at(lit.world, ray, hit).normal, ray.dir) < 0.0f;
        const auto found = std::find(entered.rbegin(), entered.rend(), material);
        if (is_entered) {
            entered.push_back(material);
        } else if (found != entered.rend()) {
            entered.erase(std::next(found).base());
        } else {
            left.push_back(material);
        }
    }
    for (auto material = left.rbegin(); material != left.rend(); ++material) {
        media.enter(*material);
    }
    return media;
}

}  // namespace lray::shade
