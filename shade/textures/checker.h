// Looks up cubes of two colours in turn.
#pragma once

#include "base/vec.h"
#include "scene/texture.h"
#include "shade/textures/footprint.h"

namespace lray::shade {

class Checker {
 public:
    explicit Checker(const scene::CheckerTexture& checker);

    /// Returns the colour at a point of the texture's space, averaged over the footprint.
    DVec3 color(const DVec3& p, const Footprint& footprint) const;

 private:
    DVec3 a_;
    DVec3 b_;
    double per_size_;  // cubes in a unit of length
};

}  // namespace lray::shade
