// Frames of an animation: how many, and what the options of each are.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "cli/options.h"

namespace lray::cli {

/// True if the file name has a run of `#`, which stands for the number of a frame.
bool has_frame_number(std::string_view path);

/// Returns the path with the last run of `#` of its file name replaced by the number, zeros before
/// it as far as the run is longer: ("out-####.png", 7) -> "out-0007.png".
std::string numbered_path(std::string_view path, std::uint64_t frame);

/// How many pictures are asked for: one, if nothing is said of frames.
std::uint64_t frame_count(const Options& options);

/// Returns the options of one picture: its frame, its output, its label.
/// Shape: index < frame_count(options).
Options options_of_frame(const Options& options, std::uint64_t index);

}  // namespace lray::cli
