// The interface of every hierarchy: World -> nearest hit, any hit.
#pragma once

#include <cstdint>
#include <memory>

#include "base/ray.h"
#include "bvh/hit.h"
#include "scene/world.h"

namespace lray::bvh {

enum class AccelKind : std::uint8_t { none, spheres };

/// What tracing cost, added up per ray by whoever asks for it (--stats).
struct TraceCounts {
    std::uint64_t rays = 0;
    std::uint64_t node_tests = 0;       // nodes of a tree whose children were looked at
    std::uint64_t primitive_tests = 0;  // rays against primitives, those that missed included
    std::uint64_t instance_tests = 0;   // likewise, instances
};

/// A built hierarchy. It refers to the World, which must outlive it. Const calls are thread-safe.
class Accel {
 public:
    virtual ~Accel() = default;

    /// Returns the hit with the least (t, place, primitive id) in the open interval; none for a ray
    /// that is not traceable.
    virtual Hit nearest_hit(const Ray& ray, Interval interval, TraceCounts& counts) const = 0;

    /// True if anything that casts a shadow is hit in the open interval.
    virtual bool any_hit(const Ray& ray, Interval interval, TraceCounts& counts) const = 0;
};

/// Builds a hierarchy over all visible primitives: what is hidden is neither seen nor casts a
/// shadow.
std::unique_ptr<Accel> build(const scene::World& world, AccelKind kind);

}  // namespace lray::bvh
