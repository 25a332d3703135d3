#include "shade/textures/checker.h"

#include "shade/textures/square_wave.h"
#include "shade/textures/two_colors.h"

namespace lray::shade {

Checker::Checker(const scene::CheckerTexture& checker)
    : a_(checker.a), b_(checker.b), per_size_(1.0 / checker.size) {}

DVec3 Checker::color(const DVec3& p, const Footprint& footprint) const {
    const auto wave = [&](double x, double extent) {
        return mean_square_wave(x * per_size_ - kBorderShift, extent * per_size_);
    };
    // The mean of a product over a box is the product of the means over its sides.
    double mean = wave(p.x, footprint.extent.x) * wave(p.y, footprint.extent.y) *
                  wave(p.z, footprint.extent.z);
    if (footprint.across > 0.0) mean *= pattern_left(footprint.across * per_size_);
    return in_turn(a_, b_, mean);
}

}  // namespace lray::shade
