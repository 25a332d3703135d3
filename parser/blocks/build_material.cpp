#include "parser/blocks/build_material.h"

#include <fmt/format.h>

#include <algorithm>

#include "parser/blocks/schemas.h"

namespace lray::parser {

namespace {

using namespace schemas;

scene::ReflectionModel model_of(std::string_view name) {
    const auto found = std::find(kModels.begin(), kModels.end(), name);
    LRAY_ASSERT(found != kModels.end());
    return static_cast<scene::ReflectionModel>(found - kModels.begin());
}
static_assert(kModels[static_cast<std::size_t>(scene::ReflectionModel::lambert)] == "lambert");
static_assert(kModels[static_cast<std::size_t>(scene::ReflectionModel::phong)] == "phong");
static_assert(kModels[static_cast<std::size_t>(scene::ReflectionModel::blinn_phong)] ==
              "blinn_phong");
static_assert(kModels[static_cast<std::size_t>(scene::ReflectionModel::cook_torrance)] ==
              "cook_torrance");
static_assert(kModels[static_cast<std::size_t>(scene::ReflectionModel::ward)] == "ward");

}  // namespace

scene::Material build_material(const PropertyValues& values, Span span, Diagnostics& diagnostics) {
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
    constexpr std::size_t kTwoSided = slot(kMaterial, "two_sided");
    scene::Material material;
    material.model = model_of(values.string(kModel, "blinn_phong"));
    material.ambient = values.optional_color(kAmbient);
    material.diffuse = values.color(kDiffuse);
    material.specular = values.optional_color(kSpecular);
    material.shininess = static_cast<float>(values.number(kShininess));
    material.roughness = Vec2{values.vec2(kRoughness)};
    material.fresnel = values.color(kFresnel);
    material.reflect = values.color(kReflect);
    material.transmit = values.color(kTransmit);
    material.ior = static_cast<float>(values.number(kIor));
    material.absorption = values.color(kAbsorption);
    material.emission = values.color(kEmission);
    material.opacity = static_cast<float>(values.number(kOpacity));
    material.two_sided = values.boolean(kTwoSided);

    // Only what the author wrote together is judged: the default diffuse is no claim.
    if (values.has(kDiffuse)) {
        const Color total = material.diffuse + material.reflect + material.transmit;
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
