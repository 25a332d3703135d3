#include "render/film.h"

#include <algorithm>
#include <cmath>

#include "base/numerics.h"

namespace lray::render {

namespace {

constexpr double kOne = 4294967296.0;  // 2^32: 1.0 in Q31.32

static_assert(static_cast<double>(Film::kMaxValue) * kOne * Film::kMaxSamples < 0x1p63);
// In standard_error(): n times the sum of the squares.
static_assert(static_cast<double>(Film::kMaxValue) * kOne * Film::kMaxSamples *
                  static_cast<double>(Film::kMaxValue) * kOne * Film::kMaxSamples <
              0x1p127);

}  // namespace

Film::Film(std::uint32_t width, std::uint32_t height, Keeps keeps)
    : width_(width),
      height_(height),
      pixels_(std::size_t{width} * height),
      squares_(keeps == Keeps::squares ? pixels_.size() : 0) {}

void Film::add(std::uint32_t x, std::uint32_t y, const Color& sample) {
    LRAY_DCHECK(x < width_ && y < height_);
    const std::size_t place = std::size_t{y} * width_ + x;
    Pixel& target = pixels_[place];
    LRAY_ASSERT(target.sample_count < kMaxSamples);
    ++target.sample_count;
    if (std::isnan(sample.r) || std::isnan(sample.g) || std::isnan(sample.b)) {
        ++counts_.nan;
        return;
    }
    bool is_clamped = false;
    const auto steps_of = [&is_clamped](float light) {
        const float value = std::clamp(light, -kMaxValue, kMaxValue);
        is_clamped = is_clamped || value != light;
        return nearest_whole(static_cast<double>(value) * kOne);  // exact product
    };
    const std::int64_t steps[3] = {steps_of(sample.r), steps_of(sample.g), steps_of(sample.b)};
    for (int channel = 0; channel < 3; ++channel) target.sum[channel] += steps[channel];
    if (is_clamped) ++counts_.clamped;
    if (squares_.empty()) return;
    for (int channel = 0; channel < 3; ++channel) {
        const Wide size = static_cast<std::uint64_t>(std::abs(steps[channel]));
        squares_[place].sum[channel] += size * size;
    }
}

Color Film::resolve(std::uint32_t x, std::uint32_t y) const {
    const Pixel& source = pixel(x, y);
    if (source.sample_count == 0) return Color{0.0f};
    const double scale = 1.0 / (kOne * source.sample_count);  // of one sample exact
    const auto mean = [scale](std::int64_t sum) {
        return static_cast<float>(static_cast<double>(sum) * scale);
    };
    return {mean(source.sum[0]), mean(source.sum[1]), mean(source.sum[2])};
}

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
