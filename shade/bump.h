// Bump and normal maps: how heights and codes tilt a shading normal. Where they come from is
// material_normal.h's.
#pragma once

#include <cmath>
#include <optional>

#include "base/vec.h"
#include "bvh/surface_detail.h"
#include "shade/textures/texture_point.h"

namespace lray::shade {

/// Two directions in the tangent plane of a shading normal, at right angles to it and each other.
struct TangentFrame {
    DVec3 u{};
    DVec3 v{};
    DVec3 normal{};
};

/// Returns the frame with u along dp_du and v on the side of dp_dv: that of normal maps.
/// Errors: empty where u or v has no direction.
std::optional<TangentFrame> tangent_frame(const bvh::SurfaceDetail& detail);

/// Returns a frame around the normal, with u and v anywhere.
TangentFrame any_frame(Vec3 normal);

/// Returns the place of a texture after a small step along the surface, in all of its spaces. uv
/// stays where it has no direction.
/// Space: `step` in the world, in the tangent plane.
TexturePoint moved(const TexturePoint& point, const bvh::SurfaceDetail& detail, DVec3 step);

/// Returns the side of the square that u and v from 0 to 1 would cover on the surface, as they lie
/// at this point; 0 where they have no direction.
/// Units: metres of the world.
double uv_length(const bvh::SurfaceDetail& detail);

/// How far apart heights are compared, in the world: the width of a pixel, so that what is finer is
/// averaged; where a point has no width, a tenth of a millimetre or so.
double bump_width(const TexturePoint& point);

/// Returns the direction turned as little as needed to be unit and above the surface; the shading
/// normal itself if it has none.
Vec3 above_surface(DVec3 direction, Vec3 shading_normal, Vec3 surface_normal);

/// Returns how a height changes along the surface, per metre: what a normal loses by the bump.
/// `height`: of TexturePoint, in metres, or in whatever the result shall be per metre. It is looked
/// up at four places half a bump_width() around the point, for central differences. Source: Blinn
/// 1978, "Simulation of Wrinkled Surfaces"; the gradient on the surface as in Mikkelsen 2010, "Bump
/// Mapping Unparametrized Surfaces on the GPU", sec. 2.
template <class Height>
DVec3 bump_gradient(const bvh::SurfaceDetail& detail, const TexturePoint& point,
                    const Height& height) {
    const TangentFrame frame = any_frame(detail.shading_normal);
    const double width = bump_width(point);
    const auto slope = [&](DVec3 along) {
        const DVec3 half = 0.5 * width * along;
        const double ahead = static_cast<double>(height(moved(point, detail, half)));
        const double behind = static_cast<double>(height(moved(point, detail, -half)));
        return (ahead - behind) / width;
    };
    return slope(frame.u) * frame.u + slope(frame.v) * frame.v;
}

/// Returns the direction that a normal map shows, unit: red along u, green along v, blue
/// along the shading normal, each 0 to 1 for -1 to 1. The shading normal where u or v has no
/// direction, or the code none.
DVec3 mapped_normal(const bvh::SurfaceDetail& detail, Color code);

}  // namespace lray::shade
