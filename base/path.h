// Paths as text: joining, tidying and taking apart, without a look at the file system.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lray {

/// Returns the names between the slashes, without empty ones and ".".
std::vector<std::string_view> path_components(std::string_view path);

/// Returns what precedes the last name: "a/b" -> "a", "b" -> ".", "/b" -> "/".
std::string directory_of(std::string_view path);

/// Returns what follows the last slash.
std::string_view file_name_of(std::string_view path);

/// Returns `path` as seen from `directory`, tidy: no "." and no "x/.." that `path` brings in.
/// `directory` keeps its own "..", as it may lead through a symbolic link; an absolute path
/// replaces it.
std::string join_paths(std::string_view directory, std::string_view path);

/// Returns the path made absolute by the current directory, without "." and "..".
std::string absolute_path(std::string_view path);

}  // namespace lray
