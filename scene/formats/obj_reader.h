// Reads Wavefront OBJ.
#pragma once

#include <cstddef>
#include <optional>

#include "base/diagnostics.h"
#include "base/source.h"
#include "scene/mesh.h"

namespace lray::scene {

/// A file is cut into pieces of about this size, which are read at the same time.
inline constexpr std::size_t kObjChunkSize = std::size_t{8} << 20;

/// Returns the mesh of an OBJ file held in `sources`, the same for any number of threads:
/// - `v` with a weight, which is skipped, or a colour as sRGB codes from 0 to 1; a vertex without
///   one is white if others have them. `vt`, `vn`;
/// - `f` with positive, negative and forward indices, polygons cut into triangles. A face of which
///   a corner lacks a normal has none, likewise uvs; a normal of length 0 stays zero and no face
///   refers to it;
/// - `g` and `o` as parts, where a part of an object contains the parts of its groups and those
///   without faces are left out;
/// - `usemtl` and `mtllib`;
/// - `s`: faces of a group other than 0 that have no normals get smooth ones (smooth_by_groups).
/// Other statements are skipped.
/// Errors: empty when an error was reported at its place in the file (E0003 binary, E0701
/// syntax, E0702 index out of range, E0704 no faces, E0705 a face with too many corners), with a
/// label at `loaded_at` unless that is nowhere; likewise W1704, free-form curves and surfaces.
std::optional<Mesh> read_obj(const Sources& sources, SourceId file, Span loaded_at,
                             Diagnostics& diagnostics, std::size_t chunk_size = kObjChunkSize);

}  // namespace lray::scene
