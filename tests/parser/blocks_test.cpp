// Blocks to scenes: textures, lights, cameras, settings, animation, records.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/angle.h"
#include "parser/blocks/schema.h"
#include "tests/parser/loaded.h"

namespace lray::test {
namespace {

/// A scene that must be right.
scene::Scene right(std::string_view text, const std::vector<Companion>& companions = {}) {
    Loaded loaded = load_text(text, parser::LoadSettings{}, companions);
    EXPECT_FALSE(loaded.has_errors()) << text << "\n" << loaded.text();
    return loaded.scene ? std::move(*loaded.scene) : scene::Scene{};
}

template <class Pattern>
Pattern pattern(const scene::Scene& scene, std::size_t i) {
    const Pattern* const found = std::get_if<Pattern>(&scene.textures.at(i).pattern);
    EXPECT_NE(found, nullptr) << i;
    return found != nullptr ? *found : Pattern{};
}

template <class Shape>
Shape light(const scene::Scene& scene, std::size_t i) {
    const Shape* const found = std::get_if<Shape>(&scene.lights.at(i).shape);
    EXPECT_NE(found, nullptr) << i;
    return found != nullptr ? *found : Shape{};
}

// Black, white, black over white, white, black: four bytes that are three pixels wide.
constexpr std::string_view kPicture(
    "P6\n2 2\n255\n\x00\x00\x00\xff\xff\xff\xff\x80\x00\xff\x80\x00", 23);

TEST(Textures, DefaultsAreThoseOfTheScene) {
    const scene::Scene scene = right(
        "let t = [checker { }, stripes { }, gradient { }, ramp { }, noise_texture { }, marble { }, "
        "wood { }, image { file: \"p.ppm\" }]",
        {{"p.ppm", kPicture}});
    ASSERT_EQ(scene.textures.size(), 8u);
    const auto checker = pattern<scene::CheckerTexture>(scene, 0);
    EXPECT_EQ(checker.a, scene::CheckerTexture{}.a);
    EXPECT_EQ(checker.b, scene::CheckerTexture{}.b);
    EXPECT_EQ(checker.size, scene::CheckerTexture{}.size);
    const auto stripes = pattern<scene::StripesTexture>(scene, 1);
    EXPECT_EQ(stripes.a, scene::StripesTexture{}.a);
    EXPECT_EQ(stripes.b, scene::StripesTexture{}.b);
    EXPECT_EQ(stripes.size, scene::StripesTexture{}.size);
    EXPECT_EQ(stripes.axis, scene::StripesTexture{}.axis);
    EXPECT_EQ(pattern<scene::GradientTexture>(scene, 2).axis, scene::GradientTexture{}.axis);
    EXPECT_EQ(pattern<scene::GradientTexture>(scene, 2).stops, scene::GradientTexture{}.stops);
    EXPECT_EQ(pattern<scene::RampTexture>(scene, 3).axis, scene::RampTexture{}.axis);
    EXPECT_EQ(pattern<scene::RampTexture>(scene, 3).stops, scene::RampTexture{}.stops);
    const auto noise = pattern<scene::NoiseTexture>(scene, 4);
    EXPECT_EQ(noise.octaves, scene::NoiseTexture{}.octaves);
    EXPECT_EQ(noise.lacunarity, scene::NoiseTexture{}.lacunarity);
    EXPECT_EQ(noise.gain, scene::NoiseTexture{}.gain);
    EXPECT_EQ(noise.seed, scene::NoiseTexture{}.seed);
    EXPECT_EQ(noise.stops, scene::NoiseTexture{}.stops);
    const auto expect_veined = [](const auto& read, const auto& standard) {
        EXPECT_EQ(read.a, standard.a);
        EXPECT_EQ(read.b, standard.b);
        EXPECT_EQ(read.size, standard.size);
        EXPECT_EQ(read.turbulence, standard.turbulence);
        EXPECT_EQ(read.octaves, standard.octaves);
        EXPECT_EQ(read.axis, standard.axis);
        EXPECT_EQ(read.seed, standard.seed);
    };
    expect_veined(pattern<scene::MarbleTexture>(scene, 5), scene::MarbleTexture{});
    expect_veined(pattern<scene::WoodTexture>(scene, 6), scene::WoodTexture{});
    const auto image = pattern<scene::ImageTexture>(scene, 7);
    EXPECT_EQ(image.wrap, scene::ImageTexture{}.wrap);
    EXPECT_EQ(image.filter, scene::ImageTexture{}.filter);
    EXPECT_EQ(image.is_srgb, scene::ImageTexture{}.is_srgb);
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_EQ(scene.textures[i].space, scene::TextureSpace::object) << i;
    }
    EXPECT_EQ(scene.textures[7].space, scene::TextureSpace::uv);
}

TEST(Textures, PropertiesArriveInTheScene) {
    const scene::Scene scene = right(
        "let t = [checker { a: red, b: [0, 0.5, 0], size: 3, space: \"world\", scale: 2 },\n"
        "  stripes { axis: \"z\", size: 0.25 },\n"
        "  ramp { axis: \"x\", stops: [[-4, #f00], [2, 0.5], [2, [0, 0, 1]]] },\n"
        "  noise_texture { octaves: 2, lacunarity: 3, gain: 0.25, seed: 9 },\n"
        "  marble { turbulence: 0, octaves: 1, axis: \"y\" },\n"
        "  wood { a: 1, b: 0, size: 2, seed: -1 },\n"
        "  image { file: \"p.ppm\", wrap: \"clamp\", filter: \"nearest\", srgb: false }]",
        {{"p.ppm", kPicture}});
    const auto checker = pattern<scene::CheckerTexture>(scene, 0);
    EXPECT_EQ(checker.a, Color(1, 0, 0));
    EXPECT_EQ(checker.b, Color(0, 0.5f, 0));
    EXPECT_EQ(checker.size, 3.0);
    EXPECT_EQ(scene.textures[0].space, scene::TextureSpace::world);
    EXPECT_EQ(scene.textures[0].space_from_texture.point({1, 2, 3}), DVec3(2, 4, 6));
    EXPECT_EQ(scene.textures[0].texture_from_space.point({2, 4, 6}), DVec3(1, 2, 3));
    EXPECT_EQ(pattern<scene::StripesTexture>(scene, 1).axis, scene::Axis::z);
    EXPECT_EQ(pattern<scene::StripesTexture>(scene, 1).size, 0.25);
    const std::vector<scene::ColorStop> stops = {
        {-4, Color(1, 0, 0)}, {2, Color(0.5f)}, {2, Color(0, 0, 1)}};
    EXPECT_EQ(pattern<scene::RampTexture>(scene, 2).stops, stops);
    EXPECT_EQ(pattern<scene::RampTexture>(scene, 2).axis, scene::Axis::x);
    const auto noise = pattern<scene::NoiseTexture>(scene, 3);
    EXPECT_EQ(noise.octaves, 2u);
    EXPECT_EQ(noise.lacunarity, 3.0);
    EXPECT_EQ(noise.gain, 0.25);
    EXPECT_EQ(noise.seed, 9.0);
    EXPECT_EQ(pattern<scene::MarbleTexture>(scene, 4).turbulence, 0.0);
    EXPECT_EQ(pattern<scene::MarbleTexture>(scene, 4).axis, scene::Axis::y);
    EXPECT_EQ(pattern<scene::WoodTexture>(scene, 5).seed, -1.0);
    const auto image = pattern<scene::ImageTexture>(scene, 6);
    EXPECT_EQ(image.wrap, scene::ImageWrap::clamp);
    EXPECT_EQ(image.filter, scene::ImageFilter::nearest);
    EXPECT_FALSE(image.is_srgb);
}

TEST(Textures, AveragesAreMeansAndIntegrals) {
    const scene::Scene scene = right(
        "let t = [checker { a: 1, b: 0.5 }, gradient { stops: [[0.5, 0], [1, 1]] },\n"
        "  ramp { stops: [[-4, 0], [0, 0], [0, 1], [12, 1]] }, ramp { stops: [[1, 0], [1, 1]] },\n"
        "  image { file: \"p.ppm\" }, image { file: \"p.ppm\", srgb: false }]",
        {{"p.ppm", kPicture}});
    EXPECT_EQ(scene.textures[0].average, Color(0.75f));
    EXPECT_EQ(scene.textures[1].average, Color(0.25f));
    EXPECT_EQ(scene.textures[2].average, Color(0.75f));
    EXPECT_EQ(scene.textures[3].average, Color(0.5f));
    constexpr double kLinear80 = 0.21586050011389926;  // of the sRGB code 0x80
    const Color srgb = scene.textures[4].average;
    EXPECT_NEAR(static_cast<double>(srgb.x), 0.75, 1e-7);
    EXPECT_NEAR(static_cast<double>(srgb.y), (1.0 + 2.0 * kLinear80) / 4.0, 1e-7);
    EXPECT_NEAR(static_cast<double>(srgb.z), 0.25, 1e-7);
    EXPECT_NEAR(static_cast<double>(scene.textures[5].average.y), (1.0 + 256.0 / 255.0) / 4.0,
                1e-7);
    EXPECT_EQ(scene.pictures.size(), 1u);  // read once
    EXPECT_EQ(std::get<image::CodedImage>(scene.pictures[0].pixels).at(0, 1),
              (std::array<std::uint8_t, 3>{0xff, 0x80, 0}));
}

TEST(Textures, ACopyKeepsWhatItDoesNotSetAndStepsAddUp) {
    const scene::Scene scene = right(
        "let oak = wood { size: 2, translate: [1, 0, 0] }\n"
        "let turned = oak { seed: 4, translate: [0, 2, 0] }");
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_EQ(pattern<scene::WoodTexture>(scene, 1).size, 2.0);
    EXPECT_EQ(pattern<scene::WoodTexture>(scene, 1).seed, 4.0);
    EXPECT_EQ(scene.textures[1].space_from_texture.offset(), DVec3(1, 2, 0));
}

TEST(Textures, TheirNamesMayBeTakenAndTheirPropertiesRead) {
    const scene::Scene scene = right(
        "let wood = image { file: \"p.ppm\", scale: 0.25 }\n"
        "let c = checker { b: red }\n"
        "sphere { radius: c.size * 3, material { diffuse: wood, fresnel: c.b } }",
        {{"p.ppm", kPicture}});
    EXPECT_EQ(scene.spheres[0].radius, 3.0);
    EXPECT_EQ(scene.materials[0].diffuse.texture_id, scene::TextureId(0u));
    EXPECT_EQ(scene.materials[0].diffuse.constant, scene.textures[0].average);
    EXPECT_EQ(scene.materials[0].fresnel, Color(1, 0, 0));
}

TEST(Materials, EveryCoefficientTakesATexture) {
    const scene::Scene scene = right(
        "let t = checker { a: 1, b: 0.5 }\n"
        "let m = material { ambient: t, diffuse: t, specular: t, shininess: t, reflect: t, "
        "transmit: t, absorption: t, emission: t, opacity: t, bump: t, bump_height: -0.25, "
        "bump_unit: \"uv\", normal_map: t }\n"
        "let n = material { model: \"ward\", roughness: t, fresnel: t }\n"
        "let o = m { diffuse: 0.25 }");
    const scene::TextureId id(0u);
    const scene::Material& m = scene.materials[0];
    EXPECT_EQ(m.ambient, scene::Coefficient(Color(0.75f), id));
    for (const scene::Coefficient& coefficient :
         {m.diffuse, *m.specular, m.reflect, m.transmit, m.absorption, m.emission}) {
        EXPECT_EQ(coefficient, scene::Coefficient(Color(0.75f), id));
    }
    EXPECT_EQ(m.shininess, scene::ScalarCoefficient(0.75f, id));
    EXPECT_EQ(m.opacity, scene::ScalarCoefficient(0.75f, id));
    EXPECT_EQ(m.bump_id, id);
    EXPECT_EQ(m.bump_height, -0.25);
    EXPECT_EQ(m.bump_unit, scene::BumpUnit::uv);
    EXPECT_EQ(scene.materials[1].bump_height, 1.0);
    EXPECT_EQ(scene.materials[1].bump_unit, scene::BumpUnit::metre);
    EXPECT_EQ(m.normal_map_id, id);
    EXPECT_EQ(scene.materials[1].roughness, scene::PlanarCoefficient(Vec2(0.75f), id));
    EXPECT_EQ(scene.materials[1].fresnel.texture_id, id);
    EXPECT_EQ(scene.materials[2].diffuse, Color(0.25f));
    EXPECT_EQ(scene.materials[2].specular, m.specular);
}

TEST(Materials, TexturesAreNotCountedAsTooMuchLight) {
    const Loaded loaded = load_text(
        "camera { }\nlet c = checker { a: 1, b: 1 }\n"
        "sphere { material { diffuse: c, reflect: 0.9 } }");
    EXPECT_EQ(loaded.codes(), "");
}

TEST(Lights, DefaultsAreThoseOfTheScene) {
    const scene::Scene scene = right(
        "point_light { }\nspot_light { }\ndirectional_light { }\narea_light { }\nenvironment { }");
    ASSERT_EQ(scene.lights.size(), 5u);
    const auto point = light<scene::PointLight>(scene, 0);
    EXPECT_EQ(point.position, scene::PointLight{}.position);
    EXPECT_EQ(point.falloff, scene::PointLight{}.falloff);
    EXPECT_EQ(point.radius, scene::PointLight{}.radius);
    EXPECT_EQ(point.samples, scene::PointLight{}.samples);
    const auto spot = light<scene::SpotLight>(scene, 1);
    EXPECT_EQ(spot.direction, scene::SpotLight{}.direction);
    EXPECT_EQ(spot.angle, scene::SpotLight{}.angle);
    EXPECT_EQ(spot.softness, scene::SpotLight{}.softness);
    EXPECT_EQ(spot.samples, scene::SpotLight{}.samples);
    EXPECT_EQ(light<scene::DirectionalLight>(scene, 2).direction,
              scene::DirectionalLight{}.direction);
    EXPECT_EQ(light<scene::DirectionalLight>(scene, 2).angle, scene::DirectionalLight{}.angle);
    const auto area = light<scene::AreaLight>(scene, 3);
    EXPECT_EQ(area.corner, scene::AreaLight{}.corner);
    EXPECT_EQ(area.edge_u, scene::AreaLight{}.edge_u);
    EXPECT_EQ(area.edge_v, scene::AreaLight{}.edge_v);
    EXPECT_EQ(area.samples, scene::AreaLight{}.samples);
    EXPECT_EQ(light<scene::DirectionalLight>(scene, 2).samples, scene::DirectionalLight{}.samples);
    EXPECT_TRUE(light<scene::EnvironmentLight>(scene, 4).texture_id.is_none());
    EXPECT_EQ(light<scene::EnvironmentLight>(scene, 4).samples, scene::EnvironmentLight{}.samples);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(scene.lights[i].color, scene::Light{}.color) << i;
        EXPECT_EQ(scene.lights[i].intensity, i == 2 || i == 4 ? 1.0 : scene::Light{}.intensity);
    }
}

TEST(Lights, PropertiesArriveInTheScene) {
    const scene::Scene scene = right(
        "point_light \"lamp\" { position: [1, 2, 3], color: red, intensity: 7, falloff: \"none\", "
        "radius: 0.5, samples: 4, casts_shadow: false }\n"
        "spot_light { position: [0, 4, 0], target: [0, 1, 0], angle: 90, softness: 1, "
        "falloff: \"linear\" }\n"
        "directional_light { direction: [0, -2, 0], angle: 0.5, samples: 3 }\n"
        "area_light { corner: [1, 0, 0], edge_u: [0, 0, 2], edge_v: [3, 0, 0], samples: 9 }\n"
        "environment { image: \"p.ppm\", intensity: 0.5, samples: 64 }",
        {{"p.ppm", kPicture}});
    const auto point = light<scene::PointLight>(scene, 0);
    EXPECT_EQ(point.position, DVec3(1, 2, 3));
    EXPECT_EQ(point.falloff, scene::Falloff::none);
    EXPECT_EQ(point.radius, 0.5);
    EXPECT_EQ(point.samples, 4u);
    EXPECT_EQ(scene.lights[0].color, Color(1, 0, 0));
    EXPECT_EQ(scene.lights[0].intensity, 7.0);
    const scene::Node& node = scene.node(scene.groups[scene.node(scene.root).index].children[0]);
    EXPECT_EQ(node.kind, scene::NodeKind::light);
    EXPECT_FALSE(node.casts_shadow);
    EXPECT_EQ(scene.labels[node.label_id.index()], "lamp");
    const auto spot = light<scene::SpotLight>(scene, 1);
    EXPECT_EQ(spot.direction, DVec3(0, -1, 0));
    EXPECT_EQ(spot.angle, radians(90.0));
    EXPECT_EQ(spot.softness, 1.0);
    EXPECT_EQ(spot.falloff, scene::Falloff::linear);
    EXPECT_EQ(light<scene::DirectionalLight>(scene, 2).direction, DVec3(0, -1, 0));
    EXPECT_EQ(light<scene::DirectionalLight>(scene, 2).angle, radians(0.5));
    EXPECT_EQ(light<scene::DirectionalLight>(scene, 2).samples, 3u);
    EXPECT_EQ(light<scene::AreaLight>(scene, 3).edge_u, DVec3(0, 0, 2));
    EXPECT_EQ(light<scene::AreaLight>(scene, 3).samples, 9u);
    const auto environment = light<scene::EnvironmentLight>(scene, 4);
    ASSERT_EQ(environment.texture_id, scene::TextureId(0u));
    EXPECT_EQ(scene.textures[0].space, scene::TextureSpace::uv);
    EXPECT_EQ(environment.samples, 64u);
    EXPECT_EQ(scene.lights[4].intensity, 0.5);
}

TEST(Views, CameraAndRenderTakeEverySetting) {
    const scene::Scene scene = right(
        "camera { projection: \"panorama\", aperture: 0.1, focus: 7 }\n"
        "camera { focus: [3, 0, 1] }\ncamera { }\n"
        "render { samples: 16, max_depth: 3, ambient: 0.1, exposure: -1, tonemap: \"aces\", "
        "gamma: \"linear\", seed: 5, integrator: \"path\", sampler: \"random\", "
        "transparent_shadows: true }\nsphere { }");
    EXPECT_EQ(scene.cameras[0].projection, scene::Projection::panorama);
    EXPECT_EQ(scene.cameras[0].aperture, 0.1);
    EXPECT_EQ(scene.cameras[0].focus, 7.0);
    EXPECT_EQ(scene.cameras[1].focus, 4.0);
    EXPECT_EQ(scene.cameras[2].focus, std::nullopt);
    EXPECT_EQ(scene.render.samples, 16u);
    EXPECT_EQ(scene.render.max_depth, 3u);
    EXPECT_EQ(scene.render.ambient, Color(0.1f));
    EXPECT_EQ(scene.render.exposure, -1.0);
    EXPECT_EQ(scene.render.tonemap, scene::ToneMap::aces);
    EXPECT_EQ(scene.render.gamma, scene::Gamma::linear);
    EXPECT_EQ(scene.render.seed, 5u);
    EXPECT_EQ(scene.render.integrator, scene::Integrator::path);
    EXPECT_EQ(scene.render.sampler, scene::SamplerKind::random);
    EXPECT_TRUE(scene.render.transparent_shadows);
}

TEST(Views, DefaultsOfRenderAreThoseOfTheScene) {
    const scene::RenderSettings read = right("render { }\nsphere { }").render;
    const scene::RenderSettings standard;
    EXPECT_EQ(read.resolution, standard.resolution);
    EXPECT_EQ(read.samples, standard.samples);
    EXPECT_EQ(read.max_depth, standard.max_depth);
    EXPECT_EQ(read.background, standard.background);
    EXPECT_EQ(read.ambient, standard.ambient);
    EXPECT_EQ(read.exposure, standard.exposure);
    EXPECT_EQ(read.tonemap, standard.tonemap);
    EXPECT_EQ(read.gamma, standard.gamma);
    EXPECT_EQ(read.seed, standard.seed);
    EXPECT_EQ(read.integrator, standard.integrator);
    EXPECT_EQ(read.sampler, standard.sampler);
    EXPECT_EQ(read.transparent_shadows, standard.transparent_shadows);
}

TEST(Views, AnAnimationIsReadAlsoFromAnInclude) {
    const scene::Scene scene = right("include \"film.lrs\"\nsphere { }",
                                     {{"film.lrs", "animation { frames: 96, start: -1.5 }"}});
    ASSERT_TRUE(scene.animation);
    EXPECT_EQ(scene.animation->frames, 96u);
    EXPECT_EQ(scene.animation->fps, scene::Animation{}.fps);
    EXPECT_EQ(scene.animation->start, -1.5);
    EXPECT_FALSE(right("sphere { }").animation);
}

TEST(Schemas, DefaultsInWordsAndInNumbersAgree) {
    const auto check = [](std::string_view block, const parser::PropertySchema& property) {
        const std::string_view text = property.default_text;
        if (text.empty() || text.front() == '"' || property.type == parser::PropertyType::stops) {
            return;
        }
        std::vector<double> numbers;
        if (text == "true" || text == "false") {
            numbers.push_back(text == "true" ? 1.0 : 0.0);
        } else if (text.front() == '#') {
            EXPECT_EQ(text, "#000000") << block << "." << property.name;
            numbers.push_back(0.0);
        } else {
            std::string digits(text.front() == '[' ? text.substr(1, text.size() - 2) : text);
            for (std::size_t at = 0; at < digits.size();) {
                std::size_t used = 0;
                numbers.push_back(std::stod(digits.substr(at), &used));
                at += used + 1;
            }
        }
        ASSERT_LE(numbers.size(), 3u);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const bool is_step = parser::find_property(parser::common_properties(), property.name) <
                                 parser::kCommonPropertyCount;
            if (is_step && numbers[i] == 1.0 && property.name == "scale") continue;
            EXPECT_EQ(property.default_value[i], numbers[i]) << block << "." << property.name;
        }
    };
    for (const parser::BlockSchema& block : parser::block_schemas()) {
        for (const parser::PropertySchema& property : block.properties) check(block.name, property);
    }
}

}  // namespace
}  // namespace lray::test
