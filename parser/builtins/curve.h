// Smooth curves through points.
#pragma once

#include <cstddef>
#include <span>

#include "base/vec.h"

namespace lray::parser {

struct CurvePoint {
    DVec3 position{};
    DVec3 tangent{};  // in the direction of growing t; 0 where the curve stands still
};

/// Returns the point at t of the uniform Catmull-Rom curve through the points, which it reaches at
/// equal distances of t, the first at 0 and the last at 1. Beyond the ends it stays there.
/// Shape: rows of three numbers, one row at least.
/// Source: Catmull, Rom 1974, "A class of local interpolating splines"; at the ends the points next
/// to them are mirrored.
CurvePoint curve_point(std::span<const double> rows, double t);

}  // namespace lray::parser
