#include "parser/tools/dump.h"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

#include "base/assert.h"
#include "parser/blocks/schemas.h"
#include "parser/tools/camera_text.h"
#include "parser/tools/dump_plan.h"
#include "parser/tools/dump_surfaces.h"
#include "parser/tools/dump_text.h"

namespace lray::parser {

namespace {

using scene::Node;
using scene::NodeId;
using scene::NodeKind;

constexpr std::size_t kChunk = std::size_t{1} << 16;  // of what is handed to the sink at once

/// Adds what a light's shape has, one overload for each, and returns the name of its block.
struct LightWriter {
    const DumpSurfaces& surfaces;
    DumpBlock& block;

    std::string_view operator()(const scene::PointLight& point) const {
        block.add("position", point.position);
        add_ball(point);
        return "point_light";
    }
    std::string_view operator()(const scene::SpotLight& spot) const {
        block.add("position", spot.position);
        block.add("direction", spot.direction);
        block.add("angle", exact_angle(spot.angle));
        block.add("softness", spot.softness);
        add_ball(spot);
        return "spot_light";
    }
    std::string_view operator()(const scene::DirectionalLight& sun) const {
        block.add("direction", sun.direction);
        block.add("angle", exact_angle(sun.angle));
        if (sun.samples != 1) block.add("samples", fmt::to_string(sun.samples));
        return "directional_light";
    }
    std::string_view operator()(const scene::AreaLight& area) const {
        block.add("corner", area.corner);
        block.add("edge_u", area.edge_u);
        block.add("edge_v", area.edge_v);
        block.add("samples", fmt::to_string(area.samples));
        return "area_light";
    }
    std::string_view operator()(const scene::EnvironmentLight& sky) const {
        if (!sky.texture_id.is_none()) block.add("image", surfaces.texture(sky.texture_id));
        if (sky.samples != scene::EnvironmentLight{}.samples) {
            block.add("samples", fmt::to_string(sky.samples));
        }
        return "environment";
    }

 private:
    template <class Light>
    void add_ball(const Light& light) const {
        block.add("falloff", option(schemas::kFalloffs, light.falloff));
        if (light.radius != 0.0) block.add("radius", light.radius);
        if (light.samples != 1) block.add("samples", fmt::to_string(light.samples));
    }
};

class Dumper {
 public:
    Dumper(const scene::Scene& scene, const TextSink& sink)
        : scene_(scene), sink_(sink), plan_(plan_dump(scene)), surfaces_(scene, plan_) {}

    void run() {
        text_ = "lrs 1.0\n";
        write_views();
        run_contents();
    }

    void run_contents() {
        text_ += surfaces_.definitions();
        for (const NodeId id : plan_.definitions) {
            text_ += fmt::format("let n{} = ", plan_.names[id.index()]);
            write_node(id, 0);
            end_line();
        }
        for (const NodeId id : nodes_below(scene_, scene_.node(scene_.root))) write_use(id, 0);
        sink_(text_);
    }

 private:
    void end_line() {
        text_ += '\n';
        if (text_.size() < kChunk) return;
        sink_(text_);
        text_.clear();
    }

    void write_views() {
        if (!scene_.info.empty()) {
            DumpBlock info;
            for (const auto& [name, value] : scene_.info) info.add(name, quoted(value));
            text_ += info.text("info", 0) + "\n";
        }
        write_render();
        if (scene_.animation) {
            DumpBlock animation;
            animation.add("frames", fmt::to_string(scene_.animation->frames));
            animation.add("fps", scene_.animation->fps);
            animation.add("start", scene_.animation->start);
            text_ += animation.text("animation", 0) + "\n";
        }
        for (const scene::Camera& camera : scene_.cameras) {
            text_ += camera_text(camera, CameraDetail::all) + "\n";
        }
    }

    void write_render() {
        const scene::RenderSettings& render = scene_.render;
        DumpBlock block;
        block.add("resolution", exact(render.resolution));
        block.add("samples", fmt::to_string(render.samples));
        block.add("max_depth", fmt::to_string(render.max_depth));
        block.add("background", exact_color(render.background));
        block.add("ambient", exact_color(render.ambient));
        block.add("exposure", render.exposure);
        block.add("tonemap", option(schemas::kToneMaps, render.tonemap));
        block.add("gamma", option(schemas::kGammas, render.gamma));
        block.add("seed", fmt::to_string(render.seed));
        block.add("integrator", option(schemas::kIntegrators, render.integrator));
        block.add("sampler", option(schemas::kSamplers, render.sampler));
        block.add("transparent_shadows", render.transparent_shadows);
        text_ += block.text("render", 0) + "\n";
    }

    std::string labelled(std::string_view head, const Node& node) const {
        if (node.label_id.is_none()) return std::string(head);
        return fmt::format("{} {}", head, quoted(scene_.labels[node.label_id.index()]));
    }

    void add_common(const Node& node, DumpBlock& block) const {
        if (!node.transform_id.is_none()) {
            block.add_steps(scene_.transforms[node.transform_id.index()]);
        }
        if (!node.material_id.is_none())
            block.add("material", surfaces_.material(node.material_id));
        if (!node.visible) block.add("visible", false);
        if (!node.casts_shadow) block.add("casts_shadow", false);
    }

    /// Writes a node where it stands: a definition as one more instance of it.
    void write_use(NodeId id, std::size_t indent) {
        text_.append(indent, ' ');
        if (const std::uint32_t name = plan_.names[id.index()]; name != 0) {
            text_ += fmt::format("n{} {{ }}", name);
        } else {
            write_node(id, indent);
        }
        end_line();
    }

    // How deep this recurses is bounded by the plan.
    void write_node(NodeId id, std::size_t indent) {
        const Node& node = scene_.node(id);
        if (node.kind == NodeKind::group) return write_group(id, indent);
        DumpBlock block;
        if (node.kind == NodeKind::instance) {
            const NodeId target = scene_.instances[node.index].target;
            const std::uint32_t name = plan_.names[target.index()];
            // Behind `let n2 =`, `n1 { }` would be a copy and no instance.
            if (name == 0 || plan_.names[id.index()] != 0) return write_group(id, indent);
            add_common(node, block);
            text_ += block.text(labelled(fmt::format("n{}", name), node), indent);
            return;
        }
        if (node.kind == NodeKind::mesh) return write_mesh(node, indent);
        const std::string_view head = add_shape(node, block);
        add_common(node, block);
        text_ += block.text(labelled(head, node), indent);
    }

    void write_group(NodeId id, std::size_t indent) {
        const Node& node = scene_.node(id);
        DumpBlock block;
        add_common(node, block);
        const auto children = nodes_below(scene_, node);
        if (children.empty()) {
            text_ += block.text(labelled("group", node), indent);
            return;
        }
        text_ += labelled("group", node) + " {\n";
        block.append_lines(text_, indent + 2);
        for (const NodeId child : children) write_use(child, indent + 2);
        text_.append(indent, ' ');
        text_ += '}';
    }

    std::string_view add_shape(const Node& node, DumpBlock& block) const {
        switch (node.kind) {
            case NodeKind::sphere: {
                const scene::SphereShape& sphere = scene_.spheres[node.index];
                block.add("center", sphere.center);
                block.add("radius", sphere.radius);
                return "sphere";
            }
            case NodeKind::rectangle: {
                const scene::RectangleShape& rectangle = scene_.rectangles[node.index];
                block.add("corner", rectangle.corner);
                block.add("edge_u", rectangle.edge_u);
                block.add("edge_v", rectangle.edge_v);
                return "rectangle";
            }
            case NodeKind::triangle:
                add_triangle(scene_.triangles[node.index], block);
                return "triangle";
            case NodeKind::cylinder: {
                const scene::CylinderShape& cylinder = scene_.cylinders[node.index];
                block.add("from", cylinder.from);
                block.add("to", cylinder.to);
                block.add("radius", cylinder.radius);
                if (cylinder.radius_to != cylinder.radius) {
                    block.add("radius_to", cylinder.radius_to);
                }
                if (!cylinder.caps) block.add("caps", false);
                return "cylinder";
            }
            case NodeKind::disk: {
                const scene::DiskShape& disk = scene_.disks[node.index];
                block.add("center", disk.center);
                block.add("normal", disk.normal);
                block.add("radius", disk.radius);
                if (disk.hole != 0.0) block.add("hole", disk.hole);
                return "disk";
            }
            case NodeKind::box: {
                const scene::BoxShape& box = scene_.boxes[node.index];
                block.add("min", box.min);
                block.add("max", box.max);
                return "box";
            }
            case NodeKind::plane: {
                const scene::PlaneShape& plane = scene_.planes[node.index];
                block.add("point", plane.point);
                block.add("normal", plane.normal);
                return "plane";
            }
            case NodeKind::torus: {
                const scene::TorusShape& torus = scene_.tori[node.index];
                block.add("radius", torus.radius);
                block.add("tube", torus.tube);
                return "torus";
            }
            case NodeKind::light:
                return add_light(scene_.lights[node.index], block);
            case NodeKind::group:
            case NodeKind::mesh:
            case NodeKind::instance:
                break;
        }
        LRAY_ASSERT(false);
    }

    void add_triangle(const scene::TriangleShape& triangle, DumpBlock& block) const {
        block.add("a", triangle.a);
        block.add("b", triangle.b);
        block.add("c", triangle.c);
        if (triangle.attributes == scene::TriangleShape::kNoAttributes) return;
        const auto& attributes = scene_.triangle_attributes[triangle.attributes];
        if (attributes.normals) {
            const auto& [a, b, c] = *attributes.normals;
            block.add("normals", fmt::format("[{}, {}, {}]", exact(a), exact(b), exact(c)));
        }
        if (attributes.uvs) {
            const auto& [a, b, c] = *attributes.uvs;
            block.add("uvs",
                      fmt::format("[[{}, {}], [{}, {}], [{}, {}]]", a.x, a.y, b.x, b.y, c.x, c.y));
        }
    }

    std::string_view add_light(const scene::Light& light, DumpBlock& block) const {
        const std::string_view head = std::visit(LightWriter{surfaces_, block}, light.shape);
        const auto* sky = std::get_if<scene::EnvironmentLight>(&light.shape);
        // A sky with a picture takes no colour.
        if (sky == nullptr || sky->texture_id.is_none()) {
            block.add("color", exact_color(light.color));
        }
        block.add("intensity", light.intensity);
        return head;
    }

    void write_mesh(const Node& node, std::size_t indent) {
        const scene::MeshUse& use = scene_.mesh_uses[node.index];
        const scene::Mesh& mesh = scene_.meshes[use.mesh_id.index()];
        DumpBlock block;
        if (!mesh.file.empty()) block.add("file", quoted(mesh.file));
        if (use.part != scene::MeshUse::kAllParts) {
            block.add("part", quoted(mesh.parts[use.part].name));
        }
        if (use.z_is_up) block.add("up", "\"z\"");
        if (mesh.smooth_degrees) block.add("smooth", *mesh.smooth_degrees);
        const bool has_looks = !mesh.material_names.empty() || !mesh.colors.empty();
        const bool shows_none = has_looks && !use.shows_materials && !mesh.file.empty();
        if (shows_none && node.material_id.is_none()) block.add("use_mtl", false);
        add_common(node, block);
        if (!mesh.file.empty()) {
            text_ += block.text(labelled("mesh", node), indent);
            return;
        }
        text_ += labelled("mesh", node) + " {\n";
        block.append_lines(text_, indent + 2);
        write_rows("positions", mesh.positions, 3, indent + 2);
        write_rows("triangles", mesh.triangles, 3, indent + 2);
        if (!mesh.normals.empty() && !mesh.smooth_degrees)
            write_rows("normals", mesh.normals, 3, indent + 2);
        if (!mesh.uvs.empty()) write_rows("uvs", mesh.uvs, 2, indent + 2);
        if (!mesh.colors.empty()) write_rows("colors", mesh.colors, 3, indent + 2);
        text_.append(indent, ' ');
        text_ += '}';
    }

    template <class Row>
    void write_rows(std::string_view name, const std::vector<Row>& rows, int width,
                    std::size_t indent) {
        text_.append(indent, ' ');
        text_ += name;
        text_ += ": [\n";
        for (std::size_t i = 0; i < rows.size(); ++i) {
            text_.append(indent + 2, ' ');
            text_ += '[';
            for (int k = 0; k < width; ++k) {
                if (k > 0) text_ += ", ";
                append_element(rows[i], k);
            }
            text_ += i + 1 < rows.size() ? "]," : "]";
            end_line();
        }
        text_.append(indent, ' ');
        text_ += "]\n";
    }

    void append_element(const scene::IndexTriple& row, int k) {
        fmt::format_to(std::back_inserter(text_), "{}", row[static_cast<std::size_t>(k)]);
    }
    template <class Vector>
    void append_element(const Vector& row, int k) {
        append_exact(text_, row[k]);
    }

    const scene::Scene& scene_;
    const TextSink& sink_;
    DumpPlan plan_;
    DumpSurfaces surfaces_;
    std::string text_;  // not handed to the sink yet
};

}  // namespace

void dump(const scene::Scene& scene, const TextSink& sink) {
    Dumper(scene, sink).run();
}

void dump_contents(const scene::Scene& scene, const TextSink& sink) {
    Dumper(scene, sink).run_contents();
}

std::string dump(const scene::Scene& scene) {
    std::string text;
    dump(scene, [&](std::string_view piece) { text += piece; });
    return text;
}

}  // namespace lray::parser
