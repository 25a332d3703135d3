// The elements of a stretch of an OBJ file: what one task reads. Making a mesh of all of them is
// scene/formats/obj_assemble.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/formats/obj_counts.h"
#include "scene/mesh.h"
#include "scene/triangulate_polygon.h"

namespace lray::scene::obj {

/// Indices from 0 in the whole file; kNone where there is none.
struct Corner {
    std::uint32_t position = Mesh::kNone;
    std::uint32_t uv = Mesh::kNone;
    std::uint32_t normal = Mesh::kNone;
};

/// What holds for all faces that follow, until another of its kind: `o`, `g`, `usemtl`, `s`.
enum class StateKind : std::uint8_t { object, group, material, smoothing };
inline constexpr std::size_t kStateKindCount = 4;

/// For each kind the statement that came last and no face has seen yet; null: none.
class PendingStates {
 public:
    /// An object ends the group before it.
    void set(StateKind kind, const char* statement) {
        statements_[static_cast<std::size_t>(kind)] = statement;
        if (kind == StateKind::object) statements_[static_cast<std::size_t>(StateKind::group)] = {};
        are_any_ = true;
    }

    bool are_any() const { return are_any_; }

    /// Calls `use(kind, statement)` for each, in the order of the kinds, and forgets them.
    template <class Use>
    void take(const Use& use) {
        for (std::size_t kind = 0; kind < kStateKindCount; ++kind) {
            if (statements_[kind] != nullptr) use(static_cast<StateKind>(kind), statements_[kind]);
            statements_[kind] = nullptr;
        }
        are_any_ = false;
    }

 private:
    std::array<const char*, kStateKindCount> statements_{};
    bool are_any_ = false;
};

/// A statement about the triangles from one of the chunk's on.
struct StateChange {
    const char* statement = nullptr;
    std::uint32_t first_triangle = 0;
    StateKind kind = StateKind::object;
};

/// A polygon, laid down as a fan because a corner is not in its chunk, or came later.
struct LatePolygon {
    std::uint32_t first_triangle = 0;
    std::uint32_t triangle_count = 0;
};

/// Shape: `colors`, `uv_indices` and `normal_indices` are empty, or as long as `positions` or
/// `triangles`. Indices are those of the whole file, triangles counted from the chunk's first.
struct Chunk {
    Counts before{};  // in the file

    std::vector<Vec3> positions{};
    std::vector<Vec3> normals{};  // unit; 0 where the file gives no direction
    std::vector<Vec2> uvs{};
    std::vector<Color> colors{};
    std::vector<IndexTriple> triangles{};
    std::vector<IndexTriple> normal_indices{};
    std::vector<IndexTriple> uv_indices{};
    std::vector<LatePolygon> late_polygons{};
    std::vector<StateChange> changes{};
    std::vector<const char*> libraries{};  // the `mtllib` statements
    const char* first_free_form = nullptr;
    std::size_t free_form_count = 0;
    bool has_zero_normals = false;
};

class ChunkBuilder {
 public:
    /// `before`: the statements of the file before the chunk.
    explicit ChunkBuilder(const Counts& before = {}) { chunk_.before = before; }

    /// Reserves memory for so many statements.
    void reserve(const Counts& counts);

    void add_position(Vec3 position) {
        chunk_.positions.push_back(position);
        if (!chunk_.colors.empty()) chunk_.colors.push_back(kWhite);
    }
    /// Of the position added last; in [0, 1] and linear.
    void set_color(Color color);
    void add_uv(Vec2 uv) { chunk_.uvs.push_back(uv); }

    /// Any length; that of 0 is no normal.
    void add_normal(DVec3 direction);

    /// Adds the triangles of a polygon. Its corners may refer to what is added later.
    /// Shape: 3 corners or more.
    void add_face(std::span<const Corner> corners);

    void begin(StateKind kind, const char* statement) { pending_.set(kind, statement); }
    void add_library(const char* statement) { chunk_.libraries.push_back(statement); }
    void skip_free_form(const char* statement) {
        if (chunk_.free_form_count++ == 0) chunk_.first_free_form = statement;
    }

    /// So many there are in the file up to here.
    std::size_t position_count() const { return chunk_.before.positions + chunk_.positions.size(); }
    std::size_t uv_count() const { return chunk_.before.uvs + chunk_.uvs.size(); }
    std::size_t normal_count() const { return chunk_.before.normals + chunk_.normals.size(); }

    Chunk finish();

 private:
    static constexpr Color kWhite{1.0f};

    void add_triangle(const Corner& a, const Corner& b, const Corner& c, bool has_uvs,
                      bool has_normals);
    void keep_changes();
    bool is_here(const Corner& corner) const {
        return corner.position - chunk_.before.positions < chunk_.positions.size();
    }

    Chunk chunk_{};
    PendingStates pending_{};
    PolygonTriangulator triangulator_{};
    std::vector<Vec3> polygon_{};
};

}  // namespace lray::scene::obj
