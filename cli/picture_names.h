// Under which name the viewer saves a picture.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cli/options.h"

namespace lray::cli {

/// So many pictures of a scene get a number.
inline constexpr int kMaxPictureNumber = 999;

/// Returns where the next picture goes: to `-o`, with the number of the frame in place of `####`;
/// without it, to the first of "scene-001.png", "scene-002.png" and so on that is free in the
/// current directory, with the extension of `--format`. Without a name of its own the scene is
/// called "scene".
/// Errors: empty when all numbers are taken, and `problem` tells so in a sentence.
std::optional<std::string> next_picture_name(const Options& options, std::string& problem);

/// "a/room.lrs" -> "room"; "scene" where nothing is left, and for stdin.
std::string scene_stem(std::string_view scene_path);

}  // namespace lray::cli
