// Random numbers for tests: the same on every machine, from a seed that failures print.
#pragma once

#include <cstdint>

#include "base/vec.h"

namespace lray::test {

/// SplitMix64. Source: Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators".
class Random {
 public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    /// In [0, n), n > 0; the bias of n / 2^64 does not matter here.
    std::uint64_t below(std::uint64_t n) { return bits() % n; }

    /// In [low, high).
    double uniform(double low = 0.0, double high = 1.0) {
        return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
    }

    /// Each coordinate in [low, high).
    Vec3 vec3(double low, double high) {
        const double x = uniform(low, high);
        const double y = uniform(low, high);
        const double z = uniform(low, high);
        return {x, y, z};
    }

 private:
    std::uint64_t state_;
};

}  // namespace lray::test

/// Prints the seed with every failure in this scope.
#define LRAY_TRACE_SEED(seed) SCOPED_TRACE(::testing::Message() << "seed " << (seed))
