// Colours at places along a line, and what is between and beyond them.
#pragma once

#include <span>
#include <vector>

#include "base/vec.h"
#include "scene/texture.h"

namespace lray::shade {

class ColorStops {
 public:
    /// Shape: at least one; places never decrease.
    explicit ColorStops(std::span<const scene::ColorStop> stops);

    /// Returns the colour at a place: between two stops a blend, on a hard edge that behind it,
    /// beyond the last ones as there. NaN is before the first.
    DVec3 value(double at) const;

    /// Returns the integral from the first stop to a place; before it, it is taken backwards.
    DVec3 integral(double to) const;

    /// Returns the mean over the width around a place; of a width of 0 the value there.
    DVec3 mean(double at, double width) const;

 private:
    struct Stop {
        double at = 0.0;
        DVec3 color{0.0};
        DVec3 integral{0.0};  // from the first stop
    };

    /// A place as lying behind a stop, before the next one by a share of the way.
    struct Place {
        const Stop* stop = nullptr;
        double past = 0.0;   // of the stop; negative before the first
        double share = 0.0;  // 0 beyond the last ones
    };
    Place place(double at) const;

    std::vector<Stop> stops_;
};

}  // namespace lray::shade
