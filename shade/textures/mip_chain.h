// Smaller and smaller copies of a picture, each pixel the mean of those it stands for.
#pragma once

#include <cstddef>
#include <vector>

#include "image/coded_image.h"
#include "image/image.h"

namespace lray::shade {

/// Each level has half the width and height of the one before, rounded down, at least 1; the last
/// is one pixel. Level 0 is the picture itself. The others together are a third of it: they are
/// coded as it is, so of codes a pixel is off by half a code at most, as pixels of the picture are;
/// light in floats stays so.
/// Source: Williams 1983, "Pyramidal Parametrics".
template <class Level>
class BasicMipChain {
 public:
    /// Works the levels out on all cores of the task arena it is called in. Keeps the picture.
    /// `is_srgb` tells what codes stand for: means are those of linear colours.
    BasicMipChain(const Level& picture, bool is_srgb);

    std::size_t level_count() const { return smaller_.size() + 1; }
    const Level& level(std::size_t i) const { return i == 0 ? *picture_ : smaller_[i - 1]; }

 private:
    const Level* picture_;
    std::vector<Level> smaller_;
};

using MipChain = BasicMipChain<image::CodedImage>;
using LightMipChain = BasicMipChain<image::Image>;

extern template class BasicMipChain<image::CodedImage>;
extern template class BasicMipChain<image::Image>;

}  // namespace lray::shade
