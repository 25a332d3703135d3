// Looks up slabs of two colours in turn.
#pragma once

#include "base/vec.h"
#include "scene/texture.h"
#include "shade/textures/footprint.h"

namespace lray::shade {

class Stripes {
 public:
    explicit Stripes(const scene::StripesTexture& stripes);

    /// Returns the colour at a point of the texture's space, averaged over the footprint.
    DVec3 color(const DVec3& p, const Footprint& footprint) const;

 private:
    DVec3 a_;
    DVec3 b_;
    double per_size_;  // slabs in a unit of length
    int axis_;
};

}  // namespace lray::shade
