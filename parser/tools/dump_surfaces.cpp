#include "parser/tools/dump_surfaces.h"

#include <fmt/format.h>

#include <variant>

#include "parser/blocks/schemas.h"
#include "parser/tools/dump_text.h"

namespace lray::parser {

namespace {

std::string stops_text(const std::vector<scene::ColorStop>& stops) {
    std::string text = "[";
    for (const scene::ColorStop& stop : stops) {
        if (&stop != stops.data()) text += ", ";
        text += fmt::format("[{}, {}]", stop.at, exact_color(stop.color));
    }
    return text + "]";
}

template <class Shape>
void add_two_colors(const Shape& shape, DumpBlock& block) {
    block.add("a", exact_color(shape.a));
    block.add("b", exact_color(shape.b));
    block.add("size", shape.size);
}

/// Adds what a pattern has, one overload for each, and returns the name of its block.
struct PatternWriter {
    const scene::Scene& scene;
    DumpBlock& block;

    std::string_view operator()(const scene::ImageTexture& image) const {
        block.add("file", quoted(scene.pictures[image.picture_id.index()].file));
        block.add("wrap", option(schemas::kWraps, image.wrap));
        block.add("filter", option(schemas::kFilters, image.filter));
        block.add("srgb", image.is_srgb);
        return "image";
    }
    std::string_view operator()(const scene::CheckerTexture& checker) const {
        add_two_colors(checker, block);
        return "checker";
    }
    std::string_view operator()(const scene::StripesTexture& stripes) const {
        add_two_colors(stripes, block);
        block.add("axis", option(schemas::kAxes, stripes.axis));
        return "stripes";
    }
    std::string_view operator()(const scene::GradientTexture& gradient) const {
        block.add("axis", option(schemas::kAxes, gradient.axis));
        block.add("stops", stops_text(gradient.stops));
        return "gradient";
    }
    std::string_view operator()(const scene::RampTexture& ramp) const {
        block.add("axis", option(schemas::kAxes, ramp.axis));
        block.add("stops", stops_text(ramp.stops));
        return "ramp";
    }
    std::string_view operator()(const scene::NoiseTexture& noise) const {
        block.add("octaves", fmt::to_string(noise.octaves));
        block.add("lacunarity", noise.lacunarity);
        block.add("gain", noise.gain);
        block.add("seed", noise.seed);
        block.add("stops", stops_text(noise.stops));
        return "noise_texture";
    }
    std::string_view operator()(const scene::MarbleTexture& marble) const {
        add_veins(marble);
        return "marble";
    }
    std::string_view operator()(const scene::WoodTexture& wood) const {
        add_veins(wood);
        return "wood";
    }
    std::string_view operator()(const scene::VertexColorsTexture&) const { return "vertex_colors"; }

 private:
    template <class Veined>
    void add_veins(const Veined& veined) const {
        add_two_colors(veined, block);
        block.add("turbulence", veined.turbulence);
        block.add("octaves", fmt::to_string(veined.octaves));
        block.add("axis", option(schemas::kAxes, veined.axis));
        block.add("seed", veined.seed);
    }
};

/// Returns the textures that a material uses, in the order of their properties.
std::vector<scene::TextureId> textures_of(const scene::Material& m) {
    std::vector<scene::TextureId> ids;
    const auto add = [&](scene::TextureId id) {
        if (!id.is_none()) ids.push_back(id);
    };
    if (m.ambient) add(m.ambient->texture_id);
    add(m.diffuse.texture_id);
    if (m.specular) add(m.specular->texture_id);
    add(m.shininess.texture_id);
    add(m.roughness.texture_id);
    for (const scene::Coefficient& coefficient :
         {m.fresnel, m.reflect, m.transmit, m.absorption, m.emission}) {
        add(coefficient.texture_id);
    }
    add(m.opacity.texture_id);
    add(m.bump_id);
    add(m.normal_map_id);
    return ids;
}

}  // namespace

DumpSurfaces::DumpSurfaces(const scene::Scene& scene, const DumpPlan& plan)
    : scene_(scene),
      texture_names_(scene.textures.size()),
      material_names_(scene.materials.size()) {
    std::vector<bool> uses_material(scene.materials.size());
    std::vector<bool> uses_texture(scene.textures.size());
    for (const scene::NodeId id : plan.order) {
        const scene::Node& node = scene.node(id);
        if (!node.material_id.is_none()) uses_material[node.material_id.index()] = true;
        if (node.kind != scene::NodeKind::light) continue;
        const auto* sky = std::get_if<scene::EnvironmentLight>(&scene.lights[node.index].shape);
        if (sky != nullptr && !sky->texture_id.is_none()) {
            uses_texture[sky->texture_id.index()] = true;
        }
    }
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (!uses_material[i]) continue;
        for (const auto id : textures_of(scene.materials[i])) uses_texture[id.index()] = true;
    }
    const auto define = [this](std::map<std::string, std::string>& known, char letter,
                               std::string text) {
        const auto [it, is_new] = known.try_emplace(std::move(text));
        if (is_new) {
            it->second = fmt::format("{}{}", letter, known.size());
            definitions_ += fmt::format("let {} = {}\n", it->second, it->first);
        }
        return it->second;
    };
    // What `let m123456 = ` takes of the line.
    constexpr std::size_t kBefore = 16;
    std::map<std::string, std::string> textures;
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        if (!uses_texture[i]) continue;
        texture_names_[i] = define(textures, 't', texture_text(scene.textures[i], kBefore));
    }
    std::map<std::string, std::string> materials;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (!uses_material[i]) continue;
        material_names_[i] = define(materials, 'm', material_text(scene.materials[i], kBefore));
    }
}

std::string DumpSurfaces::texture_text(const scene::Texture& texture, std::size_t before) const {
    DumpBlock block;
    const std::string_view name = std::visit(PatternWriter{scene_, block}, texture.pattern);
    if (texture.space == scene::TextureSpace::vertex_colors) {
        return block.definition_text(name, before);
    }
    block.add("space", option(schemas::kSpaces, texture.space));
    block.add_steps(texture.space_from_texture);
    return block.definition_text(name, before);
}

std::string DumpSurfaces::material_text(const scene::Material& m, std::size_t before) const {
    const scene::Material defaults;
    DumpBlock block;
    const auto color = [&](std::string_view name, const scene::Coefficient& value) {
        block.add(name,
                  value.is_textured() ? texture(value.texture_id) : exact_color(value.constant));
    };
    const auto scalar = [&](std::string_view name, const scene::ScalarCoefficient& value) {
        block.add(name, value.is_textured() ? texture(value.texture_id) : exact(value.constant));
    };
    const auto color_unless = [&](std::string_view name, const scene::Coefficient& value,
                                  const scene::Coefficient& fallback) {
        if (!(value == fallback)) color(name, value);
    };
    if (m.model != defaults.model) block.add("model", option(schemas::kModels, m.model));
    if (m.ambient) color("ambient", *m.ambient);
    color_unless("diffuse", m.diffuse, defaults.diffuse);
    if (m.specular) color("specular", *m.specular);
    if (!(m.shininess == defaults.shininess)) scalar("shininess", m.shininess);
    if (m.roughness.is_textured()) {
        block.add("roughness", texture(m.roughness.texture_id));
    } else if (!(m.roughness == defaults.roughness)) {
        const Vec2 along = m.roughness.constant;
        block.add("roughness", along.x == along.y
                                   ? exact(along.x)
                                   : fmt::format("[{}, {}]", exact(along.x), exact(along.y)));
    }
    color_unless("fresnel", m.fresnel, defaults.fresnel);
    color_unless("reflect", m.reflect, defaults.reflect);
    color_unless("transmit", m.transmit, defaults.transmit);
    // One that is too small for a float is 0, which cannot be written.
    if (m.ior != defaults.ior) block.add("ior", m.ior == 0.0f ? "1e-300" : exact(m.ior));
    color_unless("absorption", m.absorption, defaults.absorption);
    color_unless("emission", m.emission, defaults.emission);
    if (!(m.opacity == defaults.opacity)) scalar("opacity", m.opacity);
    if (!m.bump_id.is_none()) block.add("bump", texture(m.bump_id));
    if (m.bump_height != defaults.bump_height) block.add("bump_height", exact(m.bump_height));
    if (m.bump_unit == scene::BumpUnit::uv) block.add("bump_unit", "\"uv\"");
    if (!m.normal_map_id.is_none()) block.add("normal_map", texture(m.normal_map_id));
    if (!m.two_sided) block.add("two_sided", m.two_sided);
    return block.definition_text("material", before);
}

}  // namespace lray::parser
