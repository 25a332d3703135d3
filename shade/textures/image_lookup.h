// Looks pictures up: between their pixels, outside of them, and from afar.
#pragma once

#include "base/vec.h"
#include "scene/texture.h"
#include "shade/textures/code_values.h"
#include "shade/textures/footprint.h"
#include "shade/textures/mip_chain.h"

namespace lray::shade {

class ImageLookup {
 public:
    /// The chain, which is that of the texture's picture, must outlive it.
    ImageLookup(const scene::ImageTexture& image, const MipChain& chain);

    /// Returns the colour at (p.x, p.y): where a pixel of the picture is larger than the footprint
    /// by the filter of the texture, else the mean of about what the footprint covers, blended
    /// between two levels of the chain.
    DVec3 color(const DVec3& p, const Footprint& footprint) const;

 private:
    DVec3 bilinear(const image::CodedImage& level, double u, double v) const;
    DVec3 nearest(double u, double v) const;
    Color decoded(const std::uint8_t* rgb) const {
        return {values_->linear[rgb[0]], values_->linear[rgb[1]], values_->linear[rgb[2]]};
    }

    const MipChain* chain_;
    const CodeValues* values_;
    scene::ImageWrap wrap_;
    scene::ImageFilter filter_;
};

}  // namespace lray::shade
