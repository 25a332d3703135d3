#include "shade/lights/spherical_rectangle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lray::shade {

namespace {

/// A number of the plane whose angle to the x axis is the angle at a corner between the planes of
/// its sides through the origin, acos(n0.n1) of the source: without roots for the normals, and
/// angles are added by multiplying.
DVec2 corner_turn(double x, double y, double sign, double height) {
    return {sign * x * y, height * std::sqrt(x * x + y * y + height * height)};
}

DVec2 times(DVec2 a, DVec2 b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

/// In [0, 2 pi).
double angle_of(DVec2 turn) {
    const double angle =
        static_cast<double>(std::atan2(static_cast<float>(turn.y), static_cast<float>(turn.x)));
    return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
}

}  // namespace

SphericalRectangle SphericalRectangle::of(DVec2 low, DVec2 high, double height) {
    SphericalRectangle r;
    r.low = low;
    r.high = high;
    r.height = height;
    // Units in which the farthest corner is 1: squares and their products are floats.
    const double unit =
        1.0 / (std::max({-low.x, high.x, -low.y, high.y, high.x - low.x, high.y - low.y}) + height);
    const DVec2 a = low * unit;
    const DVec2 b = high * unit;
    const double h = height * unit;
    const DVec2 g0_g1 = times(corner_turn(b.x, a.y, 1.0, h), corner_turn(b.x, b.y, -1.0, h));
    const DVec2 g2_g3 = times(corner_turn(a.x, b.y, 1.0, h), corner_turn(a.x, a.y, -1.0, h));
    r.angle = angle_of({g2_g3.x, -g2_g3.y});        // 2 pi - g2 - g3
    r.solid_angle = angle_of(times(g0_g1, g2_g3));  // g0 + g1 + g2 + g3 - 2 pi
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
