#include "render/film.h"

#include <algorithm>
#include <cmath>

namespace lray::render {

namespace {

constexpr double kOne = 4294967296.0;  // 2^32: 1.0 in Q31.32

static_assert(static_cast<double>(Film::kMaxValue) * kOne * Film::kMaxSamples < 0x1p63);

}  // namespace

Film::Film(std::uint32_t width, std::uint32_t height)
    : width_(width), height_(height), pixels_(std::size_t{width} * height) {}

void Film::add(std::uint32_t x, std::uint32_t y, Color sample) {
    LRAY_DCHECK(x < width_ && y < height_);
    Pixel& target = pixels_[std::size_t{y} * width_ + x];
    LRAY_ASSERT(target.sample_count < kMaxSamples);
    ++target.sample_count;
    if (std::isnan(sample.r) || std::isnan(sample.g) || std::isnan(sample.b)) {
        ++counts_.nan;
        return;
    }
    bool is_clamped = false;
    for (int channel = 0; channel < 3; ++channel) {
        const float value = std::clamp(sample[channel], -kMaxValue, kMaxValue);
        is_clamped = is_clamped || value != sample[channel];
        target.sum[channel] += std::llrint(static_cast<double>(value) * kOne);  // exact product
    }
    if (is_clamped) ++counts_.clamped;
}

Color Film::resolve(std::uint32_t x, std::uint32_t y) const {
    const Pixel& source = pixel(x, y);
    if (source.sample_count == 0) return Color{0.0f};
    const double scale = kOne * source.sample_count;  // exact
    Color mean{0.0f};
    for (int channel = 0; channel < 3; ++channel) {
        mean[channel] = static_cast<float>(static_cast<double>(source.sum[channel]) / scale);
    }
    return mean;
}

}  // namespace lray::render
