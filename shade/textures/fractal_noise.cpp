#include "shade/textures/fractal_noise.h"

#include <algorithm>
#include <cmath>

namespace lray::shade {

FractalNoise::FractalNoise(const Octaves& octaves, double seed)
    : octaves_(octaves), seed_(KeyedRandom{}.with(seed)) {
    double weights = 0.0;
    double weight = 1.0;
    for (int i = 0; i < octaves.count; ++i, weight *= octaves.gain) weights += weight;
    weight = 1.0;
    for (int i = 0; i < octaves.count; ++i, weight *= octaves.gain) {
        const double share = weight / weights;
        squared_shares_[static_cast<std::size_t>(i)] = share * share;
    }
}

double FractalNoise::variance(double width) const {
    double sum = 0.0;
    for (int i = 0; i < octaves_.count; ++i, width *= octaves_.lacunarity) {
        const double left = noise_left(width);
        // Over less than a cell what is left is about a slope, whose even distribution over the
        // width has a variance of 1/12 of its square, in each of two directions.
        const double slope = std::min(kNoiseSquaredSlope * width * width / 6.0, kNoiseVariance);
        sum += squared_shares_[static_cast<std::size_t>(i)] *
               (left * left * slope + (1.0 - left * left) * kNoiseVariance);
    }
    return sum;
}

FractalNoise::Value FractalNoise::at(DVec3 p, double width) const {
    const double mean = fbm(p, octaves_, seed_, width);
    if (!std::isfinite(mean)) return {};
    // An even distribution has a variance of 1/12 of its width squared.
    return {mean, width > 0.0 ? std::sqrt(12.0 * variance(width)) : 0.0};
}

}  // namespace lray::shade
