// Reads Wavefront OBJ.
#pragma once

#include <optional>

#include "base/diagnostics.h"
#include "base/source.h"
#include "scene/mesh.h"

namespace lray::scene {

/// Returns the mesh of an OBJ file held in `sources`: `v`, `vt`, `vn`; `f` with positive, negative
/// and forward indices, polygons cut into triangles; `g` and `o` as parts, where a part of an
/// object contains the parts of its groups and those without faces are left out. Weights, colours
/// and other statements are skipped.
/// A face of which a corner lacks a normal has none, likewise uvs; a normal of length 0 stays zero
/// and no face refers to it.
/// Errors: empty when an error was reported at its place in the file (E0003 binary, E0701
/// syntax, E0702 index out of range, E0704 no faces, E0705 a face with too many corners), with a
/// label at `loaded_at` unless that is nowhere.
std::optional<Mesh> read_obj(const Sources& sources, SourceId file, Span loaded_at,
                             Diagnostics& diagnostics);

}  // namespace lray::scene
