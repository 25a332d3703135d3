#include "bench/embree_spheres.h"

#include <cmath>

namespace lray::bench {

namespace {

void find_bounds(const RTCBoundsFunctionArguments* arguments) {
    const auto* spheres = static_cast<const scene::Sphere*>(arguments->geometryUserPtr);
    const scene::Sphere& sphere = spheres[arguments->primID];
    RTCBounds* bounds = arguments->bounds_o;
    bounds->lower_x = sphere.center.x - sphere.radius;
    bounds->lower_y = sphere.center.y - sphere.radius;
    bounds->lower_z = sphere.center.z - sphere.radius;
    bounds->upper_x = sphere.center.x + sphere.radius;
    bounds->upper_y = sphere.center.y + sphere.radius;
    bounds->upper_z = sphere.center.z + sphere.radius;
}

/// Returns the lesser t in the interval, or a negative number. For directions of unit length, which
/// saves the division of the general case.
/// Source: Haines, Günther, Akenine-Möller 2019, "Precision Improvements for Ray/Sphere
/// Intersection", Ray Tracing Gems, ch. 7, eq. 5.
inline float sphere_t(const scene::Sphere& sphere, Vec3 origin, Vec3 dir, float near, float far) {
    const Vec3 to_center = sphere.center - origin;
    const float middle = dot(to_center, dir);
    const Vec3 across = to_center - middle * dir;
    const float inside = sphere.radius * sphere.radius - dot(across, across);
    if (inside < 0.0f) return -1.0f;
    const float half = std::sqrt(inside);
    const float entry = middle - half;
    if (entry > near && entry < far) return entry;
    const float exit = middle + half;
    return exit > near && exit < far ? exit : -1.0f;
}

/// Returns t for a ray of a packet.
inline float packet_t(const scene::Sphere& sphere, RTCRayN* rays, unsigned size, unsigned i) {
    const Vec3 origin{RTCRayN_org_x(rays, size, i), RTCRayN_org_y(rays, size, i),
                      RTCRayN_org_z(rays, size, i)};
    const Vec3 dir{RTCRayN_dir_x(rays, size, i), RTCRayN_dir_y(rays, size, i),
                   RTCRayN_dir_z(rays, size, i)};
    return sphere_t(sphere, origin, dir, RTCRayN_tnear(rays, size, i), RTCRayN_tfar(rays, size, i));
}

inline void intersect_one(const RTCIntersectFunctionNArguments* arguments, unsigned size,
                          unsigned i) {
    if (!arguments->valid[i]) return;
    const auto* spheres = static_cast<const scene::Sphere*>(arguments->geometryUserPtr);
    const scene::Sphere& sphere = spheres[arguments->primID];
    RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, size);
    const float t = packet_t(sphere, rays, size, i);
    if (t < 0.0f) return;
    RTCHitN* hits = RTCRayHitN_HitN(arguments->rayhit, size);
    RTCRayN_tfar(rays, size, i) = t;
    RTCHitN_Ng_x(hits, size, i) =
        RTCRayN_org_x(rays, size, i) + t * RTCRayN_dir_x(rays, size, i) - sphere.center.x;
    RTCHitN_Ng_y(hits, size, i) =
        RTCRayN_org_y(rays, size, i) + t * RTCRayN_dir_y(rays, size, i) - sphere.center.y;
    RTCHitN_Ng_z(hits, size, i) =
        RTCRayN_org_z(rays, size, i) + t * RTCRayN_dir_z(rays, size, i) - sphere.center.z;
    RTCHitN_u(hits, size, i) = 0.0f;
    RTCHitN_v(hits, size, i) = 0.0f;
    RTCHitN_primID(hits, size, i) = arguments->primID;
    RTCHitN_geomID(hits, size, i) = arguments->geomID;
    RTCHitN_instID(hits, size, i, 0) = arguments->context->instID[0];
}

void intersect(const RTCIntersectFunctionNArguments* arguments) {
    if (arguments->N == 1) return intersect_one(arguments, 1, 0);
    for (unsigned i = 0; i < arguments->N; ++i) intersect_one(arguments, arguments->N, i);
}

inline void occlude_one(const RTCOccludedFunctionNArguments* arguments, unsigned size, unsigned i) {
    if (!arguments->valid[i]) return;
    const auto* spheres = static_cast<const scene::Sphere*>(arguments->geometryUserPtr);
    if (packet_t(spheres[arguments->primID], arguments->ray, size, i) < 0.0f) return;
    RTCRayN_tfar(arguments->ray, size, i) = -INFINITY;
}

void occlude(const RTCOccludedFunctionNArguments* arguments) {
    if (arguments->N == 1) return occlude_one(arguments, 1, 0);
    for (unsigned i = 0; i < arguments->N; ++i) occlude_one(arguments, arguments->N, i);
}

}  // namespace

void add_spheres(RTCDevice device, RTCScene scene, std::span<const scene::Sphere> spheres) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(spheres.size()));
    rtcSetGeometryUserData(geometry, const_cast<scene::Sphere*>(spheres.data()));  // only read
    rtcSetGeometryBoundsFunction(geometry, find_bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcSetGeometryOccludedFunction(geometry, occlude);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

}  // namespace lray::bench
