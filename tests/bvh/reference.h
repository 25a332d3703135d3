// An independent intersector in long double, written for clarity: what the kernels are held to.
#pragma once

#include <optional>
#include <vector>

#include "base/ray.h"
#include "scene/world.h"

namespace lray::bvh {

using Long = long double;
using LVec3 = glm::vec<3, Long>;
using LMat3 = glm::mat<3, 3, Long>;

/// Returns every t, negative ones too, at which the line meets the primitive, ascending.
std::vector<Long> reference_crossings(const scene::World& world, scene::PrimitiveId id,
                                      const Ray& ray);

struct ReferenceHit {
    Long t = 0;
    scene::PrimitiveId id{};
};

/// Returns the nearest crossing in the open interval over all primitives.
std::optional<ReferenceHit> reference_nearest(const scene::World& world, const Ray& ray,
                                              Interval interval);

/// Returns the ids of all primitives, ascending.
std::vector<scene::PrimitiveId> all_ids(const scene::World& world);

}  // namespace lray::bvh
