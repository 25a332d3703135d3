#include "shade/uv.h"

#include <cmath>

#include "bvh/surface_detail.h"

namespace lray::shade {

namespace {

/// In [0, 1), of negative numbers too; 0 of what is too large to have a fraction.
float fraction(double x) {
    const double rest = x - std::floor(x);
    // A little below a whole number rounds to 1, which is where the next one begins.
    const float rounded = static_cast<float>(rest);
    return rounded < 1.0f ? rounded : 0.0f;  // NaN, of infinities, is 0
}

}  // namespace

Color uv(const scene::World& world, const Ray& ray, const bvh::Hit& hit) {
    if (hit.is_none()) return Color{0.0f};
    const bvh::SurfacePoint point = bvh::surface_at(world, ray, hit);
    const DVec2 uv = bvh::surface_detail(world, hit, point).uv;
    return {fraction(uv.x), fraction(uv.y), 0.0f};
}

}  // namespace lray::shade
