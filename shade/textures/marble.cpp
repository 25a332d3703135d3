#include "shade/textures/marble.h"

#include "scene/vein_profiles.h"
#include "shade/textures/periodic.h"

namespace lray::shade {

namespace {

/// Cells of the first octave from vein to vein: the coarse bends are wider than the veins.
constexpr double kNoisePerVein = 0.5;

}  // namespace

Marble::Marble(const scene::MarbleTexture& marble)
    : noise_({static_cast<int>(marble.octaves), 2.0, 0.5}, marble.seed),
      a_(marble.a),
      b_(marble.b),
      per_size_(1.0 / marble.size),
      turbulence_(marble.turbulence),
      axis_(static_cast<int>(marble.axis)) {}

DVec3 Marble::color(const DVec3& p, const Footprint& footprint) const {
    const double noise_scale = per_size_ * kNoisePerVein;
    const FractalNoise::Value bend = noise_.at(p * noise_scale, footprint.width() * noise_scale);
    const double place = p[axis_] * per_size_ + turbulence_ * bend.mean;
    const double width = footprint.extent[axis_] * per_size_ + turbulence_ * bend.spread;
    const scene::MarbleProfile profile;
    double vein = mean_of_periodic(profile, place, width);
    if (footprint.across > 0.0) {
        const double mean = profile.integral(1.0);
        vein = mean + (vein - mean) * pattern_left(2.0 * footprint.across * per_size_);
    }
    return mix(a_, b_, vein);
}

}  // namespace lray::shade
