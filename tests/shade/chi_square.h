// Whether directions are chosen with the density that is said: Pearson's chi-square test.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "base/vec.h"

namespace lray::test {

/// The part of the sphere that is divided into bins, as z and turns about z.
struct SphereWindow {
    double low_z = -1.0;
    double high_z = 1.0;
    int points_per_side = 32;  // of the quadrature in a bin: more where the density has edges
};

/// Chooses directions with random numbers: none where the choice came to nothing.
using DirectionSampler = std::function<std::optional<Vec3>(double choice, DVec2 u)>;
/// The density of a direction per solid angle.
using DirectionDensity = std::function<double(Vec3)>;

/// Returns how probable it is that samples of that density lie as unevenly as these do, or more.
/// Samples outside of the window and those that came to nothing are a bin of their own, with what
/// the integral of the density over the window leaves to 1. Source: Wilson, Hilferty 1931, "The
/// Distribution of Chi-square".
double chi_square_probability(const DirectionSampler& sampler, const DirectionDensity& density,
                              std::uint64_t seed, const SphereWindow& window = {});

}  // namespace lray::test
