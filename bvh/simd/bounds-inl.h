// The tests of one ray against what bounds eight spheres or framed primitives, for the processor
// that HWY_TARGET names. Included once for each. They are made in float and never miss: what they
// find is met again in double.

#if defined(LRAY_BVH_SIMD_BOUNDS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LRAY_BVH_SIMD_BOUNDS_INL_H
#undef LRAY_BVH_SIMD_BOUNDS_INL_H
#else
#define LRAY_BVH_SIMD_BOUNDS_INL_H
#endif

#include <hwy/highway.h>

#include "bvh/simd/slabs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lray::bvh::HWY_NAMESPACE {

/// How far these tests are off, in parts of the numbers that they work with: 32 roundings, of which
/// none of their terms has more than eight.
inline constexpr float kBoundSlack = 0x1p-19f;

/// The squares of speeds in between are as exact as others.
inline constexpr float kLeastSpeedAside = 0x1p-60f;
inline constexpr float kMostSpeedAside = 0x1p60f;

/// In double no square leaves the range.
HWY_INLINE BlockRay make_block_ray(const double* origin, const double* dir) {
    const hn::CappedTag<double, 1> d;
    const auto x = hn::Set(d, dir[0]);
    const auto y = hn::Set(d, dir[1]);
    const auto z = hn::Set(d, dir[2]);
    const auto square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
    const auto inverse = hn::Div(hn::Set(d, 1.0), hn::Sqrt(square));
    const auto origin_size = hn::Add(hn::Add(hn::Abs(hn::Set(d, origin[0])),  //
                                             hn::Abs(hn::Set(d, origin[1]))),
                                     hn::Abs(hn::Set(d, origin[2])));
    BlockRay ray;
    ray.unit_dir[0] = static_cast<float>(hn::GetLane(hn::Mul(x, inverse)));
    ray.unit_dir[1] = static_cast<float>(hn::GetLane(hn::Mul(y, inverse)));
    ray.unit_dir[2] = static_cast<float>(hn::GetLane(hn::Mul(z, inverse)));
    ray.t_per_length = static_cast<float>(hn::GetLane(inverse));
    ray.origin_error = kBoundSlack * static_cast<float>(hn::GetLane(origin_size));
    return ray;
}

/// Returns the number in all lanes.
template <class D>
HWY_INLINE hn::Vec<D> spread(D d, const float* number) {
    return hn::MaxLanes(d) == 1 ? hn::Load(d, number) : hn::Set(d, *number);
}

/// A ray as these tests see it. In `D` each lane has a ray, or all the same one.
template <class D>
struct BoundRay {
    hn::Vec<D> origin[3];
    hn::Vec<D> dir[3];
    hn::Vec<D> unit_dir[3];  // or what is not a number, of which nothing is left out
    hn::Vec<D> t_per_length;
    hn::Vec<D> origin_error;
    hn::Vec<D> lo;
    hn::Vec<D> reach;
};

template <class D>
struct BallBound {
    hn::Vec<D> center[3];
    hn::Vec<D> radius;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE V size_of(D, const V (&v)[3]) {
    return hn::Add(hn::Add(hn::Abs(v[0]), hn::Abs(v[1])), hn::Abs(v[2]));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V dot(D, const V (&a)[3], const V (&b)[3]) {
    return hn::Add(hn::Add(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1])), hn::Mul(a[2], b[2]));
}

/// True where a ray surely misses the ball between `lo` and `reach`: what is not a number is not
/// left out.
template <class D>
HWY_INLINE hn::Mask<D> misses(D d, const BallBound<D>& ball, const BoundRay<D>& ray) {
    using V = hn::Vec<D>;
    const V way[3] = {hn::Sub(ball.center[0], ray.origin[0]),
                      hn::Sub(ball.center[1], ray.origin[1]),
                      hn::Sub(ball.center[2], ray.origin[2])};
    const V slack = hn::Mul(hn::Add(size_of(d, way), ball.radius), hn::Set(d, kBoundSlack));
    const V larger = hn::Add(ball.radius, hn::Add(slack, ray.origin_error));
    const V along = dot(d, way, ray.unit_dir);
    const V aside[3] = {hn::Sub(way[0], hn::Mul(along, ray.unit_dir[0])),
                        hn::Sub(way[1], hn::Mul(along, ray.unit_dir[1])),
                        hn::Sub(way[2], hn::Mul(along, ray.unit_dir[2]))};
    const V limit = hn::Add(hn::Mul(larger, larger), hn::Set(d, 0x1p-126f));
    const V entry = hn::Mul(hn::Sub(along, larger), ray.t_per_length);
    const V exit = hn::Mul(hn::Add(along, larger), ray.t_per_length);
    return hn::Or(hn::Gt(dot(d, aside, aside), limit),
                  hn::Or(hn::Gt(entry, ray.reach), hn::Lt(exit, ray.lo)));
}

/// Likewise, the cylinder around a framed primitive; rays that are very slow or fast in its space
/// miss nothing.
template <class D>
HWY_INLINE hn::Mask<D> misses(D d, const RoundBound& bound, const BoundRay<D>& ray) {
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d);
    const V two = hn::Set(d, 2.0f);
    const V stretch = spread(d, &bound.stretch);
    const V way[3] = {hn::Sub(ray.origin[0], spread(d, &bound.origin[0])),
                      hn::Sub(ray.origin[1], spread(d, &bound.origin[1])),
                      hn::Sub(ray.origin[2], spread(d, &bound.origin[2]))};
    V origin[3];
    V dir[3];
    for (std::size_t row = 0; row < 3; ++row) {
        const V map[3] = {spread(d, &bound.bound_from_world[0][row]),
                          spread(d, &bound.bound_from_world[1][row]),
                          spread(d, &bound.bound_from_world[2][row])};
        origin[row] = dot(d, map, way);
        dir[row] = dot(d, map, ray.dir);
    }
    const V slack = hn::Mul(stretch, hn::Set(d, kBoundSlack));
    const V origin_error =
        hn::Add(hn::Mul(size_of(d, way), slack), hn::Mul(ray.origin_error, stretch));
    const V dir_error = hn::Mul(size_of(d, ray.dir), slack);

    // Seen along the axis: how far the ray passes it by. With what it may be off by, all times the
    // speed, of which the square is known and no more than `most_speed`.
    const V speed_squared = hn::Add(hn::Mul(dir[0], dir[0]), hn::Mul(dir[2], dir[2]));
    const V most_speed = hn::Add(hn::Abs(dir[0]), hn::Abs(dir[2]));
    const V distance = hn::Add(hn::Abs(origin[0]), hn::Abs(origin[2]));
    const V pass = hn::Sub(hn::Mul(origin[0], dir[2]), hn::Mul(origin[2], dir[0]));
    const V pass_off = hn::Mul(
        hn::Set(d, 6.0f), hn::Add(hn::Mul(origin_error, most_speed), hn::Mul(distance, dir_error)));
    const V radius = hn::Set(d, 1.0f + kBoundSlack);
    const V beyond =
        hn::Mul(pass_off, hn::Add(hn::Mul(two, hn::Mul(radius, most_speed)), pass_off));
    const auto is_usual =
        hn::And(hn::Gt(speed_squared, hn::Set(d, kLeastSpeedAside * kLeastSpeedAside)),
                hn::Lt(speed_squared, hn::Set(d, kMostSpeedAside * kMostSpeedAside)));
    const auto is_aside =
        hn::And(is_usual, hn::Gt(hn::Mul(pass, pass),
                                 hn::Add(hn::Mul(hn::Mul(radius, radius), speed_squared), beyond)));
    if (hn::AllTrue(d, is_aside)) return is_aside;

    // Where it runs inside of the cylinder.
    const V speed = hn::Sqrt(speed_squared);
    const V t_per_length = hn::Div(hn::Set(d, 1.0f), speed);
    const V x = hn::Mul(dir[0], t_per_length);
    const V z = hn::Mul(dir[2], t_per_length);
    const V across = hn::Mul(pass, t_per_length);
    const V along = hn::Neg(hn::Add(hn::Mul(origin[0], x), hn::Mul(origin[2], z)));
    // The direction turns by as much as its error is of it, and what is far moves by that.
    const V turn = hn::Mul(two, hn::Mul(dir_error, t_per_length));
    const V off = hn::Add(hn::Mul(distance, turn), hn::Mul(two, origin_error));
    const V larger = hn::Add(radius, hn::Mul(hn::Set(d, 3.0f), off));
    const V depth_squared = hn::Sub(hn::Mul(larger, larger), hn::Mul(across, across));
    const V depth = hn::Add(hn::Sqrt(hn::Max(depth_squared, zero)), off);
    const V entry_t = hn::Mul(hn::Sub(along, depth), t_per_length);
    const V exit_t = hn::Mul(hn::Add(along, depth), t_per_length);
    const V entry = hn::Max(hn::Sub(entry_t, hn::Mul(hn::Abs(entry_t), turn)), ray.lo);
    const V exit = hn::Min(hn::Add(exit_t, hn::Mul(hn::Abs(exit_t), turn)), ray.reach);

    // Seen from the side: how high it is there.
    const V y_entry = hn::Add(origin[1], hn::Mul(entry, dir[1]));
    const V y_exit = hn::Add(origin[1], hn::Mul(exit, dir[1]));
    const V y_off = hn::Mul(two, hn::Add(origin_error, hn::Mul(hn::Abs(exit), dir_error)));
    const auto is_below =
        hn::Lt(hn::Add(hn::Max(y_entry, y_exit), y_off), spread(d, &bound.bottom));
    const auto is_above = hn::Gt(hn::Sub(hn::Min(y_entry, y_exit), y_off), spread(d, &bound.top));
    return hn::And(is_usual, hn::Or(hn::Or(hn::Lt(depth_squared, zero), hn::Gt(entry, exit)),
                                    hn::Or(is_below, is_above)));
}

/// The same ray for all lanes.
template <class D>
HWY_INLINE BoundRay<D> bound_ray_of(D d, Walk& walk) {
    if (!walk.has_block_ray) {
        walk.block_ray = make_block_ray(walk.origin, walk.dir);
        walk.has_block_ray = true;
    }
    const BlockRay& ray = walk.block_ray;
    BoundRay<D> result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        result.origin[axis] = spread(d, &walk.ray->origin_float[axis]);
        result.dir[axis] = spread(d, &walk.ray->dir_float[axis]);
        result.unit_dir[axis] = spread(d, &ray.unit_dir[axis]);
    }
    result.t_per_length = spread(d, &ray.t_per_length);
    result.origin_error = spread(d, &ray.origin_error);
    result.lo = spread(d, &walk.lo);
    result.reach = spread(d, &walk.reach);
    return result;
}

/// Returns which spheres of a block the ray may meet between `lo` and `reach`, a bit each.
HWY_INLINE std::uint32_t meet_spheres(const SphereBlock& block, Walk& walk) {
    const Floats d;
    const BoundRay<Floats> ray = bound_ray_of(d, walk);
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < kBoxWidth; i += kStep) {
        const BallBound<Floats> balls = {
            {hn::Load(d, block.center[0] + i), hn::Load(d, block.center[1] + i),
             hn::Load(d, block.center[2] + i)},
            hn::Load(d, block.radius + i)};
        const std::uint32_t there = lanes_there(block.ids + i, walk);
        bits |= (there & ~bits_of(d, misses(d, balls, ray))) << i;
    }
    return bits;
}

/// True if the ray surely misses a framed primitive between `lo` and `reach`.
HWY_INLINE bool misses_bound(const RoundBound& bound, Walk& walk) {
    const hn::CappedTag<float, 1> d;
    return hn::AllTrue(d, misses(d, bound, bound_ray_of(d, walk)));
}

}  // namespace lray::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
