#include "shade/lights/spherical_rectangle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lray::shade {

namespace {

/// The angle at a corner between the planes of its sides through the origin, which is acos(n0.n1)
/// of the source; without their normals, by the tangent.
double corner_angle(double x, double y, double sign, double height) {
    const double across = height * std::sqrt(x * x + y * y + height * height);
    return static_cast<double>(
        std::atan2(static_cast<float>(across), static_cast<float>(sign * x * y)));
}

}  // namespace

SphericalRectangle SphericalRectangle::of(DVec2 low, DVec2 high, double height) {
    SphericalRectangle r;
    r.low = low;
    r.high = high;
    r.height = height;
    const double g0 = corner_angle(high.x, low.y, 1.0, height);
    const double g1 = corner_angle(high.x, high.y, -1.0, height);
    const double g2 = corner_angle(low.x, high.y, 1.0, height);
    const double g3 = corner_angle(low.x, low.y, -1.0, height);
    r.angle = 2.0 * std::numbers::pi - g2 - g3;
    r.solid_angle = g0 + g1 - r.angle;
    r.side_low = -low.y / std::sqrt(height * height + low.y * low.y);
    r.side_high = high.y / std::sqrt(height * height + high.y * high.y);
    return r;
}

DVec2 SphericalRectangle::point(DVec2 u) const {
    const float turned = static_cast<float>(u.x * solid_angle + angle);
    const double cosine = static_cast<double>(std::cos(turned));
    const double sine = static_cast<double>(std::sin(turned));
    // x / sqrt(x^2 + height^2) is sign(fu) / sqrt(fu^2 + b0^2), so x^2 = height^2 / (its inverse
    // square - 1); all times sine, which may be 0.
    const double fu = cosine * side_low - side_high;
    const double rest = fu * fu + (side_low * side_low - 1.0) * sine * sine;
    const double slope = std::abs(sine) / std::sqrt(std::max(rest, 0x1p-1000));
    const double x = std::clamp(height * std::copysign(slope, fu * sine), low.x, high.x);
    const double d_squared = x * x + height * height;
    const double h0 = low.y / std::sqrt(d_squared + low.y * low.y);
    const double h1 = high.y / std::sqrt(d_squared + high.y * high.y);
    const double h = h0 + u.y * (h1 - h0);
    const double y = h * std::sqrt(d_squared / std::max(1.0 - h * h, 0x1p-1000));
    return {x, std::clamp(y, low.y, high.y)};
}

}  // namespace lray::shade
