#include "bvh/spheres/sphere_accel.h"

#include <algorithm>
#include <array>
#include <utility>

#include "bvh/instance_ray.h"
#include "bvh/intersect.h"
#include "bvh/spheres/sphere_part.h"
#include "bvh/spheres/sphere_volumes.h"
#include "scene/each_primitive.h"

namespace lray::bvh {

namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;

SpherePart make_part(const scene::Geometry& geometry) {
    SpherePart part;
    part.geometry = &geometry;
    std::vector<PrimitiveId> ids;
    std::vector<BoundingSphere> spheres;
    scene::each_primitive(geometry, [&](PrimitiveId id, const scene::Object& object) {
        if (!object.visible) return true;
        if (id.kind() == PrimitiveKind::plane) {
            part.planes.push_back(id);
        } else {
            ids.push_back(id);
            spheres.push_back(bounding_sphere(geometry, id));
        }
        return true;
    });
    part.tree = build_sphere_tree(spheres);
    part.objects.reserve(ids.size());
    for (const std::uint32_t index : part.tree.order) part.objects.push_back(ids[index]);
    part.tree.order = {};
    return part;
}

/// A node that waits, and where the ray enters it.
struct Waiting {
    std::uint32_t node = 0;
    double entry = 0.0;
};

class SphereAccel final : public Accel {
 public:
    explicit SphereAccel(const scene::World& world) {
        parts_.world = make_part(world);
        parts_.prototypes.reserve(world.prototypes.size());
        for (const scene::Geometry& prototype : world.prototypes) {
            parts_.prototypes.push_back(make_part(prototype));
        }
    }

    Hit nearest_hit(const Ray& ray, Interval interval, TraceCounts& counts) const override {
        Hit best;
        ++counts.rays;
        if (is_traceable(ray)) nearest(parts_.world, 0, prepare(ray), interval, best, counts);
        return best;
    }

    bool any_hit(const Ray& ray, Interval interval, TraceCounts& counts) const override {
        ++counts.rays;
        return is_traceable(ray) && any(parts_.world, prepare(ray), interval, counts);
    }

    AccelStats stats() const override {
        AccelStats stats;
        stats.bytes = sizeof *this + parts_.prototypes.capacity() * sizeof(SpherePart);
        stats.cost = parts_.world.tree.cost;
        add_part(parts_.world, stats);
        for (const SpherePart& part : parts_.prototypes) add_part(part, stats);
        return stats;
    }

    BoundingVolumes volumes(std::uint32_t level, std::size_t max_count) const override {
        return sphere_volumes(parts_, level_count_, level, max_count);
    }

 private:
    static void add_part(const SpherePart& part, AccelStats& stats) {
        stats.nodes += part.tree.nodes.size();
        stats.leaves += static_cast<std::uint64_t>(
            std::ranges::count_if(part.tree.nodes, &SphereNode::is_leaf));
        stats.references += part.objects.size() + part.planes.size();
        stats.depth = std::max(stats.depth, part.tree.depth);
        stats.bytes += part.tree.nodes.capacity() * sizeof(SphereNode) +
                       (part.objects.capacity() + part.planes.capacity()) * sizeof(PrimitiveId);
    }

    /// Calls visit(PrimitiveId) for the objects of every leaf that the ray meets within the
    /// interval, the nearer child first, until it returns false. `interval` may shrink meanwhile.
    template <class Visit>
    static bool walk(const SpherePart& part, const PreparedRay& ray, const Interval& interval,
                     TraceCounts& counts, Visit visit) {
        if (part.tree.nodes.empty()) return true;
        std::array<Waiting, kMaxSphereDepth> stack;
        std::size_t waiting_count = 0;
        const auto enter = [&](std::uint32_t node) {
            return entry_into(part.tree.nodes[node].sphere, ray, interval);
        };
        if (const auto entry = enter(0)) stack[waiting_count++] = {0, *entry};
        while (waiting_count > 0) {
            const Waiting next = stack[--waiting_count];
            if (next.entry > static_cast<double>(interval.hi)) continue;
            const SphereNode& node = part.tree.nodes[next.node];
            ++counts.node_tests;
            if (node.is_leaf()) {
                for (std::uint32_t i = 0; i < node.object_count; ++i) {
                    if (!visit(part.objects[node.first + i])) return false;
                }
                continue;
            }
            const std::uint32_t left = next.node + 1;
            const std::uint32_t right = node.first;
            const auto left_entry = enter(left);
            const auto right_entry = enter(right);
            const bool is_left_nearer = left_entry && (!right_entry || *left_entry <= *right_entry);
            if (is_left_nearer) {
                if (right_entry) stack[waiting_count++] = {right, *right_entry};
                stack[waiting_count++] = {left, *left_entry};
            } else {
                if (left_entry) stack[waiting_count++] = {left, *left_entry};
                if (right_entry) stack[waiting_count++] = {right, *right_entry};
            }
        }
        return true;
    }

    // NOLINTNEXTLINE(misc-no-recursion): as deep as instances nest
    void nearest(const SpherePart& part, scene::PlaceOffset place, const PreparedRay& ray,
                 Interval interval, Hit& best, TraceCounts& counts) const {
        const auto meet = [&](PrimitiveId id) {
            if (id.kind() == PrimitiveKind::instance) {
                const scene::WorldInstance& instance = part.geometry->instances[id.index()];
                const Interval inside = interval_in(instance, ray, interval, counts);
                if (!inside.is_empty()) {
                    nearest(parts_.prototypes[instance.prototype], place + instance.first_place,
                            ray_in(instance, ray), inside, best, counts);
                }
            } else {
                ++counts.primitive_tests;
                Hit hit = intersect(*part.geometry, id, ray, interval);
                hit.place = place;
                if (!hit.is_none() && is_closer(hit, best)) best = hit;
            }
            interval = up_to(best, interval);
            return true;
        };
        for (const PrimitiveId plane : part.planes) meet(plane);
        walk(part, ray, interval, counts, meet);
    }

    // NOLINTNEXTLINE(misc-no-recursion): as deep as instances nest
    bool any(const SpherePart& part, const PreparedRay& ray, Interval interval,
             TraceCounts& counts) const {
        const auto is_passed = [&](PrimitiveId id) {
            if (!part.geometry->object(part.geometry->object_of(id)).casts_shadow) return true;
            if (id.kind() != PrimitiveKind::instance) {
                ++counts.primitive_tests;
                return intersect(*part.geometry, id, ray, interval).is_none();
            }
            const scene::WorldInstance& instance = part.geometry->instances[id.index()];
            const Interval inside = interval_in(instance, ray, interval, counts);
            return inside.is_empty() || !any(parts_.prototypes[instance.prototype],
                                             ray_in(instance, ray), inside, counts);
        };
        return !std::ranges::all_of(part.planes, is_passed) ||
               !walk(part, ray, interval, counts, is_passed);
    }

    SphereParts parts_;
    LevelCount level_count_;
};

}  // namespace

std::unique_ptr<Accel> make_sphere_accel(const scene::World& world) {
    return std::make_unique<SphereAccel>(world);
}

}  // namespace lray::bvh
