#include "parser/blocks/build_material.h"

#include <fmt/format.h>

#include <algorithm>

#include "parser/blocks/schemas.h"

namespace lray::parser {

namespace {

using namespace schemas;

/// Returns the value whose name stands at its place in the list.
template <class Value, class Names>
Value in_order(const Names& names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    LRAY_ASSERT(found != names.end());
    return static_cast<Value>(found - names.begin());
}
static_assert(kBumpUnits[static_cast<std::size_t>(scene::BumpUnit::metre)] == "metre");
static_assert(kBumpUnits[static_cast<std::size_t>(scene::BumpUnit::uv)] == "uv");
static_assert(kModels[static_cast<std::size_t>(scene::ReflectionModel::lambert)] == "lambert");
static_assert(kModels[static_cast<std::size_t>(scene::ReflectionModel::phong)] == "phong");
static_assert(kModels[static_cast<std::size_t>(scene::ReflectionModel::blinn_phong)] ==
              "blinn_phong");
static_assert(kModels[static_cast<std::size_t>(scene::ReflectionModel::cook_torrance)] ==
              "cook_torrance");
static_assert(kModels[static_cast<std::size_t>(scene::ReflectionModel::ward)] == "ward");

/// Coefficients by their slot: what the value says, or the texture and its average.
struct CoefficientReader {
    const PropertyValues& values;
    std::span<const scene::Texture> textures;

    scene::Coefficient color(std::size_t slot) const {
        const scene::TextureId id = values.texture(slot);
        if (id.is_none()) return values.color(slot);
        return {textures[id.index()].average, id};
    }
    scene::ScalarCoefficient scalar(std::size_t slot) const {
        const scene::TextureId id = values.texture(slot);
        if (id.is_none()) return static_cast<float>(values.number(slot));
        return {average(id), id};
    }
    scene::PlanarCoefficient planar(std::size_t slot) const {
        const scene::TextureId id = values.texture(slot);
        if (id.is_none()) return Vec2{values.vec2(slot)};
        return {Vec2{average(id)}, id};
    }

 private:
    float average(scene::TextureId id) const {
        const Color color = textures[id.index()].average;
        return (color.x + color.y + color.z) / 3.0f;
    }
};

}  // namespace

scene::Material build_material(const PropertyValues& values,
                               std::span<const scene::Texture> textures, Span span,
                               Diagnostics& diagnostics) {
    constexpr std::size_t kModel = slot(kMaterial, "model");
    constexpr std::size_t kAmbient = slot(kMaterial, "ambient");
    constexpr std::size_t kDiffuse = slot(kMaterial, "diffuse");
    constexpr std::size_t kSpecular = slot(kMaterial, "specular");
    constexpr std::size_t kShininess = slot(kMaterial, "shininess");
    constexpr std::size_t kRoughness = slot(kMaterial, "roughness");
    constexpr std::size_t kFresnel = slot(kMaterial, "fresnel");
    constexpr std::size_t kReflect = slot(kMaterial, "reflect");
    constexpr std::size_t kTransmit = slot(kMaterial, "transmit");
    constexpr std::size_t kIor = slot(kMaterial, "ior");
    constexpr std::size_t kAbsorption = slot(kMaterial, "absorption");
    constexpr std::size_t kEmission = slot(kMaterial, "emission");
    constexpr std::size_t kOpacity = slot(kMaterial, "opacity");
    constexpr std::size_t kBump = slot(kMaterial, "bump");
    constexpr std::size_t kBumpHeight = slot(kMaterial, "bump_height");
    constexpr std::size_t kBumpUnit = slot(kMaterial, "bump_unit");
    constexpr std::size_t kNormalMap = slot(kMaterial, "normal_map");
    constexpr std::size_t kTwoSided = slot(kMaterial, "two_sided");
    scene::Material material;
    material.model =
        in_order<scene::ReflectionModel>(kModels, values.string(kModel, "blinn_phong"));
    const CoefficientReader read{values, textures};
    if (values.has(kAmbient)) material.ambient = read.color(kAmbient);
    material.diffuse = read.color(kDiffuse);
    if (values.has(kSpecular)) material.specular = read.color(kSpecular);
    material.shininess = read.scalar(kShininess);
    material.roughness = read.planar(kRoughness);
    material.fresnel = read.color(kFresnel);
    material.reflect = read.color(kReflect);
    material.transmit = read.color(kTransmit);
    material.ior = static_cast<float>(values.number(kIor));
    material.absorption = read.color(kAbsorption);
    material.emission = read.color(kEmission);
    material.opacity = read.scalar(kOpacity);
    material.bump_id = values.texture(kBump);
    material.bump_height = values.number(kBumpHeight);
    material.bump_unit = in_order<scene::BumpUnit>(kBumpUnits, values.string(kBumpUnit, "metre"));
    material.normal_map_id = values.texture(kNormalMap);
    material.two_sided = values.boolean(kTwoSided);

    // Only constants that the author wrote together are judged: the default diffuse is no claim.
    const bool is_constant = !material.diffuse.is_textured() && !material.reflect.is_textured() &&
                             !material.transmit.is_textured();
    if (values.has(kDiffuse) && is_constant) {
        const Color total =
            material.diffuse.constant + material.reflect.constant + material.transmit.constant;
        const float most = std::max({total.x, total.y, total.z});
        constexpr float kTolerance = 1e-6f;  // 0.9 + 0.1 in floats
        const bool is_several = values.has(kReflect) || values.has(kTransmit);
        if (is_several && most > 1.0f + kTolerance) {
            diagnostics.warning(
                Code::W1402, span,
                fmt::format("`diffuse`, `reflect` and `transmit` together give back {:.0f} % of "
                            "the light",
                            static_cast<double>(most) * 100.0));
        }
    }
    if (material.ior < 1.0f) {
        diagnostics
            .warning(Code::W1404, span,
                     fmt::format("`ior` is {}, below 1", format_number(values.number(kIor))))
            .with_help("glass is about 1.5, water 1.33");
    }
    return material;
}

}  // namespace lray::parser
