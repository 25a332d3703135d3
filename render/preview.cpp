#include "render/preview.h"

#include <algorithm>

namespace lray::render {

std::uint32_t first_square(double seconds_per_ray, std::uint64_t pixel_count) {
    if (!(seconds_per_ray > 0.0)) return kUsualSquare;
    const double seconds = seconds_per_ray * static_cast<double>(pixel_count);
    std::uint32_t square = 1;
    while (square < kLargestSquare && seconds > kFirstStepSeconds * square * square) square *= 2;
    return square;
}

std::vector<FilmPlace> middles_of_squares(const PixelRect& part, std::uint32_t square) {
    std::vector<FilmPlace> middles;
    for (std::uint32_t y = part.y0; y < part.y1; y += square) {
        for (std::uint32_t x = part.x0; x < part.x1; x += square) {
            middles.push_back(
                {x + std::min(square, part.x1 - x) / 2, y + std::min(square, part.y1 - y) / 2});
        }
    }
    return middles;
}

}  // namespace lray::render
