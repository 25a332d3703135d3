// A hierarchy without a scene: what a ray hits follows from its direction alone.
#pragma once

#include <cmath>
#include <cstddef>

#include "base/angle.h"
#include "bvh/accel.h"
#include "scene/camera.h"
#include "scene/world.h"

namespace lray::render {

/// A pattern over all directions, so that every pixel's colour tells where its ray went.
class PatternAccel : public bvh::Accel {
 public:
    static constexpr int kStripes = 37;

    bvh::Hit nearest_hit(const Ray& ray, Interval, bvh::TraceCounts& counts) const override {
        ++counts.rays;
        counts.primitive_tests += 3;
        const float cell = std::floor(ray.dir.x * 91.0f) + 5.0f * std::floor(ray.dir.y * 53.0f);
        const int stripe = static_cast<int>(std::fabs(cell)) % (kStripes + 1);
        if (stripe == kStripes) return {};  // a miss: the background
        return {1.0f, 0.0f, 0.0f,
                scene::PrimitiveId(scene::PrimitiveKind::sphere, static_cast<std::size_t>(stripe))};
    }
    bool any_hit(const Ray& ray, Interval interval, bvh::TraceCounts& counts) const override {
        return !nearest_hit(ray, interval, counts).is_none();
    }

    bvh::AccelStats stats() const override { return {}; }
};

/// The world of the pattern: a material for each stripe.
inline scene::World pattern_world() {
    scene::World world;
    auto& ids = world.object_ids[static_cast<std::size_t>(scene::PrimitiveKind::sphere)];
    for (std::size_t i = 0; i < PatternAccel::kStripes; ++i) {
        ids.emplace_back(i);
        world.objects.emplace_back();
        world.objects.back().material = static_cast<std::uint32_t>(i);
        world.materials.emplace_back();
        world.materials.back().diffuse = Color{0.1f * static_cast<float>(i), 0.7f, 0.01f};
    }
    return world;
}

inline scene::Camera pattern_camera() {
    scene::Camera camera;
    camera.fov = radians(80.0);
    return camera;
}

}  // namespace lray::render
