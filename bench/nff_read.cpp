// Reading: NFF and OBJ by lray's own readers, both as the one description that is written.
#include "bench/nff_scene.h"

#include <limits>

#include "scene/formats/nff_reader.h"
#include "scene/obj_reader.h"

namespace lray::bench {

namespace {

void add_shape(const scene::NffScene& nff, const scene::NffShape& shape, NffScene& scene) {
    if (shape.kind == scene::NodeKind::sphere) {
        const scene::SphereShape& sphere = nff.spheres[shape.index];
        scene.spheres.push_back({shape.surface, sphere.center, sphere.radius});
    } else if (shape.kind == scene::NodeKind::cylinder) {
        const scene::CylinderShape& cone = nff.cylinders[shape.index];
        scene.cones.push_back({shape.surface, cone.from, cone.radius, cone.to, cone.radius_to});
    } else {
        const scene::TriangleShape& of = nff.triangles[shape.index];
        NffTriangle triangle{shape.surface, {of.a, of.b, of.c}, {}};
        if (of.attributes != scene::TriangleShape::kNoAttributes) {
            triangle.normals = nff.triangle_attributes[of.attributes].normals;
        }
        scene.triangles.push_back(triangle);
    }
}

}  // namespace

std::optional<NffScene> read_nff(const Sources& sources, SourceId file, Diagnostics& diagnostics) {
    const std::optional<scene::NffScene> nff = scene::read_nff(sources, file, {}, diagnostics);
    if (!nff) return std::nullopt;
    NffScene scene;
    scene.background = nff->background.value_or(DVec3{0.0});
    if (nff->view) {
        scene.camera = {nff->view->from, nff->view->at, nff->view->up, nff->view->angle};
    }
    for (const scene::NffLight& light : nff->lights) scene.lights.push_back(light.position);
    scene.surfaces = nff->surfaces;
    for (const scene::NffShape& shape : nff->shapes) add_shape(*nff, shape, scene);
    return scene;
}

std::optional<NffScene> read_obj_scene(const Sources& sources, SourceId file,
                                       Diagnostics& diagnostics) {
    const std::optional<scene::Mesh> mesh = scene::read_obj(sources, file, Span{}, diagnostics);
    if (!mesh) return std::nullopt;
    NffScene scene;
    scene.surfaces.push_back({});
    scene.background = {0.078, 0.361, 0.753};
    for (const scene::IndexTriple& t : mesh->triangles) {
        const std::array points{DVec3{mesh->positions[t[0]]}, DVec3{mesh->positions[t[1]]},
                                DVec3{mesh->positions[t[2]]}};
        scene.triangles.push_back({0, points, {}});
    }
    DVec3 low{std::numeric_limits<double>::infinity()};
    DVec3 high = -low;
    for (const Vec3& position : mesh->positions) {
        low = glm::min(low, DVec3{position});
        high = glm::max(high, DVec3{position});
    }
    const DVec3 middle = 0.5 * (low + high);
    const double size = glm::length(high - low);
    scene.camera = {middle + size * DVec3{0.5, 0.3, 1.0}, middle, {0.0, 1.0, 0.0}, 45.0};
    scene.lights.push_back(middle + size * DVec3{-2.0, 3.0, 2.5});
    return scene;
}

}  // namespace lray::bench
