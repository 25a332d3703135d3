// Meshes of formats that are read by a program of its own, in which Assimp is confined.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/source.h"
#include "scene/mesh.h"

namespace lray::scene {

/// The program, and what one file may take.
struct ImportSettings {
    std::string program{};  // empty: there is none
    std::uint32_t seconds = 60;
    std::uint64_t bytes = std::uint64_t{4} << 30;
};

/// Returns the ending of a file name, in lower case, if it is that of a format that is imported:
/// "stl"; else nothing.
std::string_view imported_ending(std::string_view path);

/// Returns the mesh of a file held in `sources`, whose name has such an ending. Its nodes are moved
/// to their places and are parts of their names; materials and pictures are left out.
/// Errors: empty when one error was reported at `loaded_at`, whatever the program did: E0701 not
/// understood, E0704 no faces, E0705 no program, E0516 beyond the limits.
std::optional<Mesh> import_mesh(const Sources& sources, SourceId file, Span loaded_at,
                                const ImportSettings& settings, Diagnostics& diagnostics);

}  // namespace lray::scene
