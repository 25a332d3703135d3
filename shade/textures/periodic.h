// Functions that repeat in each unit, averaged by their integral.
#pragma once

#include "shade/textures/cell.h"

namespace lray::shade {

/// Returns the mean of a periodic function over the width around x; of a width of 0 its value.
/// Shape: for t in [0, 1], profile.value(t) is the function and profile.integral(t) that from 0.
template <class Profile>
auto mean_of_periodic(const Profile& profile, double x, double width) {
    // What is narrower is all but a point, and differences of integrals would lose its digits; what
    // is wider is all but everything.
    constexpr double kNarrow = 0x1p-20;
    constexpr double kWide = 0x1p30;
    const Cell cell(x);
    if (!(width > kNarrow)) return profile.value(cell.inside);
    const auto whole = profile.integral(1.0);
    if (width > kWide) return whole;
    const auto integral = [&](double to) {
        const Cell end(to);
        return static_cast<double>(end.index) * whole + profile.integral(end.inside);
    };
    return (integral(cell.inside + 0.5 * width) - integral(cell.inside - 0.5 * width)) / width;
}

}  // namespace lray::shade
