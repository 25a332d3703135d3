// Where the library `std:` is on this machine.
#pragma once

#include <string>

namespace lray::cli {

/// Returns the directory of the bundled library: `../share/lray/std` of the program's directory
/// when it is installed, `std` beside the program when it is built or unpacked. Where neither is
/// there, the first.
std::string library_directory();

}  // namespace lray::cli
