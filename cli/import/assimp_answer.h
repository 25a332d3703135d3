// What Assimp makes of the bytes of a file, as scene/formats/import_wire.h says it.
#pragma once

#include <span>
#include <string_view>

namespace lray::import {

/// Imports the bytes of a file with that ending and writes the answer to a descriptor. Nothing is
/// thrown.
/// Errors: false if the answer cannot be written.
bool answer(std::span<const char> bytes, std::string_view ending, int descriptor);

}  // namespace lray::import
