// Opening a file below a directory without ever leaving it, whatever symbolic links lie there.
#pragma once

#include <cstdint>
#include <string>

#include "base/descriptor.h"

namespace lray {

/// Who makes sure that the path stays below the directory.
enum class BeneathMethod : std::uint8_t {
    kernel,  // openat2 (Linux 5.6) with RESOLVE_BENEATH and RESOLVE_NO_MAGICLINKS
    walk,    // one component at a time with O_NOFOLLOW; links are read and followed by hand
};

/// Returns `kernel` where openat2 works: older kernels and some sandboxes lack it.
BeneathMethod best_beneath_method();

struct OpenedBeneath {
    Descriptor file{};
    int error = 0;  // errno; EXDEV: it leads outside
};

/// Opens the relative path below the directory `root` with the flags of open(2); nothing is ever
/// created. Absolute links lead outside.
OpenedBeneath open_beneath(int root, const std::string& path, int flags,
                           BeneathMethod method = best_beneath_method());

}  // namespace lray
