// The random numbers that a picture is made of: functions of the seed, the pixel of the full
// picture, the sample and what is decided by them, never of a thread, a tile, a crop or the samples
// before. Nothing is advanced.
#pragma once

#include <cstdint>

#include "base/random.h"
#include "base/vec.h"

namespace lray {

/// How the samples of a pixel lie: spread evenly (a scrambled Sobol sequence), or each on its own.
enum class SamplerKind : std::uint8_t { sobol, random };

/// Returns the bits in reverse order.
constexpr std::uint32_t reverse_bits(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    return __builtin_bswap32(x);
}

/// Owen's nested uniform scrambling of a number, its lowest bit first: each bit is flipped or not
/// as the seed and the bits below it say.
/// Source: Laine, Karras 2011, "Stratified Sampling for Stochastic Transparency", sec. 3.1, with
/// the constants of Vegdahl 2021, "Building a Better LK Hash".
constexpr std::uint32_t scramble_from_lowest(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// Likewise, its highest bit first.
constexpr std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) {
    return reverse_bits(scramble_from_lowest(reverse_bits(x), seed));
}

/// Returns the bits, in reverse, of the second coordinate of point `index` of the Sobol sequence,
/// in steps of 2^-32; those of the first are the index itself. Pascal's triangle modulo 2 times the
/// bits of the index. Source: Sobol 1967; the factors of the matrix as in Ahmed 2024, "An
/// Implementation Algorithm of 2D Sobol Sequence Fast, Elegant, and Compact".
constexpr std::uint32_t sobol_second_reversed(std::uint32_t index) {
    index ^= (index & 0xaaaaaaaau) >> 1;
    index ^= (index & 0xccccccccu) >> 2;
    index ^= (index & 0xf0f0f0f0u) >> 4;
    index ^= (index & 0xff00ff00u) >> 8;
    index ^= (index & 0xffff0000u) >> 16;
    return index;
}

/// One sample of one pixel. Decisions are told apart by their keys: any 64 bits.
struct PixelSample {
    SamplerKind kind = SamplerKind::sobol;
    std::uint64_t pixel_key = 0;  // of the seed and the pixel
    std::uint32_t index = 0;      // which sample of the pixel

    static PixelSample of(SamplerKind kind, std::uint64_t seed, std::uint32_t x, std::uint32_t y,
                          std::uint32_t index) {
        const KeyedRandom pixel =
            KeyedRandom{}.with_bits(seed).with_bits(std::uint64_t{y} << 32 | x);
        return {kind, pixel.bits(), index};
    }

    /// Returns two numbers, each uniform in [0, 1) and a multiple of 2^-32. Those of one decision
    /// in all samples of a pixel are independent of those of other decisions and pixels.
    /// Source: Burley 2020, "Practical Hash-based Owen Scrambling".
    DVec2 pair(std::uint64_t decision) const { return point(decision, index); }

    /// Likewise, pair `part` of the `part_count` that the sample needs of this decision: those of
    /// all samples together lie as those of one sequence.
    DVec2 pair(std::uint64_t decision, std::uint32_t part, std::uint32_t part_count) const {
        return point(decision, index * part_count + part);
    }

    double number(std::uint64_t decision) const { return pair(decision).x; }

 private:
    DVec2 point(std::uint64_t decision, std::uint32_t place) const {
        const std::uint64_t key = mix_bits(pixel_key + decision);
        if (kind == SamplerKind::random) return halves(mix_bits(key + place));
        const std::uint64_t more = mix_bits(key);
        const std::uint32_t shuffled = owen_scramble(place, static_cast<std::uint32_t>(key));
        // Both coordinates are at hand in reverse, as their scrambling takes them.
        const auto seed_x = static_cast<std::uint32_t>(more >> 32);
        const auto seed_y = static_cast<std::uint32_t>(more);
        const std::uint32_t second = sobol_second_reversed(shuffled);
        return numbers(reverse_bits(scramble_from_lowest(shuffled, seed_x)),
                       reverse_bits(scramble_from_lowest(second, seed_y)));
    }

    static DVec2 halves(std::uint64_t bits) {
        return numbers(static_cast<std::uint32_t>(bits >> 32), static_cast<std::uint32_t>(bits));
    }
    static DVec2 numbers(std::uint32_t x, std::uint32_t y) {
        return {static_cast<double>(x) * 0x1p-32, static_cast<double>(y) * 0x1p-32};
    }
};

}  // namespace lray
