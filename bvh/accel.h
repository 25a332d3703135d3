// The interface of every hierarchy: World -> nearest hit, any hit.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "base/ray.h"
#include "bvh/bounding_volume.h"
#include "bvh/hit.h"
#include "scene/world.h"

namespace lray::bvh {

enum class AccelKind : std::uint8_t { none, spheres, boxes };

/// How long a build may take for what it saves in tracing: `high` also cuts primitives that lie in
/// each other's way in two. Only boxes have a choice.
enum class BuildQuality : std::uint8_t { low, medium, high };

struct BuildOptions {
    AccelKind kind = AccelKind::boxes;
    BuildQuality quality = BuildQuality::medium;
};

/// What tracing cost, added up per ray by whoever asks for it (--stats); and whether it shall end.
struct TraceCounts {
    std::uint64_t rays = 0;
    std::uint64_t node_tests = 0;       // nodes of a tree whose children were looked at
    std::uint64_t primitive_tests = 0;  // rays against primitives, those that missed included
    std::uint64_t instance_tests = 0;   // likewise, instances

    /// Looked at now and then. Once it is set nothing in instances is met any more, of which a ray
    /// may meet endlessly many: then `is_ended`, and what was found means nothing.
    const std::atomic<bool>* cancel = nullptr;
    bool is_ended = false;

    TraceCounts& operator+=(const TraceCounts& other) {
        rays += other.rays;
        node_tests += other.node_tests;
        primitive_tests += other.primitive_tests;
        instance_tests += other.instance_tests;
        is_ended |= other.is_ended;
        return *this;
    }
};

/// What was built, of the world and of all prototypes together.
struct AccelStats {
    std::uint64_t nodes = 0;
    std::uint64_t leaves = 0;
    std::uint64_t references = 0;  // primitives in leaves, as often as they are in one
    std::uint32_t depth = 0;       // nodes on the longest path of any one tree
    double cost = 0.0;             // of the world's tree, by the measure it was built with
    std::size_t bytes = 0;         // kept for tracing, beside the World
};

/// A built hierarchy. It refers to the World, which must outlive it. Const calls are thread-safe.
/// Intervals begin at 0 or later: nothing behind a ray's origin is looked for.
class Accel {
 public:
    virtual ~Accel() = default;

    /// Returns the hit with the least (t, place, primitive id) in the open interval; none for a ray
    /// that is not traceable.
    virtual Hit nearest_hit(const Ray& ray, Interval interval, TraceCounts& counts) const = 0;

    /// True if anything that casts a shadow is hit in the open interval.
    virtual bool any_hit(const Ray& ray, Interval interval, TraceCounts& counts) const = 0;

    /// Finds the nearest hit of each ray, the same as one by one: for rays that run close together,
    /// as those of a tile of pixels do.
    /// Shape: all of the same length.
    virtual void nearest_hits(std::span<const Ray> rays, std::span<const Interval> intervals,
                              std::span<Hit> hits, TraceCounts& counts) const;

    /// Likewise, for shadow rays to one light.
    virtual void any_hits(std::span<const Ray> rays, std::span<const Interval> intervals,
                          std::span<bool> are_hit, TraceCounts& counts) const;

    virtual AccelStats stats() const = 0;

    /// Returns the cut at a level, 0 being the root; below the last level nothing changes. Where an
    /// instance stands, the tree of what it places goes on below the leaf. Of volumes that would be
    /// more than `max_count`, those above are left: the cut covers everything all the same.
    /// Space: world. None without a hierarchy.
    virtual BoundingVolumes volumes(std::uint32_t level, std::size_t max_count) const;
};

/// Builds a hierarchy over all visible primitives, on all cores of the task arena it is called in:
/// what is hidden is neither seen nor casts a shadow.
std::unique_ptr<Accel> build(const scene::World& world, const BuildOptions& options);

}  // namespace lray::bvh
