// Smaller and smaller copies of a picture, each pixel the mean of those it stands for.
#pragma once

#include <cstddef>
#include <vector>

#include "image/coded_image.h"

namespace lray::shade {

/// Each level has half the width and height of the one before, rounded down, at least 1; the last
/// is one pixel. Level 0 is the picture itself. The others together are a third of it: they are
/// coded as it is, so a pixel is off by half a code at most, as pixels of the picture are.
/// Source: Williams 1983, "Pyramidal Parametrics".
class MipChain {
 public:
    /// Works the levels out on all cores of the task arena it is called in. Keeps the picture.
    /// `is_srgb` tells what the codes stand for: means are those of linear colours.
    MipChain(const image::CodedImage& picture, bool is_srgb);

    std::size_t level_count() const { return smaller_.size() + 1; }
    const image::CodedImage& level(std::size_t i) const {
        return i == 0 ? *picture_ : smaller_[i - 1];
    }

 private:
    const image::CodedImage* picture_;
    std::vector<image::CodedImage> smaller_;
};

}  // namespace lray::shade
