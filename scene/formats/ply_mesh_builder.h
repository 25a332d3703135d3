// Makes a mesh of the rows of a PLY file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/formats/ply_layout.h"
#include "scene/mesh.h"
#include "scene/triangulate_polygon.h"

namespace lray::scene::ply {

/// Some vertices, as the file tells them.
struct VertexBlock {
    static constexpr std::size_t kCapacity = 512;

    std::size_t count = 0;
    std::array<std::array<float, kCapacity>, kSlotCount> values{};  // by Slot, of those in use

    std::array<float, kCapacity>& operator[](Slot slot) {
        return values[static_cast<std::size_t>(slot)];
    }
    const std::array<float, kCapacity>& operator[](Slot slot) const {
        return values[static_cast<std::size_t>(slot)];
    }
};

/// Of one face; likewise in OBJ.
inline constexpr std::size_t kMaxCorners = std::size_t{1} << 20;

/// Vertices come before faces.
class MeshBuilder {
 public:
    explicit MeshBuilder(const Layout& layout) : layout_(layout) {}

    void reserve_vertices(std::size_t count);
    void reserve_triangles(std::size_t count) {
        mesh_.triangles.reserve(mesh_.triangles.size() + count);
    }

    /// Adds vertices and returns how many: fewer than there are if the next has a position or
    /// texture coordinates that are not finite. A normal that is not, or of length 0, is none.
    /// Colours are clamped.
    std::size_t add_vertices(const VertexBlock& block);

    std::size_t vertex_count() const { return mesh_.positions.size(); }

    /// Shape: 3 corners or more; all are vertices. Likewise below.
    void add_face(std::span<const std::uint32_t> corners);
    void add_triangle(const IndexTriple& triangle) { mesh_.triangles.push_back(triangle); }

    /// Adds triangles that the caller writes; of those behind, some may be taken back.
    std::span<IndexTriple> add_room(std::size_t count);
    void take_back(std::size_t count) { mesh_.triangles.resize(mesh_.triangles.size() - count); }

    /// Adds the triangle of a vertex of a strip and the two before it, every other one turned
    /// around; not those that repeat a vertex to lead from one strip to the next.
    void continue_strip(std::uint32_t corner);
    void end_strip() { strip_size_ = 0; }

    /// Returns the mesh; empty if it has no triangles.
    std::optional<Mesh> finish();

 private:
    void add_normals(const VertexBlock& block, std::size_t count);
    void add_colors(const VertexBlock& block, std::size_t count);

    const Layout& layout_;
    Mesh mesh_{};
    bool has_zero_normals_ = false;
    std::size_t strip_size_ = 0;  // of the strip so far
    std::array<std::uint32_t, 2> strip_end_{};
    PolygonTriangulator triangulator_{};
    std::vector<Vec3> polygon_{};
};

}  // namespace lray::scene::ply
