// Names in OBJ and MTL statements: the words after the keyword.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lray::scene::obj {

/// Returns what follows the keyword of a statement, its words joined by one blank. A `#` is part of
/// a name: tools write such. Shape: `statement` points into a Text.
std::string name_at(const char* statement);

/// Returns the files that an `mtllib` statement names. A name ends with the line or, if more
/// follows, with a word that ends in `.mtl`: names may have blanks, which stay as they are. A
/// backslash joins no lines here: it is one of a path.
std::vector<std::string> files_at(const char* statement);

/// Returns the number of a smoothing group; 0 for `off`, 0 and nothing at all.
std::uint32_t smoothing_group_at(const char* statement);

}  // namespace lray::scene::obj
