#include "shade/textures/wood.h"

#include <algorithm>
#include <cmath>

#include "scene/vein_profiles.h"
#include "shade/textures/periodic.h"

namespace lray::shade {

namespace {

/// Cells of the first octave to a ring across the trunk: neighbouring rings bend alike. Along it
/// they are longer: the grain runs along the trunk.
constexpr double kNoisePerRing = 0.25;
constexpr double kGrain = 1.0 / 8.0;

}  // namespace

Wood::Wood(const scene::WoodTexture& wood)
    : noise_({static_cast<int>(wood.octaves), 2.0, 0.5}, wood.seed),
      a_(wood.a),
      b_(wood.b),
      per_size_(1.0 / wood.size),
      turbulence_(wood.turbulence),
      axis_(static_cast<int>(wood.axis)) {}

DVec3 Wood::color(const DVec3& p, const Footprint& footprint) const {
    const double noise_scale = per_size_ * kNoisePerRing;
    DVec3 grain = p * noise_scale;
    grain[axis_] *= kGrain;
    const FractalNoise::Value bend = noise_.at(grain, footprint.width() * noise_scale);

    DVec3 from_axis = p;
    DVec3 extent = footprint.extent;
    from_axis[axis_] = 0.0;
    extent[axis_] = 0.0;
    const double radius = std::sqrt(dot(from_axis, from_axis));
    // How far the footprint reaches outwards; in the middle of the trunk there is no such
    // direction.
    const DVec3 outwards = from_axis * extent;
    const double reach = radius > 0.0 ? std::sqrt(dot(outwards, outwards)) / radius : 0.0;

    const double place = radius * per_size_ + turbulence_ * bend.mean;
    const double width = reach * per_size_ + turbulence_ * bend.spread;
    const scene::WoodProfile profile;
    double late = mean_of_periodic(profile, place, width);
    if (footprint.across > 0.0) {
        const double mean = profile.integral(1.0);
        late = mean + (late - mean) * pattern_left(2.0 * footprint.across * per_size_);
    }
    return mix(a_, b_, late);
}

}  // namespace lray::shade
