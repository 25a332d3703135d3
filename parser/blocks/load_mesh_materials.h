// The materials that a mesh file names, with their pictures.
#pragma once

#include "base/diagnostics.h"
#include "base/source.h"
#include "parser/file_loader.h"
#include "scene/scene.h"

namespace lray::parser {

/// Reads the files with materials that a mesh names, and gives it those of its materials that they
/// define; once for all meshes of one file.
/// Errors: false when one was reported: E0701 and its like in the file, E0703 in a picture, limits.
/// W1701 at `span` or in the file: what is missing.
bool load_mesh_materials(scene::MeshId mesh_id, Span span, FileLoader& files, scene::Scene& scene,
                         Diagnostics& diagnostics);

}  // namespace lray::parser
