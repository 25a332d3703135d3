#include "shade/textures/texture_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/shade/textures/worlds.h"

namespace lray::shade {
namespace {

using scene::TexturePattern;
using scene::TextureSpace;

const scene::TextureId kFirst(std::size_t{0});

std::vector<TexturePattern> all_patterns() {
    scene::GradientTexture gradient;
    gradient.stops = {{0.1, Color{1.0f, 0.0f, 0.5f}}, {0.4, Color{0.0f, 1.0f, 0.25f}}};
    scene::NoiseTexture noise;
    noise.stops = {{0.0, Color{0.0f}}, {0.55, Color{0.1f}}, {0.7, Color{1.0f, 0.5f, 0.25f}}};
    return {scene::ImageTexture{scene::PictureId(std::size_t{0})},
            scene::CheckerTexture{},
            scene::StripesTexture{},
            gradient,
            scene::RampTexture{},
            noise,
            scene::MarbleTexture{},
            scene::WoodTexture{}};
}

std::vector<scene::Picture> one_picture() {
    std::vector<scene::Picture> pictures;
    pictures.push_back(test::picture_of(test::random_codes(19, 7, 17)));
    return pictures;
}

TEST(TextureSet, MeanOfManyLookupsIsTheAverage) {
    const std::vector<scene::Picture> pictures = one_picture();
    for (const TexturePattern& pattern : all_patterns()) {
        const scene::World world = test::world_with(pattern, TextureSpace::object, {}, pictures);
        const TextureSet textures(world);
        // A ramp has its average between its ends alone.
        const bool is_ramp = std::holds_alternative<scene::RampTexture>(pattern);
        const double size = is_ramp ? 0.5 : 100.0;
        test::Random random(18);
        DVec3 sum{0.0};
        constexpr int kCount = 100000;
        for (int i = 0; i < kCount; ++i) {
            const DVec3 p = test::point_in_box(random, size) + DVec3{0.5};
            sum += DVec3{textures.color(kFirst, test::point_at(p))};
        }
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(sum[channel] / kCount,
                        static_cast<double>(world.textures[0].average[channel]), 0.01)
                << "pattern " << pattern.index();
        }
    }
}

TEST(TextureSet, EachSpaceIsLookedUpInItsOwnPointWithItsOwnWidth) {
    TexturePoint point;
    point.uv = {0.25, 0.0};
    point.object = {0.5, 0.0, 0.0};
    point.world = {0.75, 0.0, 0.0};
    const auto red = [&](TextureSpace space) {
        const scene::World world = test::world_with(scene::RampTexture{scene::Axis::x}, space);
        return TextureSet(world).color(kFirst, point).r;
    };
    EXPECT_EQ(red(TextureSpace::uv), 0.25f);
    EXPECT_EQ(red(TextureSpace::object), 0.5f);
    EXPECT_EQ(red(TextureSpace::world), 0.75f);
    point.uv_width = point.object_width = point.world_width = 1.0;
    point.object_normal = {0.0, 1.0, 0.0};
    point.world_normal = {1.0, 0.0, 0.0};  // the ramp runs through the surface, not along it
    EXPECT_EQ(red(TextureSpace::uv), 0.28125f);
    EXPECT_EQ(red(TextureSpace::object), 0.5f);
    EXPECT_EQ(red(TextureSpace::world), 0.75f);
    point.uv_width = 0.0;
    point.object_width = 2.0;
    EXPECT_EQ(red(TextureSpace::uv), 0.25f);
    EXPECT_NE(red(TextureSpace::object), 0.25f);
}

TEST(TextureSet, ColoursOfVerticesAreThoseOfThePoint) {
    const scene::World world =
        test::world_with(scene::VertexColorsTexture{}, TextureSpace::vertex_colors);
    const TextureSet textures(world);
    TexturePoint point;
    EXPECT_EQ(textures.color(kFirst, point), Color(1.0f));
    point.vertex_color = {0.25, 0.5, 0.75};
    point.uv_width = point.object_width = point.world_width = 1e9;
    EXPECT_EQ(textures.color(kFirst, point), Color(0.25f, 0.5f, 0.75f));
}

TEST(TextureSet, StepsOfATextureMoveItsPatternAndItsWidth) {
    // Twice as large along x and moved by 3: the point 3 + 2 t shows what t does.
    const Transform steps =
        Transform::scaling({2.0, 1.0, 1.0}).then(Transform::translation({3.0, 0.0, 0.0}));
    const scene::World world =
        test::world_with(scene::RampTexture{scene::Axis::x}, TextureSpace::object, steps);
    const TextureSet textures(world);
    EXPECT_EQ(textures.color(kFirst, test::point_at({3.5, 0.0, 0.0})).r, 0.25f);
    EXPECT_EQ(textures.color(kFirst, test::point_at({5.0, 0.0, 0.0})).r, 1.0f);
    // Of a width of 1 half a unit is averaged: from 0 to 1/4 the ramp has 1/8, before it nothing.
    const DVec3 up{0.0, 1.0, 0.0};
    EXPECT_EQ(textures.color(kFirst, test::point_at({3.0, 0.0, 0.0}, 1.0, up)).r, 0.0625f);
}

TEST(TextureSet, NumberIsTheMeanOfTheChannels) {
    const scene::World world =
        test::world_with(scene::CheckerTexture{Color{0.75f, 0.5f, 0.25f}, Color{0.0f}, 1.0});
    EXPECT_EQ(TextureSet(world).number(kFirst, test::point_at(DVec3{0.5})), 0.5f);
}

TEST(TextureSet, HostilePointsShowAFiniteColour) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> numbers{0.0,   -0.0,   0.5,   -1e-320, 1e10,      -1e19,     1e60,
                                      1e300, -1e300, 1e308, kNan,    kInfinite, -kInfinite};
    const std::vector<scene::Picture> pictures = one_picture();
    std::vector<TexturePattern> patterns = all_patterns();
    for (const auto wrap : {scene::ImageWrap::mirror, scene::ImageWrap::clamp}) {
        for (const auto filter : {scene::ImageFilter::nearest, scene::ImageFilter::bilinear}) {
            patterns.push_back(scene::ImageTexture{scene::PictureId(std::size_t{0}), wrap, filter});
        }
    }
    scene::WoodTexture tiny;
    tiny.size = 1e-300;
    tiny.turbulence = 1e300;
    patterns.push_back(tiny);
    scene::CheckerTexture huge;
    huge.size = 1e-310;  // of which the inverse is infinite
    patterns.push_back(huge);
    for (const TexturePattern& pattern : patterns) {
        for (const TextureSpace space : {TextureSpace::uv, TextureSpace::object}) {
            const scene::World world = test::world_with(pattern, space, {}, pictures);
            const TextureSet textures(world);
            for (const double x : numbers) {
                for (const double y : numbers) {
                    for (const double width : numbers) {
                        const DVec3 normal = y > 0.0 ? DVec3{0.6, 0.8, 0.0} : DVec3{0.0};
                        const Color color =
                            textures.color(kFirst, test::point_at({x, y, x}, width, normal));
                        ASSERT_TRUE(std::isfinite(color.r + color.g + color.b) && color.r >= 0.0f &&
                                    color.r <= 1.0f)
                            << pattern.index() << ' ' << x << ' ' << y << ' ' << width;
                    }
                }
            }
        }
    }
}

TEST(TextureSet, PictureUsedAsDataAndAsColoursHasBothMeans) {
    const std::vector<scene::Picture> pictures = one_picture();
    scene::World world = test::world_with(scene::ImageTexture{scene::PictureId(std::size_t{0})},
                                          TextureSpace::uv, {}, pictures);
    world.textures.push_back(world.textures[0]);
    std::get<scene::ImageTexture>(world.textures[1].pattern).is_srgb = false;
    const TextureSet textures(world);
    const TexturePoint far = test::point_at({0.3, 0.4, 0.0}, 50.0);
    const Color colors = textures.color(kFirst, far);
    const Color data = textures.color(scene::TextureId(std::size_t{1}), far);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(colors[i], pictures[0].srgb_mean[i], 0.004f);
        EXPECT_NEAR(data[i], pictures[0].linear_mean[i], 0.004f);
    }
}

}  // namespace
}  // namespace lray::shade
