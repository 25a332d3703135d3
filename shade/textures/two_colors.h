// Two colours in turn: what checkers and stripes have in common.
#pragma once

#include "base/vec.h"

namespace lray::shade {

/// Cells are moved by this share of their size, so that a face that lies on a border of cells is
/// in one of them, whatever rounding does to its points: it would speckle.
inline constexpr double kBorderShift = 1.0 / 1024.0;

/// Returns the colour for the mean of a wave that is 1 in `a` and -1 in `b`; exactly one of them
/// at either end.
inline DVec3 in_turn(DVec3 a, DVec3 b, double mean) {
    return mix(b, a, 0.5 + 0.5 * mean);
}

}  // namespace lray::shade
