#include "bvh/accel.h"

#include "base/assert.h"

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

BoundingVolumes Accel::volumes(std::uint32_t /*level*/, std::size_t /*max_count*/) const {
    return {};
}

}  // namespace lray::bvh
