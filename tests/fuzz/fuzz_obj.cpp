// Fuzzes the OBJ reader; whatever it accepts must be a mesh that can be traced.
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/assert.h"
#include "base/diagnostics.h"
#include "base/source.h"
#include "scene/formats/obj_reader.h"
#include "scene/mesh.h"
#include "scene/smooth_normals.h"

namespace {

using lray::scene::IndexTriple;
using lray::scene::Mesh;

/// Triples of `indices` lie in an array of `size`, but for those that say that they have none.
void check_attributes(const std::vector<IndexTriple>& indices, std::size_t triangle_count,
                      std::size_t size) {
    LRAY_ASSERT(indices.empty() || indices.size() == triangle_count);
    for (const IndexTriple& triple : indices) {
        if (triple[0] == Mesh::kNone) continue;
        for (const std::uint32_t index : triple) LRAY_ASSERT(index < size);
    }
}

void check(const Mesh& mesh) {
    LRAY_ASSERT(!mesh.triangles.empty());
    for (const IndexTriple& triple : mesh.triangles) {
        for (const std::uint32_t index : triple) LRAY_ASSERT(index < mesh.positions.size());
    }
    check_attributes(mesh.normal_indices, mesh.triangles.size(), mesh.normals.size());
    check_attributes(mesh.uv_indices, mesh.triangles.size(), mesh.uvs.size());
    LRAY_ASSERT(mesh.colors.empty() || mesh.colors.size() == mesh.positions.size());
    for (const lray::scene::MaterialRun& run : mesh.material_runs) {
        LRAY_ASSERT(run.first_triangle < mesh.triangles.size());
        LRAY_ASSERT(run.material < mesh.material_names.size() ||
                    run.material == lray::scene::MaterialRun::kNone);
    }
    for (const lray::scene::MeshPart& part : mesh.parts) {
        LRAY_ASSERT(part.first_triangle <= mesh.triangles.size());
        LRAY_ASSERT(part.triangle_count <= mesh.triangles.size() - part.first_triangle);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    lray::Sources sources;
    lray::Diagnostics diagnostics;
    const lray::SourceId file = sources.add(
        "fuzz.obj", lray::Text(std::string_view(reinterpret_cast<const char*>(data), size)));
    const auto mesh = lray::scene::read_obj(sources, file, lray::Span{}, diagnostics);
    LRAY_ASSERT(mesh.has_value() == !diagnostics.has_errors());
    if (mesh) check(*mesh);
    // Cut into small pieces it is the same.
    lray::Diagnostics told_again;
    constexpr std::size_t kSmall = 16;
    auto pieces = lray::scene::read_obj(sources, file, lray::Span{}, told_again, kSmall);
    LRAY_ASSERT(pieces.has_value() == mesh.has_value());
    if (!mesh) return 0;
    LRAY_ASSERT(pieces->triangles == mesh->triangles && pieces->uv_indices == mesh->uv_indices);
    LRAY_ASSERT(pieces->normals == mesh->normals && pieces->colors == mesh->colors);
    LRAY_ASSERT(pieces->parts.size() == mesh->parts.size());
    LRAY_ASSERT(pieces->positions == mesh->positions);
    lray::scene::smooth_by_angle(*pieces, 0.5);
    check(*pieces);
    return 0;
}
