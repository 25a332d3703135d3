// Limits so small that any input ends in milliseconds; each is met the same way at any size.
#pragma once

#include <cstdint>

#include "parser/load.h"

namespace lray::fuzz {

inline constexpr parser::LoadLimits kSmallLimits{.scene_bytes = std::uint64_t{1} << 20,
                                                 .mesh_bytes = std::uint64_t{1} << 20,
                                                 .texture_bytes = std::uint64_t{1} << 20,
                                                 .texture_pixels = std::uint64_t{1} << 16,
                                                 .nesting = 256,
                                                 .include_depth = 8,
                                                 .files = 32,
                                                 .steps = 100'000,
                                                 .value_bytes = std::uint64_t{16} << 20,
                                                 .call_depth = 200,
                                                 .list_size = 100'000,
                                                 .nodes = 10'000,
                                                 .printed_bytes = std::uint64_t{1} << 16};

}  // namespace lray::fuzz
