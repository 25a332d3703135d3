// Looks up colours that run through their stops once in each unit.
#pragma once

#include "base/vec.h"
#include "scene/texture.h"
#include "shade/textures/color_stops.h"
#include "shade/textures/footprint.h"

namespace lray::shade {

class Gradient {
 public:
    explicit Gradient(const scene::GradientTexture& gradient);

    /// Returns the colour at a point of the texture's space, averaged over the footprint.
    DVec3 color(const DVec3& p, const Footprint& footprint) const;

 private:
    /// One unit, from 0 to 1.
    struct Profile {
        ColorStops stops;
        DVec3 before;  // integral of the stops from the first one back to 0

        DVec3 value(double t) const { return stops.value(t); }
        DVec3 integral(double t) const { return stops.integral(t) - before; }
    };

    Profile profile_;
    int axis_;
};

}  // namespace lray::shade
