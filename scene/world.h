// The world as it is traced: flat arrays of world-space primitives, in float, made by flatten()
// and never changed after. The geometry of each kind is defined here; how rays meet it is in bvh/.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "base/vec.h"
#include "scene/ids.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/mesh.h"
#include "scene/object_space.h"
#include "scene/texture.h"

namespace lray::scene {

enum class PrimitiveKind : std::uint8_t {
    triangle,
    rectangle,
    sphere,
    ellipsoid,
    cylinder,
    disk,
    box,
    plane,
    torus,
    instance,
};
inline constexpr std::size_t kPrimitiveKindCount = 10;
/// The kinds before `instance`, which have a surface of their own.
inline constexpr std::size_t kSurfaceKindCount = 9;

/// A place in the world: the world's own space is 0, and every instance places its prototype, and
/// what that places, anew. Places are numbered as they are come by on a walk that enters each
/// instance before it goes on; an offset counts from the place of what an instance stands in.
using PlaceOffset = std::uint64_t;
/// The places of a world are fewer.
inline constexpr PlaceOffset kMaxPlaceCount = PlaceOffset{1} << 63;
/// So many instances lead to a place at most: rays are followed there by recursion.
inline constexpr std::uint32_t kMaxInstanceDepth = 64;

/// A primitive of a geometry: its kind in the top bits, its index below. Ids are totally ordered;
/// the least one wins when two primitives are hit at the same t.
struct PrimitiveId {
    static constexpr unsigned kIndexBits = 28;
    static constexpr std::uint32_t kMaxIndex = (1u << kIndexBits) - 1;
    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::uint32_t value = kNone;

    constexpr PrimitiveId() = default;
    constexpr PrimitiveId(PrimitiveKind kind, std::size_t index)
        : value(static_cast<std::uint32_t>(kind) << kIndexBits |
                static_cast<std::uint32_t>(index)) {}

    static constexpr PrimitiveId of_value(std::uint32_t value) {
        PrimitiveId id;
        id.value = value;
        return id;
    }

    constexpr bool is_none() const { return value == kNone; }
    constexpr PrimitiveKind kind() const { return static_cast<PrimitiveKind>(value >> kIndexBits); }
    constexpr std::uint32_t index() const { return value & kMaxIndex; }
    friend constexpr auto operator<=>(PrimitiveId, PrimitiveId) = default;
};

/// Maps the canonical object into the world by its inverse, split so that objects far from the
/// world's origin keep their precision: p_object = object_from_world * (p - origin).
struct AffineFrame {
    Vec3 origin{};
    Mat3 object_from_world{1.0f};
};

/// Indices into World::vertices.
struct Triangle {
    IndexTriple vertices{};
};

/// A quadrilateral with corners p00, p10, p11, p01 (by u, v), met as the two triangles
/// (p00, p10, p11) and (p00, p11, p01): rectangles that share corners leave no gap between them.
/// The front is where the corners run counter-clockwise, of a mirrored one where they run
/// clockwise.
struct Rectangle {
    std::array<Vec3, 4> corners{};
    bool is_mirrored = false;
};

struct Sphere {
    Vec3 center{};
    float radius = 0.0f;
};

/// The unit sphere under an affine map.
struct Ellipsoid {
    AffineFrame frame{};
};

/// The truncated cone around +Y from y = 0, radius 1, to y = 1, radius top_radius in [0, 1], under
/// an affine map. top_radius 1 is a cylinder, 0 a cone.
struct Cylinder {
    AffineFrame frame{};
    float top_radius = 1.0f;
    bool caps = true;
    bool is_turned = false;  // the end that the shape begins with is the top
};

/// The unit disk in the plane y = 0, normal +Y, without the open disk of radius `hole`, under an
/// affine map.
struct Disk {
    AffineFrame frame{};
    float hole = 0.0f;
};

/// The cube [-1, 1]^3 under an affine map.
struct Box {
    AffineFrame frame{};
};

/// Infinite; `normal` is unit. Surface parameters grow with the position by their gradients, from 0
/// at the point.
struct Plane {
    Vec3 point{};
    Vec3 normal{0.0f, 1.0f, 0.0f};
    Vec3 gradient_u{1.0f, 0.0f, 0.0f};
    Vec3 gradient_v{0.0f, 0.0f, -1.0f};
};

/// The torus around +Y that just fits into the unit sphere: the tube has the radius `tube`, in
/// (0, 1], and its middle is 1 - tube from the axis, under an affine map. Where the tube overlaps
/// itself (tube > 1/2) only the outside is surface.
struct Torus {
    AffineFrame frame{};
    float tube = 0.2f;

    double radius() const { return 1.0 - static_cast<double>(tube); }
};

/// A prototype in a place of its own. It is never hit itself: what is in it is. Its frame is exact:
/// whatever is traced goes through these floats.
struct WorldInstance {
    AffineFrame frame{};
    Bounds bounds{};              // of the prototype under the frame; nothing is hit outside of it
    std::uint32_t prototype = 0;  // index into World::prototypes
    PlaceOffset first_place = 0;  // of the prototype, from the place of what the instance is in
};

/// What a primitive or instance belongs to: one shape, mesh or instance in one place of the graph.
/// Painted in one colour at level 1.
struct Object {
    /// The material is that of the instance that the object is seen through.
    static constexpr std::uint32_t kInherited = 0xffffffffu;

    NodeId node_id{};
    std::uint32_t material = 0;  // index into World::materials, or kInherited
    bool visible = true;
    bool casts_shadow = true;
    bool is_continued = false;  // the one before is of the same shape: a mesh of several materials
};

/// Primitives of one space: the world, or a prototype's own.
/// Shape: `colors` is empty or as long as `vertices`; `triangle_normals` and `triangle_uvs` are
/// empty or as long as `triangles`; object_ids of a kind is as long as the array of that kind.
struct Geometry {
    std::vector<Vec3> vertices{};
    std::vector<Color> colors{};  // of the vertices, where a texture shows them
    std::vector<Triangle> triangles{};
    std::vector<Rectangle> rectangles{};
    std::vector<Sphere> spheres{};
    std::vector<Ellipsoid> ellipsoids{};
    std::vector<Cylinder> cylinders{};
    std::vector<Disk> disks{};
    std::vector<Box> boxes{};
    std::vector<Plane> planes{};
    std::vector<Torus> tori{};
    std::vector<WorldInstance> instances{};

    std::vector<Vec3> normals{};
    std::vector<Vec2> uvs{};
    std::vector<IndexTriple> triangle_normals{};  // into normals; first index kNone: facetted
    std::vector<IndexTriple> triangle_uvs{};      // into uvs; likewise

    std::array<std::vector<ObjectId>, kPrimitiveKindCount> object_ids{};
    std::vector<Object> objects{};
    std::vector<Color> mean_colors{};  // by object, up to the last one whose vertices have colours
    ObjectSpaces object_spaces{};      // of those whose look depends on it (ObjectSpaceRule)

    PlaceOffset place_count = 1;  // this one and those of all instances, however deep
    NodeId node_id{};             // whose content it is: the root, or of a prototype the first node

    ObjectId object_of(PrimitiveId id) const {
        return object_ids[static_cast<std::size_t>(id.kind())][id.index()];
    }
    const Object& object(ObjectId id) const { return objects[id.index()]; }

    /// Returns what stands for the colours of an object's vertices; white if they have none.
    Color mean_color(ObjectId id) const {
        return id.index() < mean_colors.size() ? mean_colors[id.index()] : Color{1.0f};
    }

    /// Primitives held, instances included.
    std::size_t primitive_count() const;
};

/// What is traced: the geometry of the world's space, and what its instances place in it.
struct World : Geometry {
    std::vector<Geometry> prototypes{};   // without planes; each uses only those before it
    std::vector<Material> materials{};    // the first is the default
    std::vector<Texture> textures{};      // by TextureId
    std::span<const Picture> pictures{};  // by PictureId; they stay with the Scene, which lives on
    std::vector<WorldLight> lights{};     // in the order of the graph
};

/// Conservative bounds of one primitive. Asserts that it is not a plane.
Bounds primitive_bounds(const Geometry& geometry, PrimitiveId id);

/// The bounds of all primitives but the planes; empty if there are none.
Bounds finite_bounds(const Geometry& geometry);

/// Conservative bounds of what a box holds, under a frame's map.
Bounds placed_bounds(const Bounds& bounds_object, const AffineFrame& frame);

}  // namespace lray::scene
