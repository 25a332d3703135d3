#include "parser/blocks/build_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/angle.h"
#include "base/did_you_mean.h"
#include "base/numerics.h"
#include "parser/blocks/build_texture.h"
#include "parser/blocks/load_mesh_materials.h"
#include "parser/blocks/schemas.h"
#include "parser/values/operators.h"
#include "scene/smooth_normals.h"

namespace lray::parser {

namespace {

using namespace schemas;

constexpr std::size_t kFile = slot(kMesh, "file");
constexpr std::size_t kPart = slot(kMesh, "part");
constexpr std::size_t kUp = slot(kMesh, "up");
constexpr std::size_t kPositions = slot(kMesh, "positions");
constexpr std::size_t kTriangles = slot(kMesh, "triangles");
constexpr std::size_t kNormals = slot(kMesh, "normals");
constexpr std::size_t kUvs = slot(kMesh, "uvs");
constexpr std::size_t kSmooth = slot(kMesh, "smooth");
constexpr std::size_t kUseMtl = slot(kMesh, "use_mtl");
constexpr std::size_t kColors = slot(kMesh, "colors");

std::optional<std::uint32_t> find_part(const scene::Mesh& mesh, std::string_view name, Span span,
                                       Diagnostics& diagnostics) {
    const std::span<const std::uint32_t> parts = scene::parts_named(mesh, name);
    if (!parts.empty()) return parts.front();
    std::vector<std::string_view> names;
    if (diagnostics.takes_hints()) {
        for (const scene::MeshPart& part : mesh.parts) names.push_back(part.name);
    }
    diagnostics.error(Code::E0403, span, fmt::format("this mesh has no part `{}`", name))
        .with_hint(did_you_mean(name, names));
    return std::nullopt;
}

/// Returns the unit normal. One that was made unit and rounded to float once stays as it is,
/// however it was written.
Vec3 unit_in_float(DVec3 normal) {
    const Vec3 rounded{normal};
    const double square = dot(DVec3{rounded}, DVec3{rounded});
    // The square of numbers that carry one rounding each carries two, and a little from before.
    const bool is_unit = std::fabs(square - 1.0) <= double{gamma<float>(3)};
    return is_unit ? rounded : Vec3{glm::normalize(normal)};
}

/// A mesh from lists; all its numbers must fit a float.
std::optional<scene::Mesh> mesh_of_lists(const PropertyValues& values,
                                         const std::array<Span, kMaxProperties>& value_spans,
                                         Diagnostics& diagnostics) {
    scene::Mesh mesh;
    const Value& positions = values[kPositions];
    const Value& triangles = values[kTriangles];
    if (values.has(kNormals) && values.has(kSmooth)) {
        diagnostics.error(Code::E0411, value_spans[kSmooth],
                          "give `normals` or `smooth`, not both");
        return std::nullopt;
    }
    if (triangles.count == 0) {
        diagnostics.error(Code::E0704, value_spans[kTriangles], "this mesh has no triangles");
        return std::nullopt;
    }
    mesh.positions.reserve(positions.count);
    for (std::size_t i = 0; i < positions.count; ++i) {
        const double* p = positions.numbers + 3 * i;
        const Vec3 position{DVec3{p[0], p[1], p[2]}};
        for (int axis = 0; axis < 3; ++axis) {
            if (std::isfinite(position[axis])) continue;
            diagnostics.error(
                Code::E0304, value_spans[kPositions],
                fmt::format("row {} of `positions` is too large: {}", i, format_number(p[axis])));
            return std::nullopt;
        }
        mesh.positions.push_back(position);
    }
    mesh.triangles.reserve(triangles.count);
    for (std::size_t i = 0; i < triangles.count; ++i) {
        scene::IndexTriple triple{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const double index = triangles.numbers[3 * i + corner];
            if (index >= positions.count) {
                diagnostics.error(Code::E0702, value_spans[kTriangles],
                                  fmt::format("row {} of `triangles` names vertex {} of {}", i,
                                              format_number(index), positions.count));
                return std::nullopt;
            }
            triple[corner] = static_cast<std::uint32_t>(index);
        }
        mesh.triangles.push_back(triple);
    }
    const auto one_per_vertex = [&](std::size_t property) {
        if (!values.has(property) || values[property].count == positions.count) return true;
        diagnostics.error(
            Code::E0303, value_spans[property],
            fmt::format("`{}` needs {} rows, one for each vertex; this has {}",
                        kMesh[property].name, positions.count, values[property].count));
        return false;
    };
    if (!one_per_vertex(kNormals) || !one_per_vertex(kUvs) || !one_per_vertex(kColors)) {
        return std::nullopt;
    }
    if (values.has(kNormals)) {
        for (std::size_t i = 0; i < positions.count; ++i) {
            const double* n = values[kNormals].numbers + 3 * i;
            const DVec3 normal{n[0], n[1], n[2]};
            if (normal == DVec3{0.0}) {
                diagnostics.error(Code::E0304, value_spans[kNormals],
                                  fmt::format("row {} of `normals` is [0, 0, 0]", i));
                return std::nullopt;
            }
            mesh.normals.push_back(unit_in_float(normal));
        }
        mesh.normal_indices = mesh.triangles;
    }
    if (values.has(kUvs)) {
        for (std::size_t i = 0; i < positions.count; ++i) {
            const double* uv = values[kUvs].numbers + 2 * i;
            mesh.uvs.push_back(Vec2{DVec2{uv[0], uv[1]}});
        }
        mesh.uv_indices = mesh.triangles;
    }
    if (values.has(kColors)) {
        for (std::uint32_t i = 0; i < positions.count; ++i) {
            const Value color = element(values[kColors], i);
            mesh.colors.push_back(
                Color{color.is(ValueKind::number) ? DVec3{color.number} : color.vec3()});
        }
    }
    if (values.has(kSmooth)) {
        mesh.smooth_degrees = values.number(kSmooth);
        scene::smooth_by_angle(mesh, radians(*mesh.smooth_degrees));
    }
    return mesh;
}

}  // namespace

std::optional<scene::MeshUse> build_mesh(const PropertyValues& values,
                                         const std::array<Span, kMaxProperties>& value_spans,
                                         Span span, bool has_material, FileLoader& files,
                                         scene::Scene& scene, Diagnostics& diagnostics) {
    scene::MeshUse use;
    use.z_is_up = values.string(kUp, "y") == "z";
    if (!values.has(kFile)) {
        std::optional<scene::Mesh> mesh = mesh_of_lists(values, value_spans, diagnostics);
        if (!mesh) return std::nullopt;
        use.mesh_id = scene::MeshId(scene.meshes.size());
        scene.meshes.push_back(std::move(*mesh));
        return use;
    }
    const Value& file = values[kFile];
    const Span file_span = value_spans[kFile].is_nowhere() ? span : value_spans[kFile];
    std::optional<double> smooth_degrees;
    if (values.has(kSmooth)) smooth_degrees = values.number(kSmooth);
    const std::optional<scene::MeshId> mesh_id =
        files.mesh(file.string(), file.source, file_span, smooth_degrees, scene);
    if (!mesh_id) return std::nullopt;
    use.mesh_id = *mesh_id;
    use.shows_materials = values.boolean(kUseMtl) && !has_material;
    if (use.shows_materials &&
        !load_mesh_materials(*mesh_id, file_span, files, scene, diagnostics)) {
        return std::nullopt;
    }
    if (values.has(kPart)) {
        const Span part_span = value_spans[kPart].is_nowhere() ? span : value_spans[kPart];
        const std::optional<std::uint32_t> part = find_part(
            scene.meshes[mesh_id->index()], values[kPart].string(), part_span, diagnostics);
        if (!part) return std::nullopt;
        use.part = *part;
    }
    return use;
}

bool shows_own_colors(const scene::Mesh& mesh) {
    const auto is_defined = [](scene::MaterialId id) { return !id.is_none(); };
    return !mesh.colors.empty() &&
           std::none_of(mesh.materials.begin(), mesh.materials.end(), is_defined);
}

scene::MaterialId add_vertex_colors_material(scene::Scene& scene) {
    const scene::TextureId texture = add_texture(vertex_colors(), scene);
    scene::Material material;
    material.diffuse = {scene.textures[texture.index()].average, texture};
    const scene::MaterialId id(scene.materials.size());
    scene.materials.push_back(material);
    return id;
}

}  // namespace lray::parser
