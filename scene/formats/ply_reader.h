// Reads PLY, the polygon file format of Stanford.
#pragma once

#include <optional>

#include "base/diagnostics.h"
#include "base/source.h"
#include "scene/mesh.h"

namespace lray::scene {

/// Returns the mesh of a PLY file held in `sources`, in text or binary of either byte order: `x`,
/// `y`, `z` and, where they are there, normals, colours and texture coordinates of `vertex`;
/// `vertex_indices` of `face`, polygons cut into triangles, and of `tristrips`. Other elements and
/// properties are skipped, in any order. A normal of length 0 or that is not finite stays zero and
/// no triangle refers to it.
/// Errors: empty when an error was reported: at its place where that is text, with a label at
/// `loaded_at` unless that is nowhere, else at `loaded_at` (E0003 binary, E0701 not understood,
/// E0702 index out of range, E0704 no faces, E0705 another version, or beyond a limit).
std::optional<Mesh> read_ply(const Sources& sources, SourceId file, Span loaded_at,
                             Diagnostics& diagnostics);

}  // namespace lray::scene
