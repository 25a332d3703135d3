#include "shade/normals.h"

#include "bvh/surface.h"

namespace lray::shade {

Color normals(const scene::World& world, const Ray& ray, const bvh::Hit& hit) {
    if (hit.is_none()) return Color{0.0f};
    return 0.5f * (bvh::surface_at(world, ray, hit).normal + Vec3{1.0f});
}

}  // namespace lray::shade
