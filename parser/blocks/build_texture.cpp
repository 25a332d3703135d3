#include "parser/blocks/build_texture.h"

#include <utility>

#include "parser/blocks/schemas.h"
#include "parser/blocks/stops.h"
#include "scene/average_color.h"

namespace lray::parser {

namespace {

using namespace schemas;
using scene::Axis;

static_assert(kSpaces[static_cast<std::size_t>(scene::TextureSpace::uv)] == "uv");
static_assert(kSpaces[static_cast<std::size_t>(scene::TextureSpace::object)] == "object");
static_assert(kSpaces[static_cast<std::size_t>(scene::TextureSpace::world)] == "world");
static_assert(kAxes[static_cast<std::size_t>(Axis::x)] == "x");
static_assert(kAxes[static_cast<std::size_t>(Axis::z)] == "z");
static_assert(kWraps[static_cast<std::size_t>(scene::ImageWrap::repeat)] == "repeat");
static_assert(kWraps[static_cast<std::size_t>(scene::ImageWrap::mirror)] == "mirror");
static_assert(kWraps[static_cast<std::size_t>(scene::ImageWrap::clamp)] == "clamp");
static_assert(kFilters[static_cast<std::size_t>(scene::ImageFilter::nearest)] == "nearest");
static_assert(kFilters[static_cast<std::size_t>(scene::ImageFilter::bilinear)] == "bilinear");

std::optional<scene::TexturePattern> image(const PropertyValues& values,
                                           const std::array<Span, kMaxProperties>& value_spans,
                                           Span span, FileLoader& files, scene::Scene& scene) {
    constexpr std::size_t kFile = slot(kImage, "file");
    constexpr std::size_t kWrap = slot(kImage, "wrap");
    constexpr std::size_t kFilter = slot(kImage, "filter");
    constexpr std::size_t kSrgb = slot(kImage, "srgb");
    const Value& file = values[kFile];
    const Span file_span = value_spans[kFile].is_nowhere() ? span : value_spans[kFile];
    const auto picture = files.picture(file.string(), file.source, file_span, scene);
    if (!picture) return std::nullopt;
    return scene::ImageTexture{*picture, values.option<scene::ImageWrap>(kWrap),
                               values.option<scene::ImageFilter>(kFilter), values.boolean(kSrgb)};
}

scene::TexturePattern checker(const PropertyValues& values) {
    constexpr std::size_t kA = slot(kChecker, "a");
    constexpr std::size_t kB = slot(kChecker, "b");
    constexpr std::size_t kSize = slot(kChecker, "size");
    return scene::CheckerTexture{values.color(kA), values.color(kB), values.number(kSize)};
}

scene::TexturePattern stripes(const PropertyValues& values) {
    constexpr std::size_t kA = slot(kStripes, "a");
    constexpr std::size_t kB = slot(kStripes, "b");
    constexpr std::size_t kSize = slot(kStripes, "size");
    constexpr std::size_t kAxis = slot(kStripes, "axis");
    return scene::StripesTexture{values.color(kA), values.color(kB), values.number(kSize),
                                 values.option<Axis>(kAxis)};
}

// Of a texture without stops of its own those of the scene's default stay.
void set_stops(std::vector<scene::ColorStop>& stops, const PropertyValues& values,
               std::size_t slot) {
    if (values.has(slot)) stops = read_stops(values[slot]);
}

scene::TexturePattern gradient(const PropertyValues& values) {
    scene::GradientTexture texture;
    texture.axis = values.option<Axis>(slot(kGradient, "axis"));
    set_stops(texture.stops, values, slot(kGradient, "stops"));
    return texture;
}

scene::TexturePattern ramp(const PropertyValues& values) {
    scene::RampTexture texture;
    texture.axis = values.option<Axis>(slot(kRamp, "axis"));
    set_stops(texture.stops, values, slot(kRamp, "stops"));
    return texture;
}

scene::TexturePattern noise_texture(const PropertyValues& values) {
    scene::NoiseTexture texture;
    texture.octaves = values.integer(slot(kNoiseTexture, "octaves"));
    texture.lacunarity = values.number(slot(kNoiseTexture, "lacunarity"));
    texture.gain = values.number(slot(kNoiseTexture, "gain"));
    texture.seed = values.number(slot(kNoiseTexture, "seed"));
    set_stops(texture.stops, values, slot(kNoiseTexture, "stops"));
    return texture;
}

/// Marble and wood have the same properties.
template <class Veined>
scene::TexturePattern veined(const PropertyValues& values,
                             std::span<const PropertySchema> properties) {
    Veined texture;
    texture.a = values.color(find_property(properties, "a"));
    texture.b = values.color(find_property(properties, "b"));
    texture.size = values.number(find_property(properties, "size"));
    texture.turbulence = values.number(find_property(properties, "turbulence"));
    texture.octaves = values.integer(find_property(properties, "octaves"));
    texture.axis = values.option<Axis>(find_property(properties, "axis"));
    texture.seed = values.number(find_property(properties, "seed"));
    return texture;
}

}  // namespace

std::optional<scene::TextureId> build_texture(const BlockSchema& schema,
                                              const PropertyValues& values,
                                              const std::array<Span, kMaxProperties>& value_spans,
                                              const Transform& space_from_texture, Span span,
                                              FileLoader& files, scene::Scene& scene) {
    scene::Texture texture;
    if (schema.kind == BlockKind::image) {
        auto pattern = image(values, value_spans, span, files, scene);
        if (!pattern) return std::nullopt;
        texture.pattern = std::move(*pattern);
    } else if (schema.kind == BlockKind::checker) {
        texture.pattern = checker(values);
    } else if (schema.kind == BlockKind::stripes) {
        texture.pattern = stripes(values);
    } else if (schema.kind == BlockKind::gradient) {
        texture.pattern = gradient(values);
    } else if (schema.kind == BlockKind::ramp) {
        texture.pattern = ramp(values);
    } else if (schema.kind == BlockKind::noise_texture) {
        texture.pattern = noise_texture(values);
    } else if (schema.kind == BlockKind::marble) {
        texture.pattern = veined<scene::MarbleTexture>(values, kMarble);
    } else if (schema.kind == BlockKind::wood) {
        texture.pattern = veined<scene::WoodTexture>(values, kWood);
    } else {
        LRAY_ASSERT(schema.kind == BlockKind::vertex_colors);
        return add_texture(vertex_colors(), scene);
    }
    texture.space = values.option<scene::TextureSpace>(find_property(schema.properties, "space"));
    const std::optional<Transform> inverse = space_from_texture.inverse();
    LRAY_ASSERT(inverse);
    texture.space_from_texture = space_from_texture;
    texture.texture_from_space = *inverse;
    return add_texture(std::move(texture), scene);
}

scene::Texture vertex_colors() {
    scene::Texture texture;
    texture.pattern = scene::VertexColorsTexture{};
    texture.space = scene::TextureSpace::vertex_colors;
    return texture;
}

scene::TextureId add_texture(scene::Texture texture, scene::Scene& scene) {
    const bool shows_vertex_colors = texture.space == scene::TextureSpace::vertex_colors;
    scene.shows_vertex_colors = scene.shows_vertex_colors || shows_vertex_colors;
    texture.average = average_color(texture.pattern, scene.pictures);
    const scene::TextureId id(scene.textures.size());
    scene.textures.push_back(std::move(texture));
    return id;
}

std::uint64_t texture_size(const PropertyValues& values, const BlockSchema& schema) {
    const std::size_t stops = find_property(schema.properties, "stops");
    const bool has_stops = stops < schema.properties.size() && values.has(stops);
    const std::uint64_t count = has_stops ? values[stops].count : 2;
    return sizeof(scene::Texture) + count * sizeof(scene::ColorStop);
}

}  // namespace lray::parser
