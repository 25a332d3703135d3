// The light of one sample, added up so that the order does not matter.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/numerics.h"
#include "base/vec.h"

namespace lray::shade {

/// Sums contributions that are 0 or greater as integers in steps of 2^-32: rays of a sample are
/// followed in whatever order suits those of others. Sums end at 2^30, contributions at 2^29.
class SampleSum {
 public:
    void add(Color contribution) {
        for (int channel = 0; channel < 3; ++channel) {
            const double value = static_cast<double>(contribution[channel]);
            if (std::isnan(value)) {
                is_nan_ = true;
                continue;
            }
            const double steps = std::clamp(value, 0.0, kMaxValue) * kOne;
            sum_[channel] = std::min(sum_[channel] + nearest_whole(steps), kMaxSum);
        }
    }

    /// NaN if a contribution was.
    Color color() const {
        if (is_nan_) return Color{std::numeric_limits<float>::quiet_NaN()};
        Color result{};
        for (int channel = 0; channel < 3; ++channel) {
            result[channel] = static_cast<float>(static_cast<double>(sum_[channel]) / kOne);
        }
        return result;
    }

 private:
    static constexpr double kOne = 0x1p32;
    static constexpr double kMaxValue = 0x1p29;
    static constexpr std::int64_t kMaxSum = std::int64_t{1} << 62;

    std::int64_t sum_[3] = {0, 0, 0};
    bool is_nan_ = false;
};

}  // namespace lray::shade
