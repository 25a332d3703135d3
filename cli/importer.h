// Where the program is that imports meshes by Assimp.
#pragma once

#include <string>

namespace lray::cli {

/// Returns the path of `lray-import`: in `../libexec/lray` of the program's directory when it is
/// installed, beside the program when it is built or unpacked; empty if it is in neither.
std::string importer_program();

}  // namespace lray::cli
