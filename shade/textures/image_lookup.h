// Looks pictures up: between their pixels, outside of them, and from afar.
#pragma once

#include "base/vec.h"
#include "scene/texture.h"
#include "shade/textures/code_values.h"
#include "shade/textures/footprint.h"
#include "shade/textures/mip_chain.h"

namespace lray::shade {

/// Of pictures in codes, and in light.
template <class Level>
class BasicImageLookup {
 public:
    /// The chain, which is that of the texture's picture, must outlive it.
    BasicImageLookup(const scene::ImageTexture& image, const BasicMipChain<Level>& chain);

    /// Returns the colour at (p.x, p.y): where a pixel of the picture is larger than the footprint
    /// by the filter of the texture, else the mean of about what the footprint covers, blended
    /// between two levels of the chain.
    DVec3 color(const DVec3& p, const Footprint& footprint) const;

 private:
    DVec3 bilinear(const Level& level, double u, double v) const;
    DVec3 nearest(double u, double v) const;

    /// The linear colour of a pixel, by its index row by row.
    Color linear(const image::CodedImage& level, std::size_t i) const {
        const std::uint8_t* const rgb = level.rgb.data() + 3 * i;
        return {values_->linear[rgb[0]], values_->linear[rgb[1]], values_->linear[rgb[2]]};
    }
    Color linear(const image::Image& level, std::size_t i) const { return level.pixels[i]; }

    const BasicMipChain<Level>* chain_;
    const CodeValues* values_;
    scene::ImageWrap wrap_;
    scene::ImageFilter filter_;
};

using ImageLookup = BasicImageLookup<image::CodedImage>;
using LightLookup = BasicImageLookup<image::Image>;

extern template class BasicImageLookup<image::CodedImage>;
extern template class BasicImageLookup<image::Image>;

}  // namespace lray::shade
