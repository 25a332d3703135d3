// Where in a pixel a sample lies: a function of the seed, the pixel of the full picture and the
// sample alone, never of a thread, a tile, a crop or the samples before it.
#pragma once

#include <cstdint>

#include "base/random.h"
#include "base/vec.h"
#include "render/options.h"

namespace lray::render {

/// The random numbers of a sample come in pairs: pair 0 is the position in the pixel, and what else
/// is chosen at random for the sample has a pair of its own.
inline constexpr std::uint64_t kPositionPair = 0;

/// Returns two numbers of a sample, each uniform in [0, 1) and a multiple of 2^-32: the halves of
/// one keyed number, three mixes of 64 bits in all.
inline DVec2 sample_pair(std::uint64_t seed, std::uint32_t x, std::uint32_t y, std::uint32_t sample,
                         std::uint64_t pair) {
    const std::uint64_t bits = KeyedRandom{}
                                   .with_bits(seed)
                                   .with_bits(std::uint64_t{y} << 32 | x)
                                   .with_bits(pair << 32 | sample)
                                   .bits();
    return {static_cast<double>(bits >> 32) * 0x1p-32,
            static_cast<double>(bits & 0xffffffffu) * 0x1p-32};
}

/// Returns the position of a sample in the full picture: the centre of its pixel, or anywhere in
/// it.
inline DVec2 sample_position(PixelPosition position, std::uint64_t seed, std::uint32_t x,
                             std::uint32_t y, std::uint32_t sample) {
    const DVec2 corner{x, y};
    if (position == PixelPosition::center) return corner + DVec2{0.5};
    return corner + sample_pair(seed, x, y, sample, kPositionPair);
}

}  // namespace lray::render
