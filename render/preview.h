// Pictures in steps, from coarse to fine: what is shown first after a change.
#pragma once

#include <cstdint>
#include <vector>

#include "render/options.h"
#include "render/sample_tracer.h"

namespace lray::render {

/// The side of the squares of the first step, in pixels, where it is not known how fast rays are;
/// each further step halves it, and that of single pixels is the first of the average.
inline constexpr std::uint32_t kUsualSquare = 8;
inline constexpr std::uint32_t kLargestSquare = 64;

/// Returns the side of the squares to begin with, a power of two: the smallest with which the
/// first step is expected to take no longer than kFirstStepSeconds, kUsualSquare if the seconds a
/// ray takes, all threads together, are not known (0).
std::uint32_t first_square(double seconds_per_ray, std::uint64_t pixel_count);
inline constexpr double kFirstStepSeconds = 0.03;

/// Returns the pixels that stand for the squares of a part, those in their middles, row by row.
/// Shape: the part begins at a multiple of `square` in the full picture.
std::vector<FilmPlace> middles_of_squares(const PixelRect& part, std::uint32_t square);

}  // namespace lray::render
