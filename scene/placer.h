// Places one shape or instance of the graph in a geometry, in a given place. Walking the graph is
// graph_walk.h's.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>

#include "base/diagnostics.h"
#include "scene/content_map.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace lray::scene {

/// Coordinates of the world end here: squares, areas and products of differences stay finite in
/// float with room to spare.
inline constexpr double kMaxCoordinate = 1e18;
/// Sizes of the world begin here, so that inverse maps stay finite in float likewise.
inline constexpr double kMinSize = 1e-18;

/// What a node takes from the nodes above it, its own settings included.
/// Space: "world" is that of the geometry, in a prototype its own.
struct Placement {
    Transform world_from_object{};
    bool is_mirrored = false;    // world_from_object reverses orientation
    std::uint32_t material = 0;  // index into World::materials, or Object::kInherited
    bool visible = true;
    bool casts_shadow = true;
};

/// What an instance needs to know of the prototype that it places.
struct Prototype {
    std::uint32_t index = 0;
    Bounds bounds{};              // empty: there is nothing to place
    DVec3 origin_object{};        // of the prototype's space, in that of the node it is made of
    PlaceOffset place_count = 1;  // Geometry::place_count
    double thinness = 1.0;        // what is 1 in the finest space that instances in it lead to
};

/// Adds primitives to a geometry. All is computed in double and rounded to float once.
/// Errors of place(): E0304 when the shape reaches beyond kMaxCoordinate or is smaller than
/// kMinSize, E0310 when the transform flattens it; warnings W1201 (shape without area) and W1702
/// (faces of a mesh without area), dropped. By the rule the space of a shape is kept with it.
class Placer {
 public:
    Placer(const Scene& scene, const ObjectSpaceRule& space_rule, Geometry& geometry,
           Diagnostics& diagnostics)
        : scene_(scene), space_rule_(space_rule), geometry_(geometry), diagnostics_(diagnostics) {}

    /// Adds the primitives of a shape or mesh; `node` is no group, instance or light.
    void place(NodeId node_id, const Placement& placement);

    /// Adds an instance: `node`, or what it is placed by, takes the place of what it holds.
    void place_instance(NodeId node_id, const Prototype& prototype, const Placement& placement);

    /// Makes triangle_normals and triangle_uvs as long as `triangles`, colors as `vertices`. Call
    /// once, last.
    void finish();

    /// How many shapes were refused with an error.
    std::size_t refused_count() const { return refused_count_; }

    /// How many units of the finest space that instances lead to make one here; 1 at least.
    double thinness() const { return thinness_; }

 private:
    void place_sphere(const Node& node, const Placement& placement);
    void place_rectangle(const Node& node, const Placement& placement);
    void place_triangle(const Node& node, const Placement& placement);
    void place_cylinder(const Node& node, const Placement& placement);
    void place_disk(const Node& node, const Placement& placement);
    void place_box(const Node& node, const Placement& placement);
    void place_plane(const Node& node, const Placement& placement);
    void place_torus(const Node& node, const Placement& placement);
    void place_mesh(NodeId node_id, const Placement& placement);
    bool enter_material(NodeId node_id, std::size_t number, const Placement& placement);
    void place_triangles(NodeId node_id, TriangleRange range, const Placement& placement);

    /// Returns the frame of the canonical shape that `linear` and `offset` bring into the world;
    /// empty when that was refused.
    std::optional<AffineFrame> make_frame(const Node& node, const DMat3& linear, DVec3 offset);
    std::optional<AffineFrame> invert(const Node& node, const DMat3& linear, DVec3 offset);

    /// True if all points can be represented; otherwise refuses the shape.
    bool are_placeable(const Node& node, std::span<const DVec3> points);

    void refuse(Code code, const Node& node, std::string message);
    void warn_no_area(const Node& node);

    void add_object(NodeId node_id, const Placement& placement);

    /// Begins the object that the primitives to come are of, and keeps its space by the rule. False
    /// if there is none: the shape is refused.
    bool begin_object(NodeId node_id, const Placement& placement);

    /// Keeps the space of the shape being placed. False if there is none: the shape is refused.
    bool keep_space(const Node& node, const Transform& world_from_object);

    /// Appends the primitive's object; `object_id_` is the object of the shape being placed.
    void add_object_id(PrimitiveKind kind) {
        geometry_.object_ids[static_cast<std::size_t>(kind)].push_back(object_id_);
    }
    void set_triangle_normals(const IndexTriple& triple);
    void set_triangle_uvs(const IndexTriple& triple);

    const Scene& scene_;
    const ObjectSpaceRule& space_rule_;
    Geometry& geometry_;
    Diagnostics& diagnostics_;
    ObjectId object_id_{};
    std::unordered_map<std::size_t, ObjectId>
        mesh_objects_{};                      // of the mesh being placed, by material
    std::optional<Color> mesh_mean_color_{};  // of its vertices, if they show
    std::size_t refused_count_ = 0;
    double thinness_ = 1.0;
};

/// True if the triangle has no area: its normal is 0 in double.
bool is_degenerate(Vec3 a, Vec3 b, Vec3 c);

/// The largest magnitude of a component; NaN counts as infinite.
double reach(DVec3 v);

/// Returns the unit vector; empty for 0 and what is not finite.
std::optional<DVec3> unit(DVec3 v);

}  // namespace lray::scene
