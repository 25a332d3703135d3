#include "bvh/boxes/tile_of_rays.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <memory>
#include <type_traits>

#include "base/assert.h"
#include "bvh/slab.h"

namespace lray::bvh {

namespace {

/// A tile and the walks of those of its rays that come to a leaf. Nothing is set before it is
/// needed: most of it never is.
class TileOfRays : public Tile {
 public:
    TileOfRays(const BoxParts& parts, std::span<const Ray> rays,
               std::span<const Interval> intervals, TraceCounts& counts)
        : parts_(parts), rays_(rays), intervals_(intervals), counts_(counts) {
        LRAY_DCHECK(rays.size() <= kMaxTileRays);
        counts.rays += rays.size();
        active = 0;
        node_tests = 0;
        primitive_tests = 0;
        start = [](Tile& tile, std::uint32_t ray) -> Walk* {
            return static_cast<TileOfRays&>(tile).start_walk(ray);
        };
        std::ranges::fill(walks, nullptr);
        for (std::uint32_t i = 0; i < count(); ++i) {
            if (is_traceable(rays[i])) active |= bit(i);
        }
    }
    TileOfRays(const TileOfRays&) = delete;
    TileOfRays& operator=(const TileOfRays&) = delete;

    std::uint32_t count() const { return static_cast<std::uint32_t>(rays_.size()); }
    bool is_active(std::uint32_t ray) const { return (active & bit(ray)) != 0; }
    void leave_out(std::uint32_t ray) { active &= ~bit(ray); }

    /// Where walks to the nearest hit leave it; walks to any hit seek none.
    void seek_nearest(std::span<Hit> hits) { hits_ = hits; }

    /// The walk of a ray, made if there is none yet.
    PartWalk& walk(std::uint32_t ray) {
        if (walks[ray] == nullptr) walks[ray] = start_walk(ray);
        return static_cast<PartWalk&>(*walks[ray]);
    }

    /// Lays the active rays out for walking together.
    void lay_out() {
        const auto first = static_cast<std::uint32_t>(std::countr_zero(active));
        if (active == 0) return;
        const std::uint32_t end = (count() + kTileStep - 1) / kTileStep * kTileStep;
        for (std::uint32_t i = 0; i < end; ++i) {
            const bool is_ray = is_active(i);
            const std::uint32_t source = is_ray ? i : first;
            for (int axis = 0; axis < 3; ++axis) {
                origin[axis][i] = rays_[source].origin[axis];
                dir[axis][i] = rays_[source].dir[axis];
            }
            lo[i] = walk_begin(intervals_[source]);
            reach[i] = !is_ray               ? kNoReach
                       : walks[i] != nullptr ? walks[i]->reach
                                             : reach_of(intervals_[i].hi);
        }
    }

    void add_counts() {
        counts_.node_tests += node_tests;
        counts_.primitive_tests += primitive_tests;
        for (std::uint32_t i = 0; i < count(); ++i) {
            if (walks[i] != nullptr) static_cast<const PartWalk*>(walks[i])->add_counts();
        }
    }

 private:
    struct Started {
        PreparedRay prepared;
        PartWalk walk;

        Started(const BoxParts& parts, const Ray& ray, Interval interval, TraceCounts& counts)
            : prepared(set_out(ray)), walk(parts, parts.world, 0, prepared, interval, counts) {}
    };
    static_assert(std::is_trivially_destructible_v<Started>);

    static std::uint64_t bit(std::uint32_t ray) { return std::uint64_t{1} << ray; }

    PartWalk* start_walk(std::uint32_t ray) {
        auto* const place = reinterpret_cast<Started*>(memory_) + ray;
        Started* const started =
            std::construct_at(place, parts_, rays_[ray], intervals_[ray], counts_);
        if (hits_.empty()) {
            started->walk.seek_any();
        } else {
            started->walk.seek_nearest(hits_[ray]);
        }
        return &started->walk;
    }

    const BoxParts& parts_;
    std::span<const Ray> rays_;
    std::span<const Interval> intervals_;
    TraceCounts& counts_;
    std::span<Hit> hits_{};
    alignas(Started) std::byte memory_[kMaxTileRays * sizeof(Started)];
};

}  // namespace

void find_nearest_of_tile(const BoxParts& parts, std::span<const Ray> rays,
                          std::span<const Interval> intervals, std::span<Hit> hits,
                          TraceCounts& counts) {
    TileOfRays tile(parts, rays, intervals, counts);
    tile.seek_nearest(hits);
    std::ranges::fill(hits, Hit{});
    const BoxTree& tree = parts.world.tree;
    for (std::uint32_t i = 0; i < tile.count() && !tree.planes.empty(); ++i) {
        if (tile.is_active(i)) tile.walk(i).meet_planes();
    }
    tile.lay_out();
    if (!parts.walks.nearest_tile(tree.view, tile)) {
        for (std::uint32_t i = 0; i < tile.count(); ++i) {
            if (tile.is_active(i)) parts.walks.nearest(tree.view, tile.walk(i));
        }
    }
    tile.add_counts();
}

void find_any_of_tile(const BoxParts& parts, std::span<const Ray> rays,
                      std::span<const Interval> intervals, std::span<bool> are_hit,
                      TraceCounts& counts) {
    TileOfRays tile(parts, rays, intervals, counts);
    std::ranges::fill(are_hit, false);
    const BoxTree& tree = parts.world.tree;
    const std::uint64_t traced = tile.active;
    for (std::uint32_t i = 0; i < tile.count() && !tree.planes.empty(); ++i) {
        if (tile.is_active(i) && tile.walk(i).meets_plane()) tile.leave_out(i);
    }
    tile.lay_out();
    if (!parts.walks.any_tile(tree.view, tile)) {
        for (std::uint32_t i = 0; i < tile.count(); ++i) {
            if (tile.is_active(i) && parts.walks.any(tree.view, tile.walk(i))) tile.leave_out(i);
        }
    }
    for (std::uint32_t i = 0; i < tile.count(); ++i) {
        are_hit[i] = (traced >> i & 1) != 0 && !tile.is_active(i);
    }
    tile.add_counts();
}

}  // namespace lray::bvh
