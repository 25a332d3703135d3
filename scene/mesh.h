// Triangle meshes, shared by all nodes that use them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec.h"
#include "scene/ids.h"

namespace lray::scene {

/// Three indices into one of the arrays of a mesh, counter-clockwise from the front.
using IndexTriple = std::array<std::uint32_t, 3>;

/// A named stretch of a mesh's triangles: an OBJ `g` or `o`.
struct MeshPart {
    std::string name{};
    std::uint32_t first_triangle = 0;
    std::uint32_t triangle_count = 0;
};

/// The triangles from one on, up to the next run, that a file gives the material of a name.
struct MaterialRun {
    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::uint32_t first_triangle = 0;
    std::uint32_t material = kNone;  // into Mesh::material_names; kNone: the file gives none
};

/// Shape: `normal_indices` and `uv_indices` are empty or as long as `triangles`. A triple in
/// `normal_indices` whose first index is kNone has no normals of its own, likewise uvs. `colors` is
/// empty or as long as `positions`. `material_runs` rise; none begins before the first triangle
/// that has a material. `materials` is empty or as long as `material_names`.
/// Space: the file's; normals are unit, colours linear and in [0, 1].
struct Mesh {
    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::string file{};  // the path from the directory of the scene; empty: not from a file

    std::vector<Vec3> positions{};
    std::vector<Vec3> normals{};
    std::vector<Vec2> uvs{};
    std::vector<Color> colors{};
    std::vector<IndexTriple> triangles{};
    std::vector<IndexTriple> normal_indices{};
    std::vector<IndexTriple> uv_indices{};
    std::vector<MeshPart> parts{};
    std::vector<std::uint32_t> parts_by_name{};  // by index_parts(); files may have a million
    std::vector<MaterialRun> material_runs{};
    std::vector<std::string> material_names{};  // each once
    std::vector<std::string> material_files{};  // that define them, as the file names them
    std::vector<MaterialId> materials{};        // by name, once they are read; none: not defined

    std::optional<double> smooth_degrees{};  // of smooth_by_angle(), which made its normals
};

/// Orders the parts for parts_named(), once they are all there.
void index_parts(Mesh& mesh);

/// Returns the run that a triangle is in, by its index; empty before the first run.
std::optional<std::size_t> material_run_at(const Mesh& mesh, std::size_t triangle);

/// Returns the indices of the parts of a name, in the order of the file.
std::span<const std::uint32_t> parts_named(const Mesh& mesh, std::string_view name);

}  // namespace lray::scene
