// The wave that checkers and stripes are made of, averaged without sampling.
#pragma once

#include <algorithm>
#include <cmath>

#include "shade/textures/cell.h"

namespace lray::shade {

/// Returns the integral from 0 of the wave that is 1 from 0 to 1, -1 from 1 to 2, and so on.
inline double square_wave_integral(double x) {
    return 1.0 - std::fabs(1.0 - 2.0 * Cell(0.5 * x).inside);
}

/// Returns the mean of that wave over the width around x; of a width of 0 its value there. Exactly
/// 1 or -1 where no edge is reached; NaN counts as 0.
inline double mean_square_wave(double x, double width) {
    const Cell cell(x);
    const double value = cell.is_odd() ? -1.0 : 1.0;
    const double half = 0.5 * width;
    const double to_edge = std::min(cell.inside, 1.0 - cell.inside);
    if (!(half > to_edge)) return value;
    // Up to a width of 1 one edge is reached at most.
    if (width <= 1.0) return value * (1.0 - 2.0 * (half - to_edge) / width);
    constexpr double kManyCells = 0x1p30;  // the mean is less than 1 / width
    if (width > kManyCells) return 0.0;
    return value *
           (square_wave_integral(cell.inside + half) - square_wave_integral(cell.inside - half)) /
           width;
}

}  // namespace lray::shade
