// Makes a mesh of the chunks of an OBJ file.
#pragma once

#include <optional>
#include <vector>

#include "scene/formats/obj_chunk.h"
#include "scene/mesh.h"

namespace lray::scene::obj {

/// So many files with materials of one mesh are kept, and one more to tell that there are others.
inline constexpr std::size_t kMaxMaterialFiles = 64;

/// Returns the mesh of all chunks of a file in their order, the same however the file was cut;
/// empty if it has no triangles or an index is out of range. The text must still be there.
std::optional<Mesh> assemble(std::vector<Chunk> chunks);

}  // namespace lray::scene::obj
