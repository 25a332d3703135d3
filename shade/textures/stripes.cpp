#include "shade/textures/stripes.h"

#include "shade/textures/square_wave.h"
#include "shade/textures/two_colors.h"

namespace lray::shade {

Stripes::Stripes(const scene::StripesTexture& stripes)
    : a_(stripes.a),
      b_(stripes.b),
      per_size_(1.0 / stripes.size),
      axis_(static_cast<int>(stripes.axis)) {}

DVec3 Stripes::color(const DVec3& p, const Footprint& footprint) const {
    double mean =
        mean_square_wave(p[axis_] * per_size_ - kBorderShift, footprint.extent[axis_] * per_size_);
    if (footprint.across > 0.0) mean *= pattern_left(footprint.across * per_size_);
    return in_turn(a_, b_, mean);
}

}  // namespace lray::shade
