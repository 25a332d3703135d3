// Files that the command line names, beside the scene.
#pragma once

#include <string>

#include "base/file_access.h"

namespace lray::cli {

/// Returns why such a file was not read, as the end of a sentence that begins with its name.
/// Shape: its status is not `ok`.
std::string why_unread(const ReadResult& file);

}  // namespace lray::cli
