// File names that resemble one that was not found.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/descriptor.h"
#include "base/open_beneath.h"

namespace lray {

/// Returns the names in a directory, sorted, without "." and "..": of a huge directory some, of
/// what is none, none.
std::vector<std::string> names_in(Descriptor directory);

/// Returns the name most like `name`; empty when nothing is near.
std::string nearest_file_name(std::string_view name, const std::vector<std::string>& names);

struct Resemblance {
    std::string same_but_case{};  // the whole path, if all its names exist in some letter case
    std::string nearest{};        // else a name close to the last, if only that is missing
};

/// Looks below the directory `root` for files with a name like that of the relative path.
Resemblance find_resemblance(int root, const std::string& path, BeneathMethod method);

}  // namespace lray
