#include "base/assert.h"
#include "bvh/accel.h"
#include "bvh/boxes/box_accel.h"
#include "bvh/brute_force.h"
#include "bvh/spheres/sphere_accel.h"

namespace lray::bvh {

void Accel::nearest_hits(std::span<const Ray> rays, std::span<const Interval> intervals,
                         std::span<Hit> hits, TraceCounts& counts) const {
    LRAY_DCHECK(intervals.size() == rays.size() && hits.size() == rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits[i] = nearest_hit(rays[i], intervals[i], counts);
    }
}

void Accel::any_hits(std::span<const Ray> rays, std::span<const Interval> intervals,
                     std::span<bool> are_hit, TraceCounts& counts) const {
    LRAY_DCHECK(intervals.size() == rays.size() && are_hit.size() == rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        are_hit[i] = any_hit(rays[i], intervals[i], counts);
    }
}

std::unique_ptr<Accel> build(const scene::World& world, const BuildOptions& options) {
    switch (options.kind) {
        case AccelKind::none:
            return make_brute_force(world);
        case AccelKind::spheres:
            return make_sphere_accel(world);
        case AccelKind::boxes:
            return make_box_accel(world, options.quality, fastest_walks());
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::bvh
