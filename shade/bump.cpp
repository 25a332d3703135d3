#include "shade/bump.h"

#include <limits>

#include "shade/across.h"

namespace lray::shade {

namespace {

/// Of points without a width, in metres.
constexpr double kWidthOfPoint = 0x1p-13;

/// The least cosine between a tilted normal and the surface's: a normal in the plane of the surface
/// would have half of all directions it reflects into below it.
constexpr double kLeastCosine = 0x1p-7;

/// Returns the unit vector; empty for 0 and what is not finite.
std::optional<DVec3> unit(DVec3 v) {
    const double square = dot(v, v);
    constexpr double kLeast = std::numeric_limits<double>::min();
    constexpr double kMost = std::numeric_limits<double>::max();
    if (!(square >= kLeast && square <= kMost)) return std::nullopt;
    return v / std::sqrt(square);
}

}  // namespace

std::optional<TangentFrame> tangent_frame(const bvh::SurfaceDetail& detail) {
    const auto u = unit(DVec3{detail.dp_du});
    if (!u) return std::nullopt;
    const DVec3 normal{detail.shading_normal};
    const DVec3 aside = cross(normal, *u);
    const double side = dot(aside, DVec3{detail.dp_dv});
    if (!(side != 0.0)) return std::nullopt;
    return TangentFrame{*u, side < 0.0 ? -aside : aside, normal};
}

TangentFrame any_frame(Vec3 normal) {
    const DVec3 n{normal};
    const auto [u, v] = across(n);
    return {u, v, n};
}

TexturePoint moved(const TexturePoint& point, const bvh::SurfaceDetail& detail, DVec3 step) {
    TexturePoint result = point;
    result.world += step;
    result.object += detail.object_from_world * step;
    // step = a dp_du + b dp_dv, by Cramer's rule in the tangent plane.
    const DVec3 u{detail.dp_du};
    const DVec3 v{detail.dp_dv};
    const double uu = dot(u, u);
    const double uv = dot(u, v);
    const double vv = dot(v, v);
    const double determinant = uu * vv - uv * uv;
    const double along_u = dot(step, u);
    const double along_v = dot(step, v);
    const DVec2 change =
        DVec2{along_u * vv - along_v * uv, along_v * uu - along_u * uv} / determinant;
    if (std::isfinite(change.x) && std::isfinite(change.y)) result.uv += change;
    return result;
}

double uv_length(const bvh::SurfaceDetail& detail) {
    const DVec3 square = cross(DVec3{detail.dp_du}, DVec3{detail.dp_dv});
    const double area = std::sqrt(dot(square, square));
    return std::isfinite(area) ? std::sqrt(area) : 0.0;
}

double bump_width(const TexturePoint& point) {
    const bool has_width =
        point.world_width > 0.0 && point.world_width <= std::numeric_limits<double>::max();
    return has_width ? point.world_width : kWidthOfPoint;
}

Vec3 above_surface(DVec3 direction, Vec3 shading_normal, Vec3 surface_normal) {
    const auto tilted = unit(direction);
    if (!tilted) return shading_normal;
    const DVec3 surface{surface_normal};
    const double cosine = dot(*tilted, surface);
    if (cosine >= kLeastCosine) return Vec3{*tilted};
    // In the plane of both, at the least angle above the surface.
    const auto along = unit(*tilted - cosine * surface);
    if (!along) return shading_normal;
    return Vec3{std::sqrt(1.0 - kLeastCosine * kLeastCosine) * *along + kLeastCosine * surface};
}

DVec3 mapped_normal(const bvh::SurfaceDetail& detail, Color code) {
    const auto frame = tangent_frame(detail);
    if (!frame) return DVec3{detail.shading_normal};
    const DVec3 local = 2.0 * DVec3{code} - 1.0;
    const auto mapped = unit(local.x * frame->u + local.y * frame->v + local.z * frame->normal);
    return mapped ? *mapped : frame->normal;
}

}  // namespace lray::shade
