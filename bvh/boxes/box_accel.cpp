#include "bvh/boxes/box_accel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "base/assert.h"
#include "bvh/boxes/part_walk.h"

namespace lray::bvh {

namespace {

BoxPart make_part(const scene::Geometry& geometry, BuildQuality quality) {
    return {&geometry, build_box_tree(geometry, quality),
            std::ranges::all_of(geometry.objects, &scene::Object::casts_shadow)};
}

/// Rays of a tile on their way through the world's own tree.
class TileWalk {
 public:
    /// Takes up to kMaxTileRays rays. Their walks have yet to seek something.
    TileWalk(const BoxParts& parts, std::span<const Ray> rays, std::span<const Interval> intervals,
             TraceCounts& counts)
        : count_(static_cast<std::uint32_t>(rays.size())), counts_(counts) {
        LRAY_DCHECK(rays.size() <= kMaxTileRays);
        counts.rays += rays.size();
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (!is_traceable(rays[i])) continue;
            prepared_[i] = prepare(rays[i]);
            walks_[i].emplace(parts, parts.world, 0, prepared_[i], intervals[i], counts);
        }
    }

    std::uint32_t count() const { return count_; }

    /// The walk of a ray; null if that is not traceable.
    PartWalk* walk(std::uint32_t ray) { return walks_[ray] ? &*walks_[ray] : nullptr; }

    /// Sets the tile up with the rays that are in `active`. Returns false if they do not run the
    /// same way on all axes: then they do not walk together.
    bool gather(std::uint64_t active) {
        const Walk* first = nullptr;
        tile_.active = active;
        tile_.node_tests = 0;
        for (std::uint32_t i = 0; i < count_; ++i) {
            if ((active >> i & 1) == 0) continue;
            if (first == nullptr) first = &*walks_[i];
            if (!std::ranges::equal(walks_[i]->ray->near_side, first->ray->near_side)) return false;
        }
        if (first == nullptr) return true;
        std::ranges::copy(first->ray->near_side, tile_.near_side);
        for (std::uint32_t i = 0; i < kMaxTileRays; ++i) {
            const bool is_active = (active >> i & 1) != 0;
            put(i, is_active ? *walks_[i] : *first);
            tile_.walks[i] = is_active ? &*walks_[i] : nullptr;
            if (!is_active) tile_.reach[i] = -kInfinity;
        }
        return true;
    }

    Tile& tile() { return tile_; }

    void add_counts() {
        counts_.node_tests += tile_.node_tests;
        for (const std::optional<PartWalk>& walk : walks_) {
            if (walk) walk->add_counts();
        }
    }

 private:
    void put(std::uint32_t ray, const Walk& walk) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            tile_.origin_near[axis][ray] = walk.ray->origin_near[axis];
            tile_.origin_far[axis][ray] = walk.ray->origin_far[axis];
            tile_.inv_dir[axis][ray] = walk.ray->inv_dir[axis];
            tile_.inv_dir_far[axis][ray] = walk.ray->inv_dir_far[axis];
        }
        tile_.lo[ray] = walk.lo;
        tile_.reach[ray] = walk.reach;
    }

    std::uint32_t count_ = 0;
    TraceCounts& counts_;
    std::array<PreparedRay, kMaxTileRays> prepared_{};
    std::array<std::optional<PartWalk>, kMaxTileRays> walks_{};
    Tile tile_{};
};

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
            nearest_of_tile(rays.subspan(i, count), intervals.subspan(i, count),
                            hits.subspan(i, count), counts);
        }
    }

    void any_hits(std::span<const Ray> rays, std::span<const Interval> intervals,
                  std::span<bool> are_hit, TraceCounts& counts) const override {
        LRAY_DCHECK(intervals.size() == rays.size() && are_hit.size() == rays.size());
        for (std::size_t i = 0; i < rays.size(); i += kMaxTileRays) {
            const std::size_t count = std::min<std::size_t>(kMaxTileRays, rays.size() - i);
            any_of_tile(rays.subspan(i, count), intervals.subspan(i, count),
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

 private:
    void nearest_of_tile(std::span<const Ray> rays, std::span<const Interval> intervals,
                         std::span<Hit> hits, TraceCounts& counts) const {
        TileWalk tile(parts_, rays, intervals, counts);
        std::uint64_t active = 0;
        for (std::uint32_t i = 0; i < tile.count(); ++i) {
            hits[i] = {};
            if (PartWalk* const walk = tile.walk(i)) {
                walk->seek_nearest(hits[i]);
                active |= std::uint64_t{1} << i;
            }
        }
        if (tile.gather(active)) {
            parts_.walks.nearest_tile(parts_.world.tree.view, tile.tile());
        } else {
            for (std::uint32_t i = 0; i < tile.count(); ++i) {
                if (PartWalk* const walk = tile.walk(i)) {
                    parts_.walks.nearest(parts_.world.tree.view, *walk);
                }
            }
        }
        tile.add_counts();
    }

    void any_of_tile(std::span<const Ray> rays, std::span<const Interval> intervals,
                     std::span<bool> are_hit, TraceCounts& counts) const {
        TileWalk tile(parts_, rays, intervals, counts);
        std::uint64_t active = 0;
        for (std::uint32_t i = 0; i < tile.count(); ++i) {
            PartWalk* const walk = tile.walk(i);
            are_hit[i] = walk != nullptr && walk->seek_any();
            if (walk != nullptr && !are_hit[i]) active |= std::uint64_t{1} << i;
        }
        const bool is_together = tile.gather(active);
        if (is_together) parts_.walks.any_tile(parts_.world.tree.view, tile.tile());
        for (std::uint32_t i = 0; i < tile.count(); ++i) {
            if ((active >> i & 1) == 0) continue;
            are_hit[i] = is_together ? (tile.tile().active >> i & 1) == 0
                                     : parts_.walks.any(parts_.world.tree.view, *tile.walk(i));
        }
        tile.add_counts();
    }

    BoxParts parts_;
};

}  // namespace

std::unique_ptr<Accel> make_box_accel(const scene::World& world, BuildQuality quality,
                                      const Walks& walks) {
    return std::make_unique<BoxAccel>(world, quality, walks);
}

}  // namespace lray::bvh
