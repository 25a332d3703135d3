#include "bvh/boxes/box_accel.h"

#include <algorithm>
#include <cstddef>

#include "base/assert.h"
#include "bvh/boxes/box_volumes.h"
#include "bvh/boxes/scalar_walk.h"
#include "bvh/boxes/tile_of_rays.h"

namespace lray::bvh {

namespace {

BoxPart make_part(const scene::Geometry& geometry, BuildQuality quality) {
    return {&geometry, build_box_tree(geometry, quality),
            std::ranges::all_of(geometry.objects, &scene::Object::casts_shadow)};
}

class BoxAccel final : public Accel {
 public:
    BoxAccel(const scene::World& world, BuildQuality quality, const Walks& walks) {
        parts_.walks = walks;
        parts_.world = make_part(world, quality);
        parts_.prototypes.reserve(world.prototypes.size());
        for (const scene::Geometry& prototype : world.prototypes) {
            parts_.prototypes.push_back(make_part(prototype, quality));
        }
    }

    Hit nearest_hit(const Ray& ray, Interval interval, TraceCounts& counts) const override {
        Hit best;
        ++counts.rays;
        if (is_traceable(ray)) {
            PreparedRay prepared = set_out(ray);
            find_nearest(parts_, parts_.world, 0, prepared, interval, best, counts);
        }
        return best;
    }

    bool any_hit(const Ray& ray, Interval interval, TraceCounts& counts) const override {
        ++counts.rays;
        if (!is_traceable(ray)) return false;
        PreparedRay prepared = set_out(ray);
        return find_any(parts_, parts_.world, prepared, interval, counts);
    }

    void nearest_hits(std::span<const Ray> rays, std::span<const Interval> intervals,
                      std::span<Hit> hits, TraceCounts& counts) const override {
        LRAY_DCHECK(intervals.size() == rays.size() && hits.size() == rays.size());
        for (std::size_t i = 0; i < rays.size(); i += kMaxTileRays) {
            const std::size_t count = std::min<std::size_t>(kMaxTileRays, rays.size() - i);
            find_nearest_of_tile(parts_, rays.subspan(i, count), intervals.subspan(i, count),
                                 hits.subspan(i, count), counts);
        }
    }

    void any_hits(std::span<const Ray> rays, std::span<const Interval> intervals,
                  std::span<bool> are_hit, TraceCounts& counts) const override {
        LRAY_DCHECK(intervals.size() == rays.size() && are_hit.size() == rays.size());
        for (std::size_t i = 0; i < rays.size(); i += kMaxTileRays) {
            const std::size_t count = std::min<std::size_t>(kMaxTileRays, rays.size() - i);
            find_any_of_tile(parts_, rays.subspan(i, count), intervals.subspan(i, count),
                             are_hit.subspan(i, count), counts);
        }
    }

    AccelStats stats() const override {
        AccelStats stats = parts_.world.tree.stats;
        stats.bytes += sizeof *this + parts_.prototypes.capacity() * sizeof(BoxPart);
        for (const BoxPart& part : parts_.prototypes) {
            stats.nodes += part.tree.stats.nodes;
            stats.leaves += part.tree.stats.leaves;
            stats.references += part.tree.stats.references;
            stats.depth = std::max(stats.depth, part.tree.stats.depth);
            stats.bytes += part.tree.stats.bytes;
        }
        return stats;
    }

    BoundingVolumes volumes(std::uint32_t level, std::size_t max_count) const override {
        return box_volumes(parts_, level_count_, level, max_count);
    }

 private:
    BoxParts parts_;
    LevelCount level_count_;
};

}  // namespace

Walks fastest_walks() {
    return simd_targets() != 0 ? simd_walks() : scalar_walks();
}

std::unique_ptr<Accel> make_box_accel(const scene::World& world, BuildQuality quality,
                                      const Walks& walks) {
    return std::make_unique<BoxAccel>(world, quality, walks);
}

}  // namespace lray::bvh
