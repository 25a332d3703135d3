// Reads Wavefront OBJ.
#pragma once

#include <optional>

#include "base/diagnostics.h"
#include "base/source.h"
#include "scene/mesh.h"

namespace lray::scene {

/// Returns the mesh of an OBJ file held in `sources`: v, vt, vn, f with negative and polygon
/// indices, g and o as parts; other statements are skipped.
/// Errors: empty when an error was reported at its place in the file (E0701 syntax, E0702 index
/// out of range, E0704 no faces), with a label at `loaded_at`.
std::optional<Mesh> read_obj(const Sources& sources, SourceId file, Span loaded_at,
                             Diagnostics& diagnostics);

}  // namespace lray::scene
