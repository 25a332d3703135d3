// Reads what the importing program has written, of which nothing is believed.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>

#include "scene/formats/import_wire.h"
#include "scene/mesh.h"

namespace lray::scene {

/// Why the program has no mesh, in its words.
struct ImportFailure {
    wire::Failure kind{};
    std::string reason{};
};

/// How the colours of a format are written.
enum class ColorCoding : std::uint8_t { linear, srgb };

/// Returns the mesh, which may have no triangles, or why there is none; empty if the bytes are no
/// answer: sizes that do not fit, vertices that do not exist, positions that are not finite.
/// Normals and texture coordinates that are not finite are none; colours are clamped.
std::optional<std::variant<Mesh, ImportFailure>> read_import_answer(std::span<const char> bytes,
                                                                    ColorCoding coding);

}  // namespace lray::scene
