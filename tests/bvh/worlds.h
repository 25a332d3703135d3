// Makes worlds for the tests: one primitive or many, with and without frames.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "base/ray.h"
#include "bvh/intersect.h"
#include "scene/world.h"

namespace lray::bvh {

scene::PrimitiveId add_triangle(scene::Geometry& geometry, Vec3 a, Vec3 b, Vec3 c);
scene::PrimitiveId add_rectangle(scene::Geometry& geometry, Vec3 corner, Vec3 edge_u, Vec3 edge_v);
scene::PrimitiveId add_sphere(scene::Geometry& geometry, Vec3 center, float radius);
scene::PrimitiveId add_ellipsoid(scene::Geometry& geometry, const scene::AffineFrame& frame);
scene::PrimitiveId add_cylinder(scene::Geometry& geometry, const scene::AffineFrame& frame,
                                float top_radius, bool caps);
scene::PrimitiveId add_disk(scene::Geometry& geometry, const scene::AffineFrame& frame, float hole);
scene::PrimitiveId add_box(scene::Geometry& geometry, const scene::AffineFrame& frame);
scene::PrimitiveId add_plane(scene::Geometry& geometry, Vec3 point, Vec3 normal);
scene::PrimitiveId add_torus(scene::Geometry& geometry, const scene::AffineFrame& frame,
                             float tube);

/// Makes the frame of the map q -> linear q + origin.
scene::AffineFrame make_frame(const DMat3& linear, Vec3 origin);

/// The axis-aligned frame that scales by `size`.
scene::AffineFrame scaled_frame(Vec3 size, Vec3 origin);

/// Repeatable random values; the seed belongs in the message of what fails.
class Random {
 public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    float uniform(float lo, float hi);
    int below(int count);
    Vec3 in_cube(float half_size);
    Vec3 direction();  // unit
    DMat3 rotation();

 private:
    std::mt19937_64 engine_;
};

/// Adds what is in it to the world's prototypes, numbered anew. Returns its index.
std::uint32_t add_prototype(scene::World& world, scene::Geometry prototype);

/// Places a prototype in the world, or in a prototype that comes after it.
scene::PrimitiveId add_instance(const scene::World& world, scene::Geometry& geometry,
                                std::uint32_t prototype, const scene::AffineFrame& frame);

/// Adds a primitive of a random kind, of about that size and in about that place.
scene::PrimitiveId add_random(scene::Geometry& geometry, Random& random, Vec3 center, float size);

/// The same for a given kind.
scene::PrimitiveId add_random(scene::Geometry& geometry, Random& random, scene::PrimitiveKind kind,
                              Vec3 center, float size);

inline Hit meet(const scene::World& world, scene::PrimitiveId id, const Ray& ray,
                Interval interval = {}) {
    return intersect(world, id, prepare(ray), interval);
}

}  // namespace lray::bvh
