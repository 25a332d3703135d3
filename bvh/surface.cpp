#include "bvh/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/assert.h"
#include "bvh/instance_ray.h"
#include "bvh/site.h"
#include "scene/place.h"

namespace lray::bvh {

namespace {

double length(DVec3 v) {
    return std::sqrt(dot(v, v));
}

/// Returns floats that are not less: the next one to the nearest, as which of the two the number
/// lies between is not to be foreseen by a processor.
Vec3 rounded_away(DVec3 positive) {
    const Vec3 nearest{positive};
    return {next_up(nearest.x), next_up(nearest.y), next_up(nearest.z)};
}

/// Brings a site from the space of a prototype to that of an instance.
Site placed(const Site& site, const scene::AffineFrame& frame) {
    const DMat3 object_from_world{frame.object_from_world};
    const DMat3 world_from_object = glm::inverse(object_from_world);
    const DMat3 reach = absolute(world_from_object);
    const DVec3 origin{frame.origin};
    Site result;
    result.position_local = site.position_local;
    const DVec3 offset = world_from_object * site.position;
    result.position = offset + origin;
    result.gradient = world_gradient(frame, site.gradient);
    result.value = site.value;
    result.magnitude = site.magnitude;
    // The Hessian of F takes the map on both sides, its bound the square of the map's norm.
    if (site.curvature != 0.0) {
        result.curvature = site.curvature * sum_of_squares(frame.object_from_world) *
                           length(site.gradient) / length(result.gradient);
    }
    // The ray's way in and the position's way out: a few roundings of sums of such terms.
    const DVec3 terms =
        reach * (absolute(object_from_world) * absolute(offset) + absolute(site.position)) +
        absolute(origin);
    result.position_error = reach * site.position_error + gamma<double>(kKernelOperations) * terms;
    return result;
}

/// Returns the site of a hit in the space of a geometry.
/// Shape: recurs as deep as instances nest, kMaxInstanceDepth at most.
Site find_placed_site(const scene::World& world, const scene::Geometry& geometry,
                      scene::PlaceOffset place, const PreparedRay& ray, const Hit& hit) {
    if (place == 0) return find_site(geometry, ray, hit);
    const scene::EnteredPlace entered = scene::enter(world, geometry, place);
    const scene::WorldInstance& instance = *entered.step.instance;
    return placed(
        find_placed_site(world, *entered.geometry, entered.place, set_out_in(instance, ray), hit),
        instance.frame);
}

}  // namespace

SurfacePoint surface_at(const scene::World& world, const Ray& ray, const Hit& hit) {
    LRAY_ASSERT(!hit.is_none());
    const Site site = find_placed_site(world, world, hit.place, set_out(ray), hit);
    const double per_slope = 1.0 / length(site.gradient);
    const DVec3 normal = site.gradient * per_slope;

    // Rounding the position to float: half an ulp per axis, and at least the least float.
    constexpr double kLeast = static_cast<double>(std::numeric_limits<float>::denorm_min());
    const double u = static_cast<double>(kUnitRoundoff<float>);
    const DVec3 rounding = u * absolute(site.position) + DVec3{kLeast} + site.position_error;

    // What the rounding moves the position along the surface lifts it off a curved one by
    // curvature / 2 times its square (four times the rounding: the offset rounds again), but never
    // by more than itself: at the apex of a cone the curvature is infinite.
    const double drift = 4.0 * (rounding.x + rounding.y + rounding.z);
    const double lift = std::min(site.curvature * drift * drift / 2.0, drift);
    const double along_normal =
        (site.value + gamma<double>(kKernelOperations) * site.magnitude) * per_slope + lift;

    const DVec3 error = rounding + along_normal * absolute(normal);
    return {Vec3{site.position}, rounded_away(error), Vec3{normal}, site.position_local};
}

}  // namespace lray::bvh
