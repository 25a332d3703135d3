// What a camera decides by random numbers: the keys of PixelSample. They are below 16; whatever
// else is decided for a sample takes keys from there on.
#pragma once

#include <cstdint>

namespace lray::render {

inline constexpr std::uint64_t kPositionDecision = 0;  // where in its pixel the ray goes
inline constexpr std::uint64_t kLensDecision = 1;      // from where on the lens it comes

}  // namespace lray::render
