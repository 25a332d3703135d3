#include "tests/bvh/worlds.h"

#include <cmath>
#include <utility>

namespace lray::bvh {

namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;

/// Gives the last primitive of the kind an object of its own.
PrimitiveId finish(scene::Geometry& geometry, PrimitiveKind kind, std::size_t count) {
    geometry.object_ids[static_cast<std::size_t>(kind)].push_back(
        scene::ObjectId{geometry.objects.size()});
    geometry.objects.emplace_back();
    return {kind, count - 1};
}

}  // namespace

PrimitiveId add_triangle(scene::Geometry& geometry, Vec3 a, Vec3 b, Vec3 c) {
    const auto base = static_cast<std::uint32_t>(geometry.vertices.size());
    geometry.vertices.insert(geometry.vertices.end(), {a, b, c});
    geometry.triangles.push_back({{base, base + 1, base + 2}});
    return finish(geometry, PrimitiveKind::triangle, geometry.triangles.size());
}

PrimitiveId add_rectangle(scene::Geometry& geometry, Vec3 corner, Vec3 edge_u, Vec3 edge_v) {
    geometry.rectangles.push_back(
        {{corner, corner + edge_u, corner + edge_u + edge_v, corner + edge_v}});
    return finish(geometry, PrimitiveKind::rectangle, geometry.rectangles.size());
}

PrimitiveId add_sphere(scene::Geometry& geometry, Vec3 center, float radius) {
    geometry.spheres.push_back({center, radius});
    return finish(geometry, PrimitiveKind::sphere, geometry.spheres.size());
}

PrimitiveId add_ellipsoid(scene::Geometry& geometry, const scene::AffineFrame& frame) {
    geometry.ellipsoids.push_back({frame});
    return finish(geometry, PrimitiveKind::ellipsoid, geometry.ellipsoids.size());
}

PrimitiveId add_cylinder(scene::Geometry& geometry, const scene::AffineFrame& frame,
                         float top_radius, bool caps) {
    geometry.cylinders.push_back({frame, top_radius, caps});
    return finish(geometry, PrimitiveKind::cylinder, geometry.cylinders.size());
}

PrimitiveId add_disk(scene::Geometry& geometry, const scene::AffineFrame& frame, float hole) {
    geometry.disks.push_back({frame, hole});
    return finish(geometry, PrimitiveKind::disk, geometry.disks.size());
}

PrimitiveId add_box(scene::Geometry& geometry, const scene::AffineFrame& frame) {
    geometry.boxes.push_back({frame});
    return finish(geometry, PrimitiveKind::box, geometry.boxes.size());
}

PrimitiveId add_plane(scene::Geometry& geometry, Vec3 point, Vec3 normal) {
    geometry.planes.push_back({point, normal});
    return finish(geometry, PrimitiveKind::plane, geometry.planes.size());
}

PrimitiveId add_torus(scene::Geometry& geometry, const scene::AffineFrame& frame, float tube) {
    geometry.tori.push_back({frame, tube});
    return finish(geometry, PrimitiveKind::torus, geometry.tori.size());
}

std::uint32_t add_prototype(scene::World& world, scene::Geometry prototype) {
    world.prototypes.push_back(std::move(prototype));
    return static_cast<std::uint32_t>(world.prototypes.size() - 1);
}

PrimitiveId add_instance(const scene::World& world, scene::Geometry& geometry,
                         std::uint32_t prototype, const scene::AffineFrame& frame) {
    const scene::Geometry& placed = world.prototypes[prototype];
    geometry.instances.push_back(
        {frame, placed_bounds(finite_bounds(placed), frame), prototype, geometry.place_count});
    geometry.place_count += placed.place_count;
    return finish(geometry, PrimitiveKind::instance, geometry.instances.size());
}

scene::AffineFrame make_frame(const DMat3& linear, Vec3 origin) {
    return {origin, Mat3{glm::inverse(linear)}};
}

scene::AffineFrame scaled_frame(Vec3 size, Vec3 origin) {
    DMat3 linear{1.0};
    for (int axis = 0; axis < 3; ++axis) linear[axis][axis] = static_cast<double>(size[axis]);
    return make_frame(linear, origin);
}

float Random::uniform(float lo, float hi) {
    const auto bits = static_cast<double>(engine_() >> 11);
    return lo + (hi - lo) * static_cast<float>(bits * 0x1p-53);
}

int Random::below(int count) {
    return static_cast<int>(engine_() % static_cast<std::uint64_t>(count));
}

Vec3 Random::in_cube(float half_size) {
    const float x = uniform(-half_size, half_size);
    const float y = uniform(-half_size, half_size);
    return {x, y, uniform(-half_size, half_size)};
}

Vec3 Random::direction() {
    while (true) {
        const Vec3 v = in_cube(1.0f);
        const float length2 = dot(v, v);
        if (length2 > 0.01f && length2 <= 1.0f) return v / std::sqrt(length2);
    }
}

DMat3 Random::rotation() {
    const DVec3 x{direction()};
    const DVec3 unit_x = glm::normalize(x);
    const DVec3 unit_z = glm::normalize(cross(unit_x, DVec3{direction()}));
    return {unit_x, cross(unit_z, unit_x), unit_z};
}

PrimitiveId add_random(scene::Geometry& geometry, Random& random, Vec3 center, float size) {
    return add_random(geometry, random,
                      static_cast<PrimitiveKind>(random.below(scene::kSurfaceKindCount)), center,
                      size);
}

PrimitiveId add_random(scene::Geometry& geometry, Random& random, PrimitiveKind kind, Vec3 center,
                       float size) {
    const auto any_frame = [&] {
        DMat3 scale{1.0};
        for (int axis = 0; axis < 3; ++axis) {
            scale[axis][axis] = static_cast<double>(size * random.uniform(0.3f, 1.0f));
        }
        // Rotated on both sides: a skewed frame.
        return make_frame(random.rotation() * scale * random.rotation(), center);
    };
    switch (kind) {
        case PrimitiveKind::triangle:
            return add_triangle(geometry, center + random.in_cube(size),
                                center + random.in_cube(size), center + random.in_cube(size));
        case PrimitiveKind::rectangle: {
            const DMat3 axes = random.rotation();
            return add_rectangle(geometry, center, Vec3{axes[0]} * size,
                                 Vec3{axes[1]} * (size * random.uniform(0.3f, 1.0f)));
        }
        case PrimitiveKind::sphere:
            return add_sphere(geometry, center, size * random.uniform(0.3f, 1.0f));
        case PrimitiveKind::ellipsoid:
            return add_ellipsoid(geometry, any_frame());
        case PrimitiveKind::cylinder: {
            constexpr float kTops[] = {0.0f, 0.4f, 0.999f, 1.0f};
            return add_cylinder(geometry, any_frame(), kTops[random.below(4)],
                                random.below(2) == 0);
        }
        case PrimitiveKind::disk:
            return add_disk(geometry, any_frame(), random.below(2) == 0 ? 0.0f : 0.5f);
        case PrimitiveKind::box:
            return add_box(geometry, any_frame());
        case PrimitiveKind::plane:
            return add_plane(geometry, center, random.direction());
        case PrimitiveKind::torus: {
            constexpr float kTubes[] = {0.05f, 0.2f, 0.4f, 0.5f, 0.7f};
            return add_torus(geometry, any_frame(), kTubes[random.below(5)]);
        }
        case PrimitiveKind::instance:
            break;
    }
    return {};
}

}  // namespace lray::bvh
