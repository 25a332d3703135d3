// Looks up colours at places along an axis, which do not repeat.
#pragma once

#include "base/vec.h"
#include "scene/texture.h"
#include "shade/textures/color_stops.h"
#include "shade/textures/footprint.h"

namespace lray::shade {

class Ramp {
 public:
    explicit Ramp(const scene::RampTexture& ramp)
        : stops_(ramp.stops), axis_(static_cast<int>(ramp.axis)) {}

    /// Returns the colour at a point of the texture's space, averaged over the footprint.
    DVec3 color(const DVec3& p, const Footprint& footprint) const {
        return stops_.mean(p[axis_], footprint.extent[axis_]);
    }

 private:
    ColorStops stops_;
    int axis_;
};

}  // namespace lray::shade
