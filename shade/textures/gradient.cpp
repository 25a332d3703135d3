#include "shade/textures/gradient.h"

#include "shade/textures/periodic.h"

namespace lray::shade {

namespace {

/// So little before the end of a unit the next one has begun: a face that lies on the border of
/// units does not speckle between the last colour and the first.
constexpr double kSnap = 1.0 / 1024.0;

}  // namespace

Gradient::Gradient(const scene::GradientTexture& gradient)
    : profile_{ColorStops(gradient.stops), DVec3{0.0}}, axis_(static_cast<int>(gradient.axis)) {
    profile_.before = profile_.stops.integral(0.0);
}

DVec3 Gradient::color(const DVec3& p, const Footprint& footprint) const {
    double x = p[axis_];
    const Cell cell(x);
    if (cell.inside > 1.0 - kSnap) x = static_cast<double>(cell.index + 1);
    DVec3 color = mean_of_periodic(profile_, x, footprint.extent[axis_]);
    if (footprint.across > 0.0) {
        // A unit is two steps, up and down.
        const double left = pattern_left(2.0 * footprint.across);
        color = mix(profile_.integral(1.0), color, left);
    }
    return color;
}

}  // namespace lray::shade
