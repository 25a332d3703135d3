// Procedural noise: random but smooth functions of a point in one, two or three dimensions. All of
// it is arithmetic that every processor does alike, and works for any finite point: on a lattice
// that never repeats up to 2^62.
#pragma once

#include <cstdint>

#include "base/random.h"
#include "base/vec.h"

namespace lray {

/// Which of the noises: made of any keys, once.
struct NoiseSeed {
    std::uint64_t bits = 0;

    constexpr NoiseSeed() = default;
    explicit constexpr NoiseSeed(KeyedRandom random) : bits(random.bits()) {}
};

/// Returns gradient noise in [-1, 1], with two continuous derivatives; 0 where all coordinates are
/// whole.
/// Source: Perlin 2002, "Improving Noise"; gradients are hashed, not permuted by a table.
double noise(double p, NoiseSeed seed);
double noise(DVec2 p, NoiseSeed seed);
double noise(DVec3 p, NoiseSeed seed);

/// The mean square of 3-dimensional noise, and that of its slope along an axis; measured over 2e7
/// points.
inline constexpr double kNoiseVariance = 0.0679;
inline constexpr double kNoiseSquaredSlope = 0.462;

/// Octaves of noise, each `lacunarity` times finer and `gain` times as strong as the one before.
struct Octaves {
    static constexpr int kMaxCount = 32;

    int count = 5;            // 1 to kMaxCount
    double lacunarity = 2.0;  // greater than 0
    double gain = 0.5;        // 0 or greater
};

/// Returns fractional Brownian motion in [-1, 1]: a weighted mean of octaves of noise, which are
/// moved against each other, so that whole coordinates are nothing special.
/// Source: Musgrave 2003, in Ebert et al., "Texturing and Modeling", 3rd ed., ch. 16.
double fbm(double p, const Octaves& octaves, NoiseSeed seed);
double fbm(DVec2 p, const Octaves& octaves, NoiseSeed seed);
double fbm(DVec3 p, const Octaves& octaves, NoiseSeed seed);

/// Returns how much of noise is left when it is averaged over a width, in cells of its lattice: all
/// of it up to half a cell, and nothing from a cell on, where one sample for each width could not
/// tell it from other noise.
constexpr double noise_left(double width) {
    if (!(width > 0.5)) return 1.0;  // NaN too
    return width < 1.0 ? 2.0 - 2.0 * width : 0.0;
}

/// Likewise, averaged over about `width`: each octave counts for what is left of it.
double fbm(DVec3 p, const Octaves& octaves, NoiseSeed seed, double width);

/// Returns ridged multifractal noise in [-1, 1]: sharp crests near 1, and detail on them alone.
/// Source: Musgrave 2003, in Ebert et al., "Texturing and Modeling", 3rd ed., ch. 16.
double ridged(double p, const Octaves& octaves, NoiseSeed seed);
double ridged(DVec2 p, const Octaves& octaves, NoiseSeed seed);
double ridged(DVec3 p, const Octaves& octaves, NoiseSeed seed);

/// Returns the distance to the nearest feature point, of which each unit cell has one: 0 or
/// greater, at most the square root of the number of dimensions, rarely more than 1.
/// Source: Worley 1996, "A Cellular Texture Basis Function" (F1; one point in each cell).
double worley(double p, NoiseSeed seed);
double worley(DVec2 p, NoiseSeed seed);
double worley(DVec3 p, NoiseSeed seed);

}  // namespace lray
