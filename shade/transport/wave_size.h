// How many rays are followed together.
#pragma once

#include <cstddef>

namespace lray::shade {

/// Rays of a wave: enough to share what they have in common, few enough to stay in the cache.
inline constexpr std::size_t kMaxWaveSize = 64;

}  // namespace lray::shade
