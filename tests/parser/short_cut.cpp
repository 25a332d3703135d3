#include "tests/parser/short_cut.h"

#include <fmt/format.h>

#include <string_view>

#include "base/diagnostic_printer.h"

namespace lray::test {

namespace {

/// What a scene holds, as text: equal for equal scenes.
std::string dump(const scene::Scene& scene, const Sources& sources) {
    std::string text;
    const auto add = [&](auto... numbers) {
        (fmt::format_to(std::back_inserter(text), " {}", numbers), ...);
    };
    const auto add3 = [&](DVec3 v) { add(v.x, v.y, v.z); };
    const auto node = [&](const auto& self, scene::NodeId id) -> void {
        const scene::Node& n = scene.node(id);
        text += fmt::format("\n{}:", static_cast<int>(n.kind));
        if (!n.span.is_nowhere())
            text += place_of(sources, n.span) + fmt::format("+{}", n.span.length);
        add(n.visible, n.casts_shadow);
        if (!n.material_id.is_none()) {
            const Color diffuse = scene.materials[n.material_id.index()].diffuse.constant;
            add(n.material_id.index(), diffuse.r, diffuse.g, diffuse.b);
        }
        if (!n.transform_id.is_none()) add3(scene.transforms[n.transform_id.index()].offset());
        if (!n.label_id.is_none()) text += scene.labels[n.label_id.index()];
        switch (n.kind) {
            case scene::NodeKind::group:
                for (const scene::NodeId child : scene.groups[n.index].children) self(self, child);
                break;
            case scene::NodeKind::instance:
                self(self, scene.instances[n.index].target);
                break;
            case scene::NodeKind::sphere:
                add3(scene.spheres[n.index].center);
                add(scene.spheres[n.index].radius);
                break;
            case scene::NodeKind::rectangle:
                add3(scene.rectangles[n.index].corner);
                add3(scene.rectangles[n.index].edge_u);
                add3(scene.rectangles[n.index].edge_v);
                break;
            case scene::NodeKind::triangle:
                add3(scene.triangles[n.index].a);
                add3(scene.triangles[n.index].b);
                add3(scene.triangles[n.index].c);
                break;
            case scene::NodeKind::cylinder:
                add3(scene.cylinders[n.index].from);
                add3(scene.cylinders[n.index].to);
                add(scene.cylinders[n.index].radius, scene.cylinders[n.index].radius_to);
                add(scene.cylinders[n.index].caps);
                break;
            case scene::NodeKind::disk:
                add3(scene.disks[n.index].center);
                add3(scene.disks[n.index].normal);
                add(scene.disks[n.index].radius, scene.disks[n.index].hole);
                break;
            case scene::NodeKind::box:
                add3(scene.boxes[n.index].min);
                add3(scene.boxes[n.index].max);
                break;
            case scene::NodeKind::plane:
                add3(scene.planes[n.index].point);
                add3(scene.planes[n.index].normal);
                break;
            case scene::NodeKind::torus:
                add(scene.tori[n.index].radius, scene.tori[n.index].tube);
                break;
            case scene::NodeKind::light:
                add(scene.lights[n.index].shape.index(), scene.lights[n.index].intensity);
                break;
            case scene::NodeKind::mesh:
                add(scene.mesh_uses[n.index].z_is_up);
                break;
        }
    };
    node(node, scene.root);
    return text;
}

}  // namespace

std::string outcome(const Loaded& loaded) {
    PrintOptions all;
    all.max_errors = 0;
    std::string text = format_diagnostics(loaded.diagnostics, loaded.sources, all) +
                       (loaded.scene ? dump(*loaded.scene, loaded.sources) : "no scene");
    const std::string_view path = loaded.sources[0].path;  // in a directory of its own
    const std::string_view directory = path.substr(0, path.rfind('/') + 1);
    for (std::size_t at = 0; (at = text.find(directory, at)) != text.npos;) {
        text.erase(at, directory.size());
    }
    return text;
}

parser::LoadSettings without_short_cut(parser::LoadSettings settings) {
    settings.use_literal_fast_path = false;
    return settings;
}

}  // namespace lray::test
