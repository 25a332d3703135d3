// Looks up the rings of a tree.
#pragma once

#include "base/vec.h"
#include "scene/texture.h"
#include "shade/textures/footprint.h"
#include "shade/textures/fractal_noise.h"

namespace lray::shade {

class Wood {
 public:
    explicit Wood(const scene::WoodTexture& wood);

    /// Returns the colour at a point of the texture's space, averaged over the footprint.
    DVec3 color(const DVec3& p, const Footprint& footprint) const;

 private:
    FractalNoise noise_;
    DVec3 a_;
    DVec3 b_;
    double per_size_;  // rings in a unit of length
    double turbulence_;
    int axis_;  // of the trunk
};

}  // namespace lray::shade
