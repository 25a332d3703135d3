#include "scene/formats/nff_nodes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

#include "base/angle.h"
#include "base/portable_math.h"

namespace lray::scene {

namespace {

constexpr double kMaxShininess = 10'000.0;  // of a material

Material material_of(const NffSurface& surface) {
    Material material;
    material.model = ReflectionModel::lambert;
    material.diffuse = Color{surface.diffuse * surface.color};
    if (surface.specular > 0.0) {
        const Color specular{static_cast<float>(surface.specular)};
        material.model = ReflectionModel::phong;
        material.specular = specular;
        material.shininess = static_cast<float>(std::min(surface.shine, kMaxShininess));
        material.reflect = specular;
    }
    if (surface.transmit > 0.0) {
        material.transmit = Color{static_cast<float>(surface.transmit)};
        // Files write 0 where nothing is bent.
        material.ior = surface.index > 0.0 ? static_cast<float>(surface.index) : 1.0f;
    }
    return material;
}

Light light_of(const NffLight& nff, std::size_t light_count) {
    PointLight point;
    point.position = nff.position;
    point.falloff = Falloff::none;
    Light light;
    light.shape = point;
    light.color = nff.color ? Color{*nff.color} : Color{1.0f};
    const double strength = nff.color ? 1.0 : 1.0 / std::sqrt(static_cast<double>(light_count));
    light.intensity = 4.0 * std::numbers::pi * strength;
    return light;
}

/// Moves all elements behind those of `to`, and returns how many were there.
template <class T>
std::uint32_t append(std::vector<T>& to, std::vector<T>&& from) {
    const auto count = static_cast<std::uint32_t>(to.size());
    if (to.empty()) {
        to = std::move(from);
    } else {
        to.insert(to.end(), std::make_move_iterator(from.begin()),
                  std::make_move_iterator(from.end()));
    }
    from = {};
    return count;
}

}  // namespace

NffNodes add_nff(NffScene&& nff, Scene& scene) {
    NffNodes nodes;
    nodes.first = static_cast<std::uint32_t>(scene.nodes.size());
    nodes.shape_count = static_cast<std::uint32_t>(nff.shapes.size());
    nodes.light_count = static_cast<std::uint32_t>(nff.lights.size());

    const std::size_t first_material = scene.materials.size();
    for (const NffSurface& surface : nff.surfaces) scene.materials.push_back(material_of(surface));
    const std::uint32_t first_attributes =
        append(scene.triangle_attributes, std::move(nff.triangle_attributes));
    for (TriangleShape& triangle : nff.triangles) {
        if (triangle.attributes == TriangleShape::kNoAttributes) continue;
        triangle.attributes += first_attributes;
    }
    const std::uint32_t first_sphere = append(scene.spheres, std::move(nff.spheres));
    const std::uint32_t first_cylinder = append(scene.cylinders, std::move(nff.cylinders));
    const std::uint32_t first_triangle = append(scene.triangles, std::move(nff.triangles));

    for (const NffShape& shape : nff.shapes) {
        Node node;
        node.kind = shape.kind;
        node.index = shape.index + (shape.kind == NodeKind::sphere     ? first_sphere
                                    : shape.kind == NodeKind::cylinder ? first_cylinder
                                                                       : first_triangle);
        node.material_id = MaterialId(first_material + shape.surface);
        node.span = shape.span;
        scene.nodes.push_back(node);
    }
    for (const NffLight& light : nff.lights) {
        Node node;
        node.kind = NodeKind::light;
        node.index = static_cast<std::uint32_t>(scene.lights.size());
        node.span = light.span;
        scene.lights.push_back(light_of(light, nff.lights.size()));
        scene.nodes.push_back(node);
    }
    return nodes;
}

Camera camera_of(const NffView& view) {
    Camera camera;
    camera.position = view.from;
    camera.look_at = view.at;
    camera.up = view.up;
    camera.fov = radians(view.angle);
    camera.span = view.span;
    const Resolution size = view.resolution.value_or(Resolution{});
    camera.resolution = view.resolution;
    if (view.resolution && size.height > size.width) {
        const DVec2 half = unit_circle_point(view.angle / 720.0);
        camera.fov = 4.0 * std::numbers::pi * turns_of({half.x * size.width, half.y * size.height});
    }
    return camera;
}

}  // namespace lray::scene
