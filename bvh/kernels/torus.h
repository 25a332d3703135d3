// Ray against torus: the torus of a world's frame in object space.
//
// No quartic is set up: its coefficients lose a thin tube to cancellation. Along the ray, with rho
// the distance from the axis, the function solved is
//     G(s) = (rho(s) - R)^2 + y(s)^2 - r^2,
// negative within the solid. As rho >= 0, the part of a tube that overlaps itself which lies inside
// is no root. With s a distance in object space, G is s^2 - 2 R rho(s) plus a polynomial of degree
// 1, and rho is convex: so G is convex but for one stretch around the point nearest the axis, whose
// ends are known. In each of the three pieces there are at most two roots, which Newton's method
// finds from the right end without passing them, and a bound by tangents tells when there are none.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "bvh/kernels/kernel_hit.h"
#include "bvh/kernels/object_ray.h"

namespace lray::bvh {

/// Returns the cube root of x >= 0 to a few roundings; 0 for subnormal numbers. std::cbrt may
/// differ between machines.
/// A third of the exponent is right within 6 %; each step of Halley's method triples the digits.
/// Source: Kahan 1991, "Computing a Real Cube Root".
inline double cube_root(double x) {
    if (!(x >= std::numeric_limits<double>::min())) return 0.0;
    constexpr std::uint64_t kBiasThirds = 0x2a9f789300000000u;
    double y = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + kBiasThirds);
    for (int i = 0; i < 3; ++i) {
        const double cube = y * y * y;
        y *= (cube + 2.0 * x) / (2.0 * cube + x);
    }
    return y;
}

/// G, or -G where that is the convex one, and its derivative at a place on the ray.
struct TorusSample {
    double s = 0.0;
    double value = 0.0;
    double slope = 0.0;
};

/// The line of a ray in the object space of a torus, by the distance s from its point nearest the
/// centre: all numbers are then of the size of the torus, however far away the ray begins.
class TorusLine {
 public:
    TorusLine(const scene::Torus& torus, const PreparedRay& ray)
        : radius_(torus.radius()), tube_(static_cast<double>(torus.tube)) {
        const ObjectRay local = object_ray(torus.frame, ray);
        const double length = std::sqrt(dot(local.dir, local.dir));
        dir_ = local.dir / length;
        t_per_s_ = 1.0 / length;
        // Twice: the first foot has the rounding of a far origin in it.
        const double there = -dot(local.origin, dir_);
        foot_ = local.origin + there * dir_;
        const double rest = -dot(foot_, dir_);
        foot_ += rest * dir_;
        shift_ = there + rest;
        // A ray that touches the tube meets it: the radius is widened by the rounding of G.
        tube2_ = tube_ * tube_ * (1.0 + gamma<double>(16));
        across_ = dir_.x * dir_.x + dir_.z * dir_.z;
    }

    double t_of(double s) const { return (s + shift_) * t_per_s_; }

    /// Sets [lo, hi] to the part of the line that may be within the solid: between the planes above
    /// and below it, in the sphere around it. False if it is empty, also for NaN.
    /// Wider by the margin, so that G is not negative at the ends.
    bool clip(double& lo, double& hi) const {
        const double half2 = 1.0 + kMargin - dot(foot_, foot_);
        if (!(half2 >= 0.0)) return false;
        hi = std::sqrt(half2) + kMargin;
        lo = -hi;
        const double height = tube_ + kMargin;
        if (dir_.y == 0.0) return std::fabs(foot_.y) <= height;
        const double down = (-height - foot_.y) / dir_.y;
        const double up = (height - foot_.y) / dir_.y;
        lo = std::max(lo, std::min(down, up));
        hi = std::min(hi, std::max(down, up));
        return lo < hi;
    }

    /// True if the line stays inside the hole between two places in the planes' slab: the distance
    /// from the axis is convex.
    bool is_in_hole(double lo, double hi) const {
        const double hole = radius_ - tube_ - kMargin;
        return hole > 0.0 && axis_distance2(lo) < hole * hole && axis_distance2(hi) < hole * hole;
    }

    /// The stretch between two places at which the derivative of G jumps or turns: within, G is
    /// concave.
    struct Bend {
        double lo = 0.0;
        double hi = 0.0;
        double axis_slope = 0.0;  // d rho / d s at hi; at lo it is the negative
    };

    /// Returns where G is concave; empty if nowhere.
    /// With rho^2 = A (s - m)^2 + k / A, where A is across_ and k the squared moment of the line
    /// about the axis, rho'' is k / rho^3, and G'' = 2 - 2 R k / rho^3 is negative where
    /// rho < (R k)^(1/3). There d rho / d s is sqrt(A - rho / R), which holds also for k = 0, when
    /// the line meets the axis and G has a corner.
    std::optional<Bend> bend() const {
        const double moment = foot_.x * dir_.z - foot_.z * dir_.x;
        const double k = moment * moment;
        if (!(k < radius_ * radius_ * across_ * across_ * across_)) return std::nullopt;
        const double axis_distance = cube_root(radius_ * k);
        const double slope2 = across_ - axis_distance / radius_;
        if (!(slope2 > 0.0)) return std::nullopt;
        const double axis_slope = std::sqrt(slope2);
        const double middle = -(foot_.x * dir_.x + foot_.z * dir_.z) / across_;
        const double half = axis_distance * axis_slope / across_;
        return Bend{middle - half, middle + half, axis_slope};
    }

    /// Returns sign * G at s.
    TorusSample at(double s, double sign) const {
        const double x = foot_.x + s * dir_.x;
        const double z = foot_.z + s * dir_.z;
        const double rho = std::sqrt(x * x + z * z);
        const double rho_slope = rho > 0.0 ? (x * dir_.x + z * dir_.z) / rho : 0.0;
        return sample(s, sign, rho, rho_slope);
    }

    /// The same, where the derivative of rho is known: at a corner it is one-sided.
    TorusSample at_bend(double s, double sign, double rho_slope) const {
        return sample(s, sign, std::sqrt(axis_distance2(s)), rho_slope);
    }

 private:
    /// More than rounding does to coordinates up to 1.
    static constexpr double kMargin = 0x1p-40;

    double axis_distance2(double s) const {
        const double x = foot_.x + s * dir_.x;
        const double z = foot_.z + s * dir_.z;
        return x * x + z * z;
    }

    TorusSample sample(double s, double sign, double rho, double rho_slope) const {
        const double y = foot_.y + s * dir_.y;
        const double over = rho - radius_;
        return {s, sign * (over * over + y * y - tube2_),
                sign * 2.0 * (over * rho_slope + y * dir_.y)};
    }

    double radius_ = 0.0;
    double tube_ = 0.0;
    double tube2_ = 0.0;
    DVec3 foot_{};
    DVec3 dir_{};  // unit
    double across_ = 0.0;
    double shift_ = 0.0;
    double t_per_s_ = 0.0;
};

/// Steps after which a search ends: halving alone brings any piece below the spacing of doubles.
inline constexpr int kMaxTorusSteps = 80;

/// Places on a line closer to each other are the same: a few roundings of coordinates up to 1.
inline constexpr double kTorusResolution = 0x1p-51;

/// Returns a place between two samples of the convex function sign * G that are on the same side of
/// the surface, where it is on the other one; empty if there is none. The surface belongs to the
/// inside. The least value lies above where the tangents at both ends meet. What is tried next is
/// that place, which is best at a corner, and the root of the chord of the slopes, best for a
/// parabola.
inline std::optional<double> find_dip(const TorusLine& line, double sign, TorusSample a,
                                      TorusSample b) {
    for (int i = 0; i < kMaxTorusSteps; ++i) {
        if (!(a.slope < 0.0 && b.slope > 0.0)) return std::nullopt;
        const double width = b.s - a.s;
        const double rise = b.slope - a.slope;
        const double meet = (b.slope * width - (b.value - a.value)) / rise;
        if (a.value + a.slope * meet > 0.0) return std::nullopt;
        if (width <= kTorusResolution) return std::nullopt;
        double step = i % 2 == 0 ? -a.slope * width / rise : meet;
        if (!(step > 0.0 && step < width)) step = 0.5 * width;
        const TorusSample middle = line.at(a.s + step, sign);
        if (sign > 0.0 ? middle.value <= 0.0 : middle.value < 0.0) return middle.s;
        if (middle.slope < 0.0) {
            a = middle;
        } else {
            b = middle;
        }
    }
    return std::nullopt;
}

/// Returns the root of a convex function between `from`, where it is not negative, and `end`, where
/// it is not positive. Newton's method comes closer from that side and does not pass the root but
/// by rounding.
inline double find_root(const TorusLine& line, double sign, TorusSample from, double end) {
    for (int i = 0; i < kMaxTorusSteps && from.value > 0.0; ++i) {
        double next = from.s - from.value / from.slope;
        const bool is_between = end > from.s ? next > from.s && next < end  // NaN is not
                                             : next < from.s && next > end;
        if (!is_between) {
            next = 0.5 * (from.s + end);
            if (std::fabs(end - from.s) <= kTorusResolution) return next;
        }
        if (std::fabs(next - from.s) <= kTorusResolution) return next;
        const TorusSample found = line.at(next, sign);
        if (found.value > 0.0) {
            from = found;
        } else if (is_between) {
            return next;
        } else {
            end = next;
        }
    }
    return from.s;
}

/// Returns the least t at which the ray crosses the torus and that, rounded to float, lies in the
/// open interval; empty if there is none, or for NaN. A root is the same whatever the interval.
/// A tangent counts as two equal crossings.
inline std::optional<double> torus_crossing(const scene::Torus& torus, const PreparedRay& ray,
                                            Interval interval) {
    const TorusLine line(torus, ray);
    double lo = 0.0;
    double hi = 0.0;
    if (!line.clip(lo, hi) || line.is_in_hole(lo, hi)) return std::nullopt;

    // Places beyond the interval need no roots: rounding keeps the order.
    const auto rounded_t = [&line](double s) { return static_cast<float>(line.t_of(s)); };
    if (rounded_t(hi) <= interval.lo || rounded_t(lo) >= interval.hi) return std::nullopt;

    std::optional<double> result;
    // True if the search is over.
    const auto try_root = [&](double sign, const TorusSample& from, double end) {
        if (rounded_t(std::max(from.s, end)) <= interval.lo) return false;
        if (rounded_t(std::min(from.s, end)) >= interval.hi) return true;
        const double t = line.t_of(find_root(line, sign, from, end));
        if (!(static_cast<float>(t) > interval.lo)) return false;
        if (static_cast<float>(t) < interval.hi) result = t;
        return true;
    };
    // Likewise. The samples are of sign * G, which is convex between them.
    const auto search_piece = [&](double sign, const TorusSample& a, const TorusSample& b) {
        if (rounded_t(b.s) <= interval.lo) return false;
        if (rounded_t(a.s) >= interval.hi) return true;
        const bool is_a_inside = sign * a.value <= 0.0;
        const bool is_b_inside = sign * b.value <= 0.0;
        if (is_a_inside != is_b_inside) {
            const bool is_from_a = is_a_inside == (sign < 0.0);
            return is_from_a ? try_root(sign, a, b.s) : try_root(sign, b, a.s);
        }
        if (is_a_inside == (sign > 0.0)) return false;
        const auto dip = find_dip(line, sign, a, b);
        return dip && (try_root(sign, a, *dip) || try_root(sign, b, *dip));
    };

    const TorusSample first = line.at(lo, 1.0);
    const TorusSample last = line.at(hi, 1.0);
    const auto bend = line.bend();
    if (!bend || !(bend->lo < hi && bend->hi > lo)) {
        search_piece(1.0, first, last);
        return result;
    }
    TorusSample middle = first;
    if (bend->lo > lo) {
        middle = line.at_bend(bend->lo, 1.0, -bend->axis_slope);
        if (search_piece(1.0, first, middle)) return result;
    }
    const bool is_last = !(bend->hi < hi);
    const TorusSample next = is_last ? last : line.at_bend(bend->hi, 1.0, bend->axis_slope);
    const auto negated = [](const TorusSample& sample) {
        return TorusSample{sample.s, -sample.value, -sample.slope};
    };
    if (search_piece(-1.0, negated(middle), negated(next)) || is_last) return result;
    search_piece(1.0, next, last);
    return result;
}

/// u and v of the hit are 0: both angles, around the axis and around the tube, follow from the
/// position.
inline KernelHit intersect_torus(const scene::Torus& torus, const PreparedRay& ray,
                                 Interval interval) {
    const auto t = torus_crossing(torus, ray, interval);
    return t ? KernelHit{.t = static_cast<float>(*t)} : KernelHit{};
}

}  // namespace lray::bvh
