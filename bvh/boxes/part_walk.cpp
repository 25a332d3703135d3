#include "bvh/boxes/part_walk.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "bvh/instance_ray.h"
#include "bvh/intersect.h"
#include "bvh/kernels/sphere.h"
#include "bvh/kernels/triangle.h"

namespace lray::bvh {

namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;

Hit meet(const PartWalk& walk, PrimitiveId id) {
    Hit hit = intersect(walk.geometry(), id, walk.prepared(), walk.interval);
    hit.place = walk.place;
    return hit;
}

/// The block has the very floats of the World, and is at hand.
Hit meet(const PartWalk& walk, const SphereBlock& block, std::uint32_t lane) {
    const scene::Sphere sphere{
        {block.center[0][lane], block.center[1][lane], block.center[2][lane]}, block.radius[lane]};
    const KernelHit hit = first_in(crossings(sphere, walk.prepared()), walk.interval);
    if (hit.is_none()) return {};
    return {hit.t, hit.u, hit.v, PrimitiveId::of_value(block.ids[lane]), walk.place, hit.normal};
}

EdgeAreas<float> areas_of(const TriangleFinds& finds, std::uint32_t lane) {
    return {finds.area_a[lane], finds.area_b[lane], finds.area_c[lane]};
}

/// True of a triangle that is hit at the t of its plane, where its areas say.
bool is_plain(const TriangleBlock& block, std::uint32_t lane, const TriangleFinds& finds) {
    const EdgeAreas<float> areas = areas_of(finds, lane);
    return PrimitiveId::of_value(block.ids[lane]).kind() == PrimitiveKind::triangle &&
           (finds.grazing >> lane & 1) == 0 && are_sure(areas, areas.a + areas.b + areas.c);
}

/// Returns the hit of any other, which intersect() would work out again.
[[gnu::noinline]] Hit meet(const PartWalk& walk, const TriangleBlock& block, std::uint32_t lane,
                           const TriangleFinds& finds) {
    const PrimitiveId id = PrimitiveId::of_value(block.ids[lane]);
    if (id.kind() != PrimitiveKind::triangle) return meet(walk, id);
    const PlaneHit plane{
        finds.t[lane],
        (finds.grazing >> lane & 1) != 0,
        {finds.normal[0][lane], finds.normal[1][lane], finds.normal[2][lane]},
    };
    KernelHit hit;
    const bool is_hit = finish_triangle(corner_of(block, 0, lane), corner_of(block, 1, lane),
                                        corner_of(block, 2, lane), areas_of(finds, lane), plane,
                                        walk.prepared(), walk.interval, hit);
    return is_hit ? Hit{hit.t, hit.u, hit.v, id, walk.place, hit.normal} : Hit{};
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as instances nest
void nearest_in(PartWalk& walk, const scene::WorldInstance& instance) {
    const Interval inside = interval_in(instance, walk.prepared(), walk.interval, *walk.counts);
    if (inside.is_empty()) return;
    PreparedRay local = set_out_in(instance, walk.prepared());
    find_nearest(*walk.parts, walk.parts->prototypes[instance.prototype],
                 walk.place + instance.first_place, local, inside, *walk.best, *walk.counts);
    walk.narrow();
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as instances nest
bool any_in(const PartWalk& walk, const scene::WorldInstance& instance) {
    const Interval inside = interval_in(instance, walk.prepared(), walk.interval, *walk.counts);
    if (inside.is_empty()) return false;
    PreparedRay local = set_out_in(instance, walk.prepared());
    return find_any(*walk.parts, walk.parts->prototypes[instance.prototype], local, inside,
                    *walk.counts);
}

Met nearest_triangle(Walk& walk, const TriangleBlock& block, std::uint32_t lane,
                     const TriangleFinds& finds) {
    auto& self = static_cast<PartWalk&>(walk);
    if (!is_plain(block, lane, finds)) [[unlikely]] {
        return self.keep(meet(self, block, lane, finds)) ? Met::nearer_hit : Met::nothing;
    }
    const float t = finds.t[lane];
    const PrimitiveId id = PrimitiveId::of_value(block.ids[lane]);
    Hit& best = *self.best;
    if (!self.interval.contains(t) || !is_closer(t, self.place, id, best)) return Met::nothing;
    // One by one: copied as one, what was just written would be waited for.
    const EdgeAreas<float> areas = areas_of(finds, lane);
    const float sum = areas.a + areas.b + areas.c;
    best.t = t;
    best.u = areas.b / sum;
    best.v = areas.c / sum;
    best.primitive_id = id;
    best.place = self.place;
    best.normal.x = finds.normal[0][lane];
    best.normal.y = finds.normal[1][lane];
    best.normal.z = finds.normal[2][lane];
    self.narrow();
    return Met::nearer_hit;
}

Met nearest_sphere(Walk& walk, const SphereBlock& block, std::uint32_t lane) {
    auto& self = static_cast<PartWalk&>(walk);
    return self.keep(meet(self, block, lane)) ? Met::nearer_hit : Met::nothing;
}

Met nearest_framed(Walk& walk, std::uint32_t id) {
    auto& self = static_cast<PartWalk&>(walk);
    return self.keep(meet(self, PrimitiveId::of_value(id))) ? Met::nearer_hit : Met::nothing;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as instances nest
Met nearest_instances(Walk& walk, const std::uint32_t* ids, std::uint32_t count) {
    auto& self = static_cast<PartWalk&>(walk);
    for (std::uint32_t i = 0; i < count; ++i) {
        nearest_in(self, self.geometry().instances[PrimitiveId::of_value(ids[i]).index()]);
    }
    return Met::nearer_hit;  // perhaps
}

Met any_triangle(Walk& walk, const TriangleBlock& block, std::uint32_t lane,
                 const TriangleFinds& finds) {
    const auto& self = static_cast<const PartWalk&>(walk);
    if (!self.casts_shadow(PrimitiveId::of_value(block.ids[lane]))) return Met::nothing;
    const bool is_hit = is_plain(block, lane, finds) ? self.interval.contains(finds.t[lane])
                                                     : !meet(self, block, lane, finds).is_none();
    return is_hit ? Met::end : Met::nothing;
}

Met any_sphere(Walk& walk, const SphereBlock& block, std::uint32_t lane) {
    const auto& self = static_cast<const PartWalk&>(walk);
    return self.casts_shadow(PrimitiveId::of_value(block.ids[lane])) &&
                   !meet(self, block, lane).is_none()
               ? Met::end
               : Met::nothing;
}

Met any_framed(Walk& walk, std::uint32_t value) {
    const auto& self = static_cast<const PartWalk&>(walk);
    const PrimitiveId id = PrimitiveId::of_value(value);
    return self.casts_shadow(id) && !meet(self, id).is_none() ? Met::end : Met::nothing;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as instances nest
Met any_instances(Walk& walk, const std::uint32_t* ids, std::uint32_t count) {
    const auto& self = static_cast<const PartWalk&>(walk);
    const bool is_hit = std::any_of(ids, ids + count, [&](std::uint32_t value) {
        const PrimitiveId id = PrimitiveId::of_value(value);
        return self.casts_shadow(id) && any_in(self, self.geometry().instances[id.index()]);
    });
    return is_hit ? Met::end : Met::nothing;
}

}  // namespace

const WalkCalls kNearestCalls{nearest_triangle, nearest_sphere, nearest_framed, nearest_instances};
const WalkCalls kAnyCalls{any_triangle, any_sphere, any_framed, any_instances};

void PartWalk::meet_planes() {
    for (const PrimitiveId plane : part->tree.planes) {
        ++primitive_tests;
        keep(meet(*this, plane));
    }
}

bool PartWalk::meets_plane() {
    return std::ranges::any_of(part->tree.planes, [&](PrimitiveId plane) {
        if (!casts_shadow(plane)) return false;
        ++primitive_tests;
        return !meet(*this, plane).is_none();
    });
}

bool PartWalk::keep(const Hit& hit) {
    if (hit.is_none() || !is_closer(hit, *best)) return false;
    *best = hit;
    narrow();
    return true;
}

bool PartWalk::casts_shadow(PrimitiveId id) const {
    return part->all_cast_shadows || geometry().object(geometry().object_of(id)).casts_shadow;
}

}  // namespace lray::bvh
