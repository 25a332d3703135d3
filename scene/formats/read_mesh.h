// Which files hold meshes, and reading them: the one entry to all formats.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/diagnostics.h"
#include "base/source.h"
#include "scene/formats/import_mesh.h"
#include "scene/mesh.h"

namespace lray::scene {

enum class MeshFormat : std::uint8_t { obj, ply, imported };

/// Returns the format of a file by the ending of its name, in any letter case; of one that ends
/// otherwise OBJ; empty for an ending that is known to be that of another format.
std::optional<MeshFormat> mesh_format_of(std::string_view path);

/// Returns the mesh of a file held in `sources`; `import` is for formats that a program of its own
/// reads.
/// Errors: empty when an error was reported at its place in the file, with a label at `loaded_at`
/// unless that is nowhere.
std::optional<Mesh> read_mesh(MeshFormat format, const Sources& sources, SourceId file,
                              Span loaded_at, const ImportSettings& import,
                              Diagnostics& diagnostics);

}  // namespace lray::scene
