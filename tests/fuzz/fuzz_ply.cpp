// Fuzzes the PLY reader; whatever it accepts must be a mesh that can be traced.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/assert.h"
#include "base/diagnostics.h"
#include "base/source.h"
#include "scene/formats/ply_reader.h"
#include "scene/mesh.h"

namespace {

using lray::scene::IndexTriple;
using lray::scene::Mesh;

void check(const Mesh& mesh) {
    LRAY_ASSERT(!mesh.triangles.empty());
    for (const IndexTriple& triple : mesh.triangles) {
        for (const std::uint32_t index : triple) LRAY_ASSERT(index < mesh.positions.size());
    }
    for (const lray::Vec3 p : mesh.positions) {
        LRAY_ASSERT(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    }
    // Attributes are those of the vertices, with the same numbers.
    LRAY_ASSERT(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size());
    LRAY_ASSERT(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size());
    LRAY_ASSERT(mesh.colors.empty() || mesh.colors.size() == mesh.positions.size());
    for (const lray::Color c : mesh.colors) {
        for (int i = 0; i < 3; ++i) LRAY_ASSERT(c[i] >= 0.0f && c[i] <= 1.0f);
    }
    for (const auto* triples : {&mesh.normal_indices, &mesh.uv_indices}) {
        LRAY_ASSERT(triples->empty() || triples->size() == mesh.triangles.size());
        for (std::size_t i = 0; i < triples->size(); ++i) {
            const IndexTriple& triple = (*triples)[i];
            LRAY_ASSERT(triple[0] == Mesh::kNone || triple == mesh.triangles[i]);
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    lray::Sources sources;
    lray::Diagnostics diagnostics;
    const lray::SourceId file = sources.add(
        "fuzz.ply", lray::Text(std::string_view(reinterpret_cast<const char*>(data), size)));
    const auto mesh = lray::scene::read_ply(sources, file, lray::Span{}, diagnostics);
    LRAY_ASSERT(mesh.has_value() == !diagnostics.has_errors());
    if (mesh) check(*mesh);
    return 0;
}
