// The light of one sample, added up so that the order does not matter.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/vec.h"

namespace lray::shade {

/// Sums contributions that are 0 or greater as integers in steps of 2^-32: rays of a sample are
/// followed in whatever order suits those of others. Sums end at 2^30, contributions at 2^29.
class SampleSum {
 public:
    void add(const Color& contribution) {
        add_to(sum_[0], contribution.r);
        add_to(sum_[1], contribution.g);
        add_to(sum_[2], contribution.b);
    }

    /// NaN if a contribution was.
    Color color() const {
        if (is_nan_) return Color{std::numeric_limits<float>::quiet_NaN()};
        return {light_of(sum_[0]), light_of(sum_[1]), light_of(sum_[2])};
    }

 private:
    static constexpr double kOne = 0x1p32;
    static constexpr double kMaxValue = 0x1p29;
    static constexpr std::int64_t kMaxSum = std::int64_t{1} << 62;

    void add_to(std::int64_t& sum, float contribution) {
        const double value = static_cast<double>(contribution);
        is_nan_ = is_nan_ || std::isnan(value);
        const double steps = std::min(std::max(0.0, value), kMaxValue) * kOne;  // of NaN 0
        sum = std::min(sum + static_cast<std::int64_t>(steps + 0.5), kMaxSum);
    }
    static float light_of(std::int64_t sum) {
        return static_cast<float>(static_cast<double>(sum) * (1.0 / kOne));
    }

    std::int64_t sum_[3] = {0, 0, 0};
    bool is_nan_ = false;
};

}  // namespace lray::shade
