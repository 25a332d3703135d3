#include "shade/transport/shadow.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/assert.h"
#include "scene/place.h"
#include "shade/transport/absorption.h"
#include "shade/transport/shading_point.h"
#include "shade/transport/wave_size.h"

namespace lray::shade {

namespace {

bool casts_shadow(const scene::World& world, const bvh::Hit& hit) {
    const scene::PlacePath path = scene::path_to(world, hit.place);
    const scene::Geometry& geometry = *path.geometry;
    return geometry.object(geometry.object_of(hit.primitive_id)).casts_shadow &&
           std::ranges::all_of(path.steps,
                               [](const auto& step) { return step.object->casts_shadow; });
}

/// What is around the shadow ray: where it entered what it is inside of.
struct Inside {
    std::array<std::uint32_t, Media::kMaxCount> materials{};
    std::array<float, Media::kMaxCount> entries{};
    std::size_t count = 0;

    void enter(std::uint32_t material, float t) {
        if (count == materials.size()) return;
        materials[count] = material;
        entries[count++] = t;
    }
    /// Returns where the medium that is left began: at the ray's origin if it never entered it.
    float leave(std::uint32_t material) {
        for (std::size_t i = count; i-- > 0;) {
            if (materials[i] != material) continue;
            const float entry = entries[i];
            materials[i] = materials[count - 1];
            entries[i] = entries[--count];
            return entry;
        }
        return 0.0f;
    }
};

/// Follows one ray through all blockers, nearest first, so that each counts once and in order.
Color light_share(const LitWorld& lit, ShadowKind kind, const Ray& ray, Interval interval,
                  bvh::TraceCounts& counts) {
    Color share{1.0f};
    Inside inside;
    while (share != Color{0.0f}) {
        const bvh::Hit hit = lit.accel.nearest_hit(ray, interval, counts);
        if (hit.is_none() || counts.is_ended) return share;
        interval.lo = hit.t;
        if (!casts_shadow(lit.world, hit)) continue;
        const ShadingPoint point = shading_point(lit, {.ray = ray}, hit);
        const MaterialPoint& material = point.material;
        const bool is_clear = kind == ShadowKind::coloured;
        share *= (1.0f - material.opacity) +
                 material.opacity * (is_clear ? material.transmit : Color{0.0f});
        if (!is_clear || material.absorption == Color{0.0f}) continue;
        if (point.is_outside) {
            inside.enter(point.material_id, hit.t);
        } else {
            share *= transmittance(material.absorption, hit.t - inside.leave(point.material_id));
        }
    }
    return share;
}

}  // namespace

ShadowKind shadow_kind(const LitWorld& lit, bool transparent_shadows) {
    if (transparent_shadows && lit.materials.has_transmission()) return ShadowKind::coloured;
    return lit.materials.has_cut_outs() ? ShadowKind::through_holes : ShadowKind::opaque;
}

void find_light_shares(const LitWorld& lit, ShadowKind kind, std::span<const Ray> rays,
                       std::span<const Interval> intervals, std::span<Color> shares,
                       bvh::TraceCounts& counts) {
    LRAY_DCHECK(rays.size() <= kMaxWaveSize);
    std::array<bool, kMaxWaveSize> are_hit;
    const std::span hits = std::span(are_hit).first(rays.size());
    lit.accel.any_hits(rays, intervals, hits, counts);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i]) {
            shares[i] = Color{1.0f};
        } else if (kind == ShadowKind::opaque) {
            shares[i] = Color{0.0f};
        } else {
            shares[i] = light_share(lit, kind, rays[i], intervals[i], counts);
        }
    }
}

}  // namespace lray::shade
