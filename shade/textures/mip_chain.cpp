#include "shade/textures/mip_chain.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assert.h"
#include "image/image.h"
#include "shade/textures/code_values.h"

namespace lray::shade {

namespace {

using image::CodedImage;
using image::Image;

/// The pixels of a line that one of fewer pixels stands for: those at either end by a share alone.
struct Covered {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    double first_share = 1.0;
    double last_share = 1.0;

    /// Shape: at < small <= large. In whole numbers: the shares of a pixel add up to 1.
    Covered(std::uint32_t at, std::uint32_t small, std::uint32_t large) {
        const std::uint64_t begin = std::uint64_t{at} * large;
        const std::uint64_t end = begin + large;
        first = static_cast<std::uint32_t>(begin / small);
        last = static_cast<std::uint32_t>((end - 1) / small);
        first_share = 1.0 - static_cast<double>(begin % small) / small;
        last_share = 1.0 - static_cast<double>(std::uint64_t{last + 1} * small - end) / small;
    }

    double share(std::uint32_t i) const {
        return i == first ? first_share : i == last ? last_share : 1.0;
    }
};

/// Rows that one task takes, so that it has some work to do.
std::size_t rows_of_task(std::uint32_t width) {
    constexpr std::size_t kPixels = std::size_t{1} << 14;
    return kPixels / width + 1;
}

/// Returns a picture of that size; `pixel` returns the linear colour of each pixel of the larger.
template <class Pixel>
Image shrunk(std::uint32_t width, std::uint32_t height, std::uint32_t small_width,
             std::uint32_t small_height, const Pixel& pixel) {
    Image small(small_width, small_height);
    const double area =
        static_cast<double>(width) / small_width * (static_cast<double>(height) / small_height);
    const auto shrink_rows = [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t y = range.begin(); y != range.end(); ++y) {
            const Covered rows(static_cast<std::uint32_t>(y), small_height, height);
            for (std::uint32_t x = 0; x < small_width; ++x) {
                const Covered columns(x, small_width, width);
                DVec3 sum{0.0};
                for (std::uint32_t j = rows.first; j <= rows.last; ++j) {
                    for (std::uint32_t i = columns.first; i <= columns.last; ++i) {
                        sum += rows.share(j) * columns.share(i) * DVec3{pixel(i, j)};
                    }
                }
                small.pixels[y * small_width + x] = Color{sum / area};
            }
        }
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, small_height, rows_of_task(small_width)),
                      shrink_rows);
    return small;
}

CodedImage encoded(const Image& linear, const CodeValues& values) {
    CodedImage coded{linear.width, linear.height, {}};
    coded.rgb.resize(3 * linear.pixels.size());
    const auto encode = [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            for (std::size_t channel = 0; channel < 3; ++channel) {
                coded.rgb[3 * i + channel] =
                    values.nearest_code(linear.pixels[i][static_cast<int>(channel)]);
            }
        }
    };
    constexpr std::size_t kGrain = std::size_t{1} << 12;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, linear.pixels.size(), kGrain), encode);
    return coded;
}

/// What a level is as a picture of its kind.
CodedImage level_of(const CodedImage&, const Image& linear, const CodeValues& values) {
    return encoded(linear, values);
}
Image level_of(const Image&, const Image& linear, const CodeValues&) {
    return linear;
}

Color linear_at(const CodedImage& picture, std::uint32_t x, std::uint32_t y,
                const CodeValues& values) {
    const auto [r, g, b] = picture.at(x, y);
    return Color{values.linear[r], values.linear[g], values.linear[b]};
}
Color linear_at(const Image& picture, std::uint32_t x, std::uint32_t y, const CodeValues&) {
    return picture.at(x, y);
}

}  // namespace

template <class Level>
BasicMipChain<Level>::BasicMipChain(const Level& picture, bool is_srgb) : picture_(&picture) {
    LRAY_ASSERT(picture.width > 0 && picture.height > 0);
    const CodeValues& values = code_values(is_srgb);
    std::uint32_t width = picture.width;
    std::uint32_t height = picture.height;
    // Each level is made of the exact means of the one before: roundings do not add up.
    Image last;
    while (width > 1 || height > 1) {
        const std::uint32_t small_width = std::max(width / 2, 1u);
        const std::uint32_t small_height = std::max(height / 2, 1u);
        if (smaller_.empty()) {
            last = shrunk(
                width, height, small_width, small_height,
                [&](std::uint32_t x, std::uint32_t y) { return linear_at(picture, x, y, values); });
        } else {
            last = shrunk(width, height, small_width, small_height,
                          [&](std::uint32_t x, std::uint32_t y) {
                              return last.pixels[std::size_t{y} * width + x];
                          });
        }
        smaller_.push_back(level_of(picture, last, values));
        width = small_width;
        height = small_height;
    }
}

template class BasicMipChain<CodedImage>;
template class BasicMipChain<Image>;

}  // namespace lray::shade
