#include "render/pick.h"

#include "base/diagnostic_place.h"
#include "base/excerpt.h"
#include "base/terminal_text.h"
#include "bvh/surface.h"
#include "render/camera_rays.h"
#include "scene/object_path.h"
#include "scene/place.h"

namespace lray::render {

namespace {

std::string name_of(const scene::Scene& scene, const scene::ObjectPath& path) {
    std::string name;
    for (const scene::NodeId id : path) {
        const scene::Node& node = scene.node(id);
        if (node.label_id.is_none() && id != path.back()) continue;
        if (!name.empty()) name += " > ";
        name += title_of(scene, node);
    }
    return escape_for_terminal(name, kMaxMessageSize);
}

std::string text_of(const Sources& sources, Span span) {
    return span.is_nowhere() ? std::string() : place_text(sources, span);
}

}  // namespace

std::optional<Pick> pick(const scene::Scene& scene, const scene::World& world,
                         const bvh::Accel& accel, const Sources& sources,
                         const scene::Camera& camera, scene::Resolution resolution,
                         DVec2 position_pixel, const std::atomic<bool>& cancel) {
    const Ray ray = CameraRays(camera, resolution).through(position_pixel);
    bvh::TraceCounts counts{.cancel = &cancel};
    const bvh::Hit hit = accel.nearest_hit(ray, {}, counts);
    if (hit.is_none() || counts.is_ended || cancel.load(std::memory_order_relaxed)) {
        return std::nullopt;
    }
    const scene::Geometry& geometry = *scene::path_to(world, hit.place).geometry;
    const scene::ObjectPath path =
        path_of(scene, world, hit.place, geometry.object_of(hit.primitive_id));
    const bvh::SurfacePoint surface = surface_at(world, ray, hit);

    Pick result;
    result.name = name_of(scene, path);
    result.place = text_of(sources, scene.node(path.back()).span);
    for (const scene::NodeId instance : instances_elsewhere(scene, path, 1)) {
        result.placed_at = text_of(sources, scene.node(instance).span);
    }
    result.point = DVec3{surface.position};
    result.normal = DVec3{surface.normal};
    result.distance = static_cast<double>(hit.t);
    return result;
}

}  // namespace lray::render
