// Makes a mesh of the statements of an OBJ file in their order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/formats/obj_counts.h"
#include "scene/mesh.h"
#include "scene/triangulate_polygon.h"

namespace lray::scene::obj {

/// Indices from 0; kNone where there is none.
struct Corner {
    std::uint32_t position = Mesh::kNone;
    std::uint32_t uv = Mesh::kNone;
    std::uint32_t normal = Mesh::kNone;
};

class MeshBuilder {
 public:
    /// Reserves memory for so many statements.
    void reserve(const Counts& counts);

    void add_position(Vec3 position) { mesh_.positions.push_back(position); }
    void add_uv(Vec2 uv) { mesh_.uvs.push_back(uv); }

    /// Any length; that of 0 is no normal.
    void add_normal(DVec3 direction);

    /// Adds the triangles of a polygon. Its corners may refer to what is added later.
    /// Shape: 3 corners or more.
    void add_face(std::span<const Corner> corners);

    /// Begins a part of the faces that follow. An object ends the group before it; a part begun
    /// again under its name goes on.
    void begin_object(std::string name);
    void begin_group(std::string name);

    std::size_t position_count() const { return mesh_.positions.size(); }
    std::size_t uv_count() const { return mesh_.uvs.size(); }
    std::size_t normal_count() const { return mesh_.normals.size(); }

    /// Returns the mesh; empty if it has no triangles or an index is out of range.
    std::optional<Mesh> finish();

 private:
    static constexpr std::size_t kNoPart = std::numeric_limits<std::size_t>::max();

    /// A polygon, laid down as a fan because a corner came later.
    struct LatePolygon {
        std::size_t first_triangle = 0;
        std::size_t triangle_count = 0;
    };

    void add_triangle(const Corner& a, const Corner& b, const Corner& c, bool has_uvs,
                      bool has_normals);
    void begin_part(std::size_t& open, std::string name);
    void close_part(std::size_t& open);
    bool are_indices_in_range() const;
    void triangulate_late_polygons();
    void forget_zero_normals();

    Mesh mesh_{};
    PolygonTriangulator triangulator_{};
    std::vector<Vec3> polygon_{};
    std::vector<LatePolygon> late_polygons_{};
    std::size_t open_object_ = kNoPart;
    std::size_t open_group_ = kNoPart;
    bool has_zero_normals_ = false;
};

}  // namespace lray::scene::obj
