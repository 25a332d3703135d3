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

std::uint64_t Film::sample_count() const {
    std::uint64_t count = 0;
    for (const Pixel& pixel : pixels_) count += pixel.sample_count;
    return count;
}

Film Film::part(std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height) const {
    LRAY_ASSERT(width <= width_ && x <= width_ - width);
    LRAY_ASSERT(height <= height_ && y <= height_ - height);
    Film result(width, height, keeps());
    for (std::size_t row = 0; row < height; ++row) {
        const auto from = static_cast<std::ptrdiff_t>((y + row) * width_ + x);
        const auto to = static_cast<std::ptrdiff_t>(row * width);
        std::copy_n(pixels_.begin() + from, width, result.pixels_.begin() + to);
        if (squares_.empty()) continue;
        std::copy_n(squares_.begin() + from, width, result.squares_.begin() + to);
    }
    return result;
}

void Film::set_part(std::uint32_t x, std::uint32_t y, const Film& part) {
    LRAY_ASSERT(part.width_ <= width_ && x <= width_ - part.width_);
    LRAY_ASSERT(part.height_ <= height_ && y <= height_ - part.height_);
    LRAY_ASSERT(part.keeps() == keeps());
    for (std::size_t row = 0; row < part.height_; ++row) {
        const auto from = static_cast<std::ptrdiff_t>(row * part.width_);
        const auto to = static_cast<std::ptrdiff_t>((y + row) * width_ + x);
        std::copy_n(part.pixels_.begin() + from, part.width_, pixels_.begin() + to);
        if (squares_.empty()) continue;
        std::copy_n(part.squares_.begin() + from, part.width_, squares_.begin() + to);
    }
}

void Film::add_film(const Film& other) {
    LRAY_ASSERT(other.width_ == width_ && other.height_ == height_ && other.keeps() == keeps());
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        const Pixel& more = other.pixels_[i];
        LRAY_ASSERT(more.sample_count <= kMaxSamples - pixels_[i].sample_count);
        pixels_[i].sample_count += more.sample_count;
        for (int channel = 0; channel < 3; ++channel) {
            pixels_[i].sum[channel] += more.sum[channel];
            if (squares_.empty()) continue;
            squares_[i].sum[channel] += other.squares_[i].sum[channel];
        }
    }
    counts_ += other.counts_;
}

image::Image Film::picture() const {
    image::Image result(width_, height_);
    for (std::uint32_t y = 0; y < height_; ++y) {
        for (std::uint32_t x = 0; x < width_; ++x) result.at(x, y) = resolve(x, y);
    }
    return result;
}

}  // namespace lray::render
