// Octaves of noise as textures use them: what is finer than the footprint becomes uncertainty.
#pragma once

#include <array>
#include <cstdint>

#include "base/noise.h"
#include "base/vec.h"

namespace lray::shade {

class FractalNoise {
 public:
    FractalNoise(const Octaves& octaves, double seed);

    /// The noise of a footprint.
    struct Value {
        double mean = 0.0;    // in [-1, 1]
        double spread = 0.0;  // the width of an even distribution that varies as much as the noise
    };

    /// Returns the noise averaged over about `width`; of a width of 0 that of the language's fbm().
    /// What is not finite is 0.
    Value at(DVec3 p, double width) const;

 private:
    /// How much the noise varies inside of the width.
    double variance(double width) const;

    Octaves octaves_;
    NoiseSeed seed_;
    std::array<double, Octaves::kMaxCount> squared_shares_{};  // of each octave in the sum
};

}  // namespace lray::shade
