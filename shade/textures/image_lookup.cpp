#include "shade/textures/image_lookup.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "shade/textures/cell.h"

namespace lray::shade {

namespace {

/// Returns where in the picture, in [0, 1], a coordinate shows. NaN is 0.
double wrapped(double x, scene::ImageWrap wrap) {
    if (wrap == scene::ImageWrap::clamp) return x > 0.0 ? std::min(x, 1.0) : 0.0;
    const Cell cell(x);
    const bool is_mirrored = wrap == scene::ImageWrap::mirror && cell.is_odd();
    return is_mirrored ? 1.0 - cell.inside : cell.inside;
}

/// Two neighbouring pixels of a line, and how far it is from the first to the second.
struct Neighbours {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    float share = 0.0f;

    /// Shape: x in [0, 1]. Colours are those of the middles of pixels.
    Neighbours(double x, std::uint32_t count, scene::ImageWrap wrap) {
        const double at = x * count + 0.5;  // at least 1/2: truncation rounds down
        const auto above = static_cast<std::uint32_t>(at);
        share = static_cast<float>(at - above);
        // Pixels above - 1 and above, of which one may lie beyond the border.
        const bool comes_again = wrap == scene::ImageWrap::repeat;
        first = above > 0 ? above - 1 : comes_again ? count - 1 : 0;
        second = above < count ? above : comes_again ? 0 : count - 1;
    }
};

/// How high up the chain: a fraction between two levels.
struct Height {
    std::size_t lower = 0;
    float share = 0.0f;  // of the level above

    /// `pixels` lie side by side in the footprint. Level i is where there are 2^i; between two the
    /// share grows with the number itself rather than its logarithm, from which it differs by less
    /// than 0.09: each processor comes to the same bits.
    explicit Height(double pixels) {
        if (!(pixels > 1.0)) return;      // NaN too
        constexpr double kMost = 0x1p40;  // beyond the last level of any picture
        const std::uint64_t bits = std::bit_cast<std::uint64_t>(std::min(pixels, kMost));
        lower = static_cast<std::size_t>((bits >> 52) - 1023);
        const std::uint64_t mantissa = (bits & 0xfffffffffffffu) | 0x3ff0000000000000u;
        share = static_cast<float>(std::bit_cast<double>(mantissa) - 1.0);
    }
};

}  // namespace

template <class Level>
BasicImageLookup<Level>::BasicImageLookup(const scene::ImageTexture& image,
                                          const BasicMipChain<Level>& chain)
    : chain_(&chain),
      values_(&code_values(image.is_srgb)),
      wrap_(image.wrap),
      filter_(image.filter) {}

template <class Level>
DVec3 BasicImageLookup<Level>::color(const DVec3& p, const Footprint& footprint) const {
    const double u = wrapped(p.x, wrap_);
    const double v = 1.0 - wrapped(p.y, wrap_);  // rows count from the top
    const Level& picture = chain_->level(0);
    const double reach_u = std::max(footprint.extent.x, footprint.across) * picture.width;
    const double reach_v = std::max(footprint.extent.y, footprint.across) * picture.height;
    const Height height(std::max(reach_u, reach_v));

    const std::size_t last = chain_->level_count() - 1;
    if (height.lower >= last && last > 0) return DVec3{linear(chain_->level(last), 0)};
    const std::size_t i = std::min(height.lower, last);
    const bool is_blocky = i == 0 && filter_ == scene::ImageFilter::nearest;
    const DVec3 lower = is_blocky ? nearest(u, v) : bilinear(chain_->level(i), u, v);
    if (!(height.share > 0.0f) || i == last) return lower;
    const DVec3 upper = bilinear(chain_->level(i + 1), u, v);
    return lower + double{height.share} * (upper - lower);
}

template <class Level>
DVec3 BasicImageLookup<Level>::bilinear(const Level& level, double u, double v) const {
    const Neighbours x(u, level.width, wrap_);
    const Neighbours y(v, level.height, wrap_);
    const auto blend = [](Color a, Color b, float share) { return a + share * (b - a); };
    const auto row = [&](std::uint32_t j) {
        const std::size_t first = std::size_t{level.width} * j;
        return blend(linear(level, first + x.first), linear(level, first + x.second), x.share);
    };
    return DVec3{blend(row(y.first), row(y.second), y.share)};
}

template <class Level>
DVec3 BasicImageLookup<Level>::nearest(double u, double v) const {
    const Level& picture = chain_->level(0);
    const auto x = std::min(static_cast<std::uint32_t>(u * picture.width), picture.width - 1);
    const auto y = std::min(static_cast<std::uint32_t>(v * picture.height), picture.height - 1);
    return DVec3{linear(picture, std::size_t{y} * picture.width + x)};
}

template class BasicImageLookup<image::CodedImage>;
template class BasicImageLookup<image::Image>;

}  // namespace lray::shade
