// What a tree of boxes is built from: a box and an id for every primitive, 32 bytes each.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "bvh/boxes/arena.h"
#include "bvh/boxes/box_layout.h"
#include "bvh/float4.h"
#include "scene/world.h"

namespace lray::bvh {

/// What may share a leaf.
enum class RefClass : std::uint8_t {
    triangle,  // and halves of rectangles
    sphere,
    framed,  // all other kinds that have a surface, bounded
    instance,
};
inline constexpr unsigned kRefClassCount = 4;

inline constexpr bool has_blocks(RefClass ref_class) {
    return ref_class <= RefClass::sphere;
}

/// What a test costs, in eighths of that of a block of triangles: framed ones are met one by one,
/// in double what their bounds leave of them, and an instance has a tree of its own.
inline constexpr std::uint32_t kRefWeights[kRefClassCount] = {1, 1, 9, 80};

/// A box with the primitive in it. No coordinate is -0, so that the least of several is the same
/// in any order.
struct alignas(16) BuildRef {
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
inline RefCorners corners_of(const scene::Geometry& geometry, const BuildRef& ref) {
    const auto id = scene::PrimitiveId::of_value(ref.id);
    if (id.kind() == scene::PrimitiveKind::triangle) {
        const auto& [a, b, c] = geometry.triangles[id.index()].vertices;
        return {geometry.vertices[a], geometry.vertices[b], geometry.vertices[c]};
    }
    const auto& [p00, p10, p11, p01] = geometry.rectangles[id.index()].corners;
    if ((ref.tag & BuildRef::kSecondHalf) != 0) return {p00, p11, p01};
    return {p00, p10, p11};
}

/// Primitives as a tree is built over them; planes, which have no box, apart.
struct BuildRefs {
    Arena arena{};  // of BuildRefs, `capacity` of them
    std::uint32_t count = 0;
    std::uint32_t capacity = 0;
    std::vector<scene::PrimitiveId> planes{};

    /// Those beyond `count` are room for parts of primitives.
    std::span<BuildRef> all() { return {reinterpret_cast<BuildRef*>(arena.data()), capacity}; }
    std::span<BuildRef> used() { return all().first(count); }
};

/// Collects the visible primitives of a geometry. The boxes of triangles, rectangles and instances
/// are exactly their bounds; those of kinds that are solved in double are widened by what rounding
/// a hit to float may move it. `room` is how many may be added, in parts of how many there are.
/// Their order depends on the geometry alone, not on how many cores collect them.
BuildRefs make_build_refs(const scene::Geometry& geometry, double room);

}  // namespace lray::bvh
