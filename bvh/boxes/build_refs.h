// What a tree of boxes is built from: a box and an id for every primitive, 32 bytes each.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bounds.h"
#include "bvh/boxes/box_layout.h"
#include "bvh/boxes/float4.h"
#include "scene/world.h"

namespace lray::bvh {

/// What may share a leaf. All classes but the first two are one kind of primitive each.
enum class RefClass : std::uint8_t {
    triangle,  // and halves of rectangles
    sphere,
    ellipsoid,
    cylinder,
    disk,
    box,
    torus,
    instance,
};
inline constexpr unsigned kRefClassCount = 8;

/// What a test costs, in eighths of that of a block of triangles: those of the kinds in lists are
/// made one by one and in double, and an instance has a tree of its own.
inline constexpr std::uint32_t kRefWeights[kRefClassCount] = {1, 1, 16, 20, 12, 16, 80, 80};

/// A box with the primitive in it. No coordinate is -0, so that the least of several is the same
/// in any order.
struct alignas(32) BuildRef {
    float min[3] = {kInfinity, kInfinity, kInfinity};
    std::uint32_t id = 0;  // value of a PrimitiveId
    float max[3] = {-kInfinity, -kInfinity, -kInfinity};
    std::uint32_t tag = 0;  // a RefClass, and kSecondHalf

    /// In a tag: of the two triangles of a rectangle, the second.
    static constexpr std::uint32_t kSecondHalf = 0x100;

    Float4 lower() const { return load_three(min); }
    Float4 upper() const { return load_three(max); }
    unsigned ref_class() const { return tag & 0xff; }
};
static_assert(sizeof(BuildRef) == 32);

/// The corners of a triangle, or of that half of a rectangle that its kernel takes it for
/// (bvh/kernels/rectangle.h).
struct RefCorners {
    Vec3 a{};
    Vec3 b{};
    Vec3 c{};
};
RefCorners corners_of(const scene::Geometry& geometry, const BuildRef& ref);

/// Primitives as a tree is built over them; planes, which have no box, apart.
struct BuildRefs {
    std::vector<BuildRef> refs{};
    std::vector<scene::PrimitiveId> planes{};
};

/// Collects the visible primitives of a geometry. The boxes of triangles, rectangles and instances
/// are exactly their bounds; those of kinds that are solved in double are widened by what rounding
/// a hit to float may move it.
BuildRefs make_build_refs(const scene::Geometry& geometry);

}  // namespace lray::bvh
