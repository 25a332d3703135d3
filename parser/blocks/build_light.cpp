#include "parser/blocks/build_light.h"

#include <utility>

#include "base/angle.h"
#include "parser/blocks/build_texture.h"
#include "parser/blocks/schemas.h"

namespace lray::parser {

namespace {

using namespace schemas;

static_assert(kFalloffs[static_cast<std::size_t>(scene::Falloff::quadratic)] == "quadratic");
static_assert(kFalloffs[static_cast<std::size_t>(scene::Falloff::linear)] == "linear");
static_assert(kFalloffs[static_cast<std::size_t>(scene::Falloff::none)] == "none");

scene::PointLight point_light(const PropertyValues& values) {
    constexpr std::size_t kPosition = slot(kPointLight, "position");
    constexpr std::size_t kFalloff = slot(kPointLight, "falloff");
    constexpr std::size_t kRadius = slot(kPointLight, "radius");
    constexpr std::size_t kSamples = slot(kPointLight, "samples");
    return {values.vec3(kPosition), values.option<scene::Falloff>(kFalloff), values.number(kRadius),
            values.integer(kSamples)};
}

std::optional<scene::SpotLight> spot_light(const PropertyValues& values, Span span,
                                           Diagnostics& diagnostics) {
    constexpr std::size_t kPosition = slot(kSpotLight, "position");
    constexpr std::size_t kDirection = slot(kSpotLight, "direction");
    constexpr std::size_t kTarget = slot(kSpotLight, "target");
    constexpr std::size_t kAngle = slot(kSpotLight, "angle");
    constexpr std::size_t kSoftness = slot(kSpotLight, "softness");
    constexpr std::size_t kFalloff = slot(kSpotLight, "falloff");
    constexpr std::size_t kRadius = slot(kSpotLight, "radius");
    constexpr std::size_t kSamples = slot(kSpotLight, "samples");
    scene::SpotLight spot;
    spot.position = values.vec3(kPosition);
    spot.direction = values.vec3(kDirection);
    if (values.has(kTarget)) spot.direction = values.vec3(kTarget) - spot.position;
    if (spot.direction == DVec3{0.0}) {
        diagnostics.error(Code::E0311, span, "`position` and `target` are the same point");
        return std::nullopt;
    }
    spot.direction = unit(spot.direction);
    spot.angle = radians(values.number(kAngle));
    spot.softness = values.number(kSoftness);
    spot.falloff = values.option<scene::Falloff>(kFalloff);
    spot.radius = values.number(kRadius);
    spot.samples = values.integer(kSamples);
    return spot;
}

std::optional<scene::AreaLight> area_light(const PropertyValues& values, Span span,
                                           Diagnostics& diagnostics) {
    constexpr std::size_t kCenter = slot(kAreaLight, "center");
    constexpr std::size_t kSize = slot(kAreaLight, "size");
    constexpr std::size_t kNormal = slot(kAreaLight, "normal");
    constexpr std::size_t kCorner = slot(kAreaLight, "corner");
    constexpr std::size_t kEdgeU = slot(kAreaLight, "edge_u");
    constexpr std::size_t kEdgeV = slot(kAreaLight, "edge_v");
    constexpr std::size_t kSamples = slot(kAreaLight, "samples");
    const scene::RectangleShape shape =
        values.has(kCorner)
            ? scene::RectangleShape{values.vec3(kCorner), values.vec3(kEdgeU), values.vec3(kEdgeV)}
            : facing_rectangle(values.vec3(kCenter), values.vec2(kSize), values.vec3(kNormal));
    if (are_parallel(shape.edge_u, shape.edge_v)) {
        diagnostics.error(Code::E0304, span,
                          "this light has no area to shine from: its edges are parallel");
        return std::nullopt;
    }
    return scene::AreaLight{shape.corner, shape.edge_u, shape.edge_v, values.integer(kSamples)};
}

std::optional<scene::EnvironmentLight> environment(
    const PropertyValues& values, const std::array<Span, kMaxProperties>& value_spans, Span span,
    FileLoader& files, scene::Scene& scene) {
    constexpr std::size_t kImage = slot(kEnvironment, "image");
    constexpr std::size_t kSamples = slot(kEnvironment, "samples");
    scene::EnvironmentLight light;
    light.samples = values.integer(kSamples);
    light.texture_id = values.texture(kImage);
    if (!values.has(kImage) || !light.texture_id.is_none()) return light;
    const Value& file = values[kImage];
    const Span file_span = value_spans[kImage].is_nowhere() ? span : value_spans[kImage];
    const auto picture = files.picture(file.string(), file.source, file_span, scene);
    if (!picture) return std::nullopt;
    scene::ImageTexture image;
    image.picture_id = *picture;
    light.texture_id = add_texture({image, scene::TextureSpace::uv}, scene);
    return light;
}

std::optional<scene::LightShape> shape_of(const BlockSchema& schema, const PropertyValues& values,
                                          const std::array<Span, kMaxProperties>& value_spans,
                                          Span span, FileLoader& files, scene::Scene& scene,
                                          Diagnostics& diagnostics) {
    if (schema.kind == BlockKind::point_light) return point_light(values);
    if (schema.kind == BlockKind::spot_light) return spot_light(values, span, diagnostics);
    if (schema.kind == BlockKind::area_light) return area_light(values, span, diagnostics);
    if (schema.kind == BlockKind::environment) {
        return environment(values, value_spans, span, files, scene);
    }
    LRAY_ASSERT(schema.kind == BlockKind::directional_light);
    constexpr std::size_t kDirection = slot(kDirectionalLight, "direction");
    constexpr std::size_t kAngle = slot(kDirectionalLight, "angle");
    constexpr std::size_t kSamples = slot(kDirectionalLight, "samples");
    return scene::DirectionalLight{unit(values.vec3(kDirection)), radians(values.number(kAngle)),
                                   values.integer(kSamples)};
}

}  // namespace

std::optional<ShapeRef> build_light(const BlockSchema& schema, const PropertyValues& values,
                                    const std::array<Span, kMaxProperties>& value_spans, Span span,
                                    FileLoader& files, scene::Scene& scene,
                                    Diagnostics& diagnostics) {
    auto shape = shape_of(schema, values, value_spans, span, files, scene, diagnostics);
    if (!shape) return std::nullopt;
    const std::size_t color = find_property(schema.properties, "color");
    const std::size_t intensity = find_property(schema.properties, "intensity");
    scene.lights.push_back({std::move(*shape), values.color(color), values.number(intensity)});
    return ShapeRef{scene::NodeKind::light, static_cast<std::uint32_t>(scene.lights.size() - 1)};
}

}  // namespace lray::parser
