#include "render/film.h"

#include <algorithm>
#include <cmath>

namespace lray::render {

namespace {

constexpr double kOne = Film::kStepsOfOne;
constexpr double kMostSteps = static_cast<double>(Film::kMaxValue) * kOne * Film::kMaxSamples;
static_assert(kMostSteps < 0x1p63);
static_assert(kMostSteps * kMostSteps < 0x1p127);  // n times the sum of the squares

}  // namespace

Film::Film(std::uint32_t width, std::uint32_t height, Keeps keeps)
    : width_(width),
      height_(height),
      pixels_(std::size_t{width} * height),
      squares_(keeps == Keeps::squares ? pixels_.size() : 0) {}

Color Film::standard_error(std::uint32_t x, std::uint32_t y) const {
    const Pixel& source = pixel(x, y);
    LRAY_ASSERT(!squares_.empty() && source.sample_count >= 2);
    const std::uint32_t n = source.sample_count;
    Color error{0.0f};
    for (int channel = 0; channel < 3; ++channel) {
        const std::int64_t sum = source.sum[channel];
        const Wide size = static_cast<std::uint64_t>(sum < 0 ? -sum : sum);
        const Wide squares = squares_[std::size_t{y} * width_ + x].sum[channel];
        // n^2 (n - 1) times the square of the error; not negative, by Cauchy and Schwarz.
        const Wide scaled = n * squares - size * size;
        error[channel] =
            static_cast<float>(std::sqrt(static_cast<double>(scaled) / (n - 1)) / n / kOne);
    }
    return error;
}

}  // namespace lray::render
