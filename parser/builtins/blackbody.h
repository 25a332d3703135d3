// The colour of light by its temperature.
#pragma once

#include "base/vec.h"

namespace lray::parser {

inline constexpr double kCoolestBlackbody = 1000.0;  // kelvin
inline constexpr double kHottestBlackbody = 40000.0;

/// Returns the colour of a black body that glows at a temperature in kelvin, linear RGB, scaled so
/// that the largest component is 1. What RGB cannot show is cut off: no component is negative.
/// Shape: kCoolestBlackbody to kHottestBlackbody.
DVec3 blackbody_color(double kelvin);

}  // namespace lray::parser
