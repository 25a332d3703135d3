#include "tests/bvh/worlds.h"

#include <cmath>

namespace lray::bvh {

namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;

/// Gives the last primitive of the kind an object of its own.
PrimitiveId finish(scene::World& world, PrimitiveKind kind, std::size_t count) {
    world.object_ids[static_cast<std::size_t>(kind)].push_back(
        scene::ObjectId{world.objects.size()});
    world.objects.emplace_back();
    return {kind, count - 1};
}

}  // namespace

PrimitiveId add_triangle(scene::World& world, Vec3 a, Vec3 b, Vec3 c) {
    const auto base = static_cast<std::uint32_t>(world.vertices.size());
    world.vertices.insert(world.vertices.end(), {a, b, c});
    world.triangles.push_back({{base, base + 1, base + 2}});
    return finish(world, PrimitiveKind::triangle, world.triangles.size());
}

PrimitiveId add_rectangle(scene::World& world, Vec3 corner, Vec3 edge_u, Vec3 edge_v) {
    world.rectangles.push_back(
        {{corner, corner + edge_u, corner + edge_u + edge_v, corner + edge_v}});
    return finish(world, PrimitiveKind::rectangle, world.rectangles.size());
}

PrimitiveId add_sphere(scene::World& world, Vec3 center, float radius) {
    world.spheres.push_back({center, radius});
    return finish(world, PrimitiveKind::sphere, world.spheres.size());
}

PrimitiveId add_ellipsoid(scene::World& world, const scene::AffineFrame& frame) {
    world.ellipsoids.push_back({frame});
    return finish(world, PrimitiveKind::ellipsoid, world.ellipsoids.size());
}

PrimitiveId add_cylinder(scene::World& world, const scene::AffineFrame& frame, float top_radius,
                         bool caps) {
    world.cylinders.push_back({frame, top_radius, caps});
    return finish(world, PrimitiveKind::cylinder, world.cylinders.size());
}

PrimitiveId add_disk(scene::World& world, const scene::AffineFrame& frame, float hole) {
    world.disks.push_back({frame, hole});
    return finish(world, PrimitiveKind::disk, world.disks.size());
}

PrimitiveId add_box(scene::World& world, const scene::AffineFrame& frame) {
    world.boxes.push_back({frame});
    return finish(world, PrimitiveKind::box, world.boxes.size());
}

PrimitiveId add_plane(scene::World& world, Vec3 point, Vec3 normal) {
    world.planes.push_back({point, normal});
    return finish(world, PrimitiveKind::plane, world.planes.size());
}

PrimitiveId add_torus(scene::World& world, const scene::AffineFrame& frame, float tube) {
    world.tori.push_back({frame, tube});
    return finish(world, PrimitiveKind::torus, world.tori.size());
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

PrimitiveId add_random(scene::World& world, Random& random, Vec3 center, float size) {
    return add_random(world, random,
                      static_cast<PrimitiveKind>(random.below(scene::kPrimitiveKindCount)), center,
                      size);
}

PrimitiveId add_random(scene::World& world, Random& random, PrimitiveKind kind, Vec3 center,
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
            return add_triangle(world, center + random.in_cube(size), center + random.in_cube(size),
                                center + random.in_cube(size));
        case PrimitiveKind::rectangle: {
            const DMat3 axes = random.rotation();
            return add_rectangle(world, center, Vec3{axes[0]} * size,
                                 Vec3{axes[1]} * (size * random.uniform(0.3f, 1.0f)));
        }
        case PrimitiveKind::sphere:
            return add_sphere(world, center, size * random.uniform(0.3f, 1.0f));
        case PrimitiveKind::ellipsoid:
            return add_ellipsoid(world, any_frame());
        case PrimitiveKind::cylinder: {
            constexpr float kTops[] = {0.0f, 0.4f, 0.999f, 1.0f};
            return add_cylinder(world, any_frame(), kTops[random.below(4)], random.below(2) == 0);
        }
        case PrimitiveKind::disk:
            return add_disk(world, any_frame(), random.below(2) == 0 ? 0.0f : 0.5f);
        case PrimitiveKind::box:
            return add_box(world, any_frame());
        case PrimitiveKind::plane:
            return add_plane(world, center, random.direction());
        case PrimitiveKind::torus: {
            constexpr float kTubes[] = {0.05f, 0.2f, 0.4f, 0.5f, 0.7f};
            return add_torus(world, any_frame(), kTubes[random.below(5)]);
        }
    }
    return {};
}

}  // namespace lray::bvh
