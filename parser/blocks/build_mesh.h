// Property values to meshes: from a file, or from lists in the scene.
#pragma once

#include <array>
#include <optional>

#include "base/diagnostics.h"
#include "parser/blocks/property_values.h"
#include "parser/file_loader.h"
#include "scene/scene.h"

namespace lray::parser {

/// Returns the use of the mesh that the properties describe; a mesh that is new joins the scene.
/// A block that has a `material` of its own does not show those of its file.
/// Errors: empty; what the file loader reports, E0403 no such part, E0411 `normals` and `smooth`,
/// E0702 index, E0704 empty, each at the property's value; W1701 as load_mesh_materials().
std::optional<scene::MeshUse> build_mesh(const PropertyValues& values,
                                         const std::array<Span, kMaxProperties>& value_spans,
                                         Span span, bool has_material, FileLoader& files,
                                         scene::Scene& scene, Diagnostics& diagnostics);

/// True if a mesh without a material of its own is shown in the colours of its vertices: it has
/// them, and its file defines no materials.
bool shows_own_colors(const scene::Mesh& mesh);

/// Returns a new material like the default one that shows the colours of vertices.
scene::MaterialId add_vertex_colors_material(scene::Scene& scene);

}  // namespace lray::parser
