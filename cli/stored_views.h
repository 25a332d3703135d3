// Views stored beside a scene, nine at most: a file of cameras that the viewer reads and writes.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "base/file_access.h"
#include "scene/camera.h"

namespace lray::cli {

/// Views have the numbers from 1 to this.
inline constexpr int kMaxStoredViews = 9;

/// Views by their number.
using StoredViews = std::map<int, scene::Camera>;

/// "a/scene.lrs" -> "a/scene.views.lrs"; what does not end so gets `.views.lrs` behind it. Empty
/// for stdin, which has no place for views.
std::string views_path(std::string_view scene_path);

/// Reads the cameras "view 1" to "view 9" of a file as views_path() names it; others are passed
/// over. It is a scene like any other, from a stranger like any other: `files` decides what may be
/// read, what it may cost is limited, and it says nothing but `problem`.
/// Errors: none, and `problem` tells why in a sentence. A file that is not there is no problem.
StoredViews read_views(const std::string& path, FileAccess& files, std::string& problem);

/// Writes the views in place of those that the file holds; their names are left to the number.
/// Shape: numbers from 1 to kMaxStoredViews.
/// Errors: what went wrong, in a sentence; empty when all is well. A file that holds anything but
/// views as they are written here, or leads elsewhere, is left as it is.
std::string write_views(const std::string& path, const StoredViews& views);

}  // namespace lray::cli
