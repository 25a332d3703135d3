// Light from everywhere: of one colour, and of textures in every space.
#include "shade/lights/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/shade/chi_square.h"
#include "tests/shade/lights/light_means.h"
#include "tests/shade/textures/worlds.h"

namespace lray::shade {
namespace {

constexpr double kPi = std::numbers::pi;

/// A dark picture with one bright pixel and one that is half as bright.
image::CodedImage spots(std::uint32_t width, std::uint32_t height) {
    image::CodedImage picture{width, height, {}};
    picture.rgb.assign(std::size_t{3} * width * height, 10);
    for (int c = 0; c < 3; ++c) {
        picture.rgb[3 * (std::size_t{height / 4} * width + width / 3) + c] = 255;
        picture.rgb[3 * (std::size_t{height / 2} * width + 2 * width / 3) + c] = 128;
    }
    return picture;
}

/// A world with a texture, what looks it up, and an environment of it.
struct Sky {
    explicit Sky(scene::TexturePattern pattern, scene::TextureSpace space,
                 const DMat3& light_from_world = DMat3{1.0},
                 std::span<const scene::Picture> pictures = {})
        : world(test::world_with(std::move(pattern), space, {}, pictures)),
          textures(world),
          environment(world, textures,
                      scene::EnvironmentLight{scene::TextureId(0), light_from_world, 16},
                      Color{1.0f, 0.5f, 2.0f}, 2.0, true) {}

    scene::World world;
    TextureSet textures;
    Environment environment;
};

scene::RampTexture ramp_along(scene::Axis axis) {
    return {axis, {{-1.0, Color{0.0f}}, {1.0, Color{1.0f}}}};
}

DMat3 turned_and_stretched() {
    DMat3 m{1.0};
    m[0] = {0.8, 0.6, 0.0};
    m[1] = {-1.2, 1.6, 0.3};
    m[2] = {0.1, 0.0, -0.7};
    return m;
}

void expect_right_mean(const Environment& environment, double tolerance) {
    test::Random random(1);
    for (int i = 0; i < 4; ++i) {
        const DVec3 normal = test::sphere_direction(random);
        double exact = 0.0;
        constexpr int kZ = 600;
        constexpr int kTurn = 1200;
        for (int k = 0; k < kZ * kTurn; ++k) {
            const double z = 2.0 * (k / kTurn + 0.5) / kZ - 1.0;
            const double angle = 2.0 * kPi * (k % kTurn + 0.5) / kTurn;
            const double sine = std::sqrt(1.0 - z * z);
            const DVec3 d{sine * std::sin(angle), z, -sine * std::cos(angle)};
            const double cosine = dot(d, normal);
            if (cosine > 0.0) exact += double{environment.radiance(Vec3(d)).g} * cosine;
        }
        exact *= 4.0 / (kZ * kTurn);
        const auto sampler = [&](DVec2 u) { return environment.sample(Vec3(normal), u); };
        EXPECT_NEAR(test::irradiance(sampler, normal, 600) / exact, 1.0, tolerance) << i;
    }
}

void expect_right_density(const Environment& environment, int points_per_side) {
    const Vec3 normal{0.0f, 1.0f, 0.0f};
    const auto sampler = [&](double, DVec2 u) -> std::optional<Vec3> {
        const auto sample = environment.sample(normal, u);
        EXPECT_TRUE(sample && sample->pdf > 0.0f);
        EXPECT_NEAR(glm::length(sample->wi), 1.0f, 3e-7f);
        return sample->wi;
    };
    const auto density = [&](Vec3 wi) { return double{environment.pdf(normal, wi)}; };
    EXPECT_GT(test::chi_square_probability(sampler, density, 2, {-1.0, 1.0, points_per_side}),
              1e-3);
}

TEST(Environment, OfOneColourEachSampleIsExactButForShadows) {
    const scene::World world;
    const TextureSet textures(world);
    const Environment environment(world, textures, {}, Color{0.25f, 0.5f, 1.0f}, 2.0, true);
    test::Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 normal(test::sphere_direction(random));
        const double u = random.uniform();
        const auto sample = environment.sample(normal, {u, random.uniform()});
        ASSERT_TRUE(sample);
        const double cosine = dot(DVec3(sample->wi), DVec3(normal));
        EXPECT_NEAR(double{sample->irradiance.g} * cosine, 1.0, 1e-5 + 2e-7 / cosine);
        EXPECT_NEAR(double{sample->pdf}, cosine / kPi, 1e-6);
        EXPECT_NEAR(environment.pdf(normal, sample->wi), sample->pdf, 1e-6f);
    }
    EXPECT_EQ(environment.radiance({0.0f, 1.0f, 0.0f}), (Color{0.5f, 1.0f, 2.0f}));
    EXPECT_EQ(environment.mean_radiance(), (Color{0.5f, 1.0f, 2.0f}));
    EXPECT_EQ(environment.pdf({0.0f, 1.0f, 0.0f}, {0.0f, -1.0f, 0.0f}), 0.0f);
}

TEST(Environment, OfOneColourDirectionsFollowTheCosine) {
    const scene::World world;
    const TextureSet textures(world);
    expect_right_density(Environment(world, textures, {}, Color{1.0f}, 1.0, true), 32);
}

TEST(Environment, PictureIsWrappedAroundTheYAxisItsMiddleTowardsMinusZ) {
    const scene::GradientTexture around{scene::Axis::x,
                                        {{0.0, Color{0.0f}}, {1.0, Color{1.0f, 2.0f, 0.5f}}}};
    const Sky sky(around, scene::TextureSpace::uv);
    const auto u_of = [&](Vec3 d) { return 0.5f * sky.environment.radiance(d).r; };
    EXPECT_NEAR(u_of({0.0f, 0.0f, -1.0f}), 0.5f, 1e-6f);
    EXPECT_NEAR(u_of({1.0f, 0.0f, 0.0f}), 0.75f, 1e-6f);
    EXPECT_NEAR(u_of({-1.0f, 0.0f, 0.0f}), 0.25f, 1e-6f);
    EXPECT_NEAR(u_of(glm::normalize(Vec3{1.0f, 5.0f, -1.0f})), 0.625f, 1e-6f);
    scene::GradientTexture up = around;
    up.axis = scene::Axis::y;
    const Sky rising(up, scene::TextureSpace::uv);
    const auto v_of = [&](Vec3 d) { return 0.5f * rising.environment.radiance(d).r; };
    EXPECT_NEAR(v_of({0.0f, -1.0f, 0.0f}), 0.0f, 2e-3f);
    EXPECT_NEAR(v_of({1.0f, 0.0f, 0.0f}), 0.5f, 1e-6f);
    EXPECT_NEAR(v_of(glm::normalize(Vec3{0.0f, 1.0f, 1.0f})), 0.75f, 1e-6f);
    EXPECT_NEAR(v_of({0.0f, 1.0f, 0.0f}), 1.0f, 2e-3f);
}

TEST(Environment, LightFromWorldTurnsIt) {
    DMat3 quarter{1.0};  // world +X is the light's -Z
    quarter[0] = {0.0, 0.0, -1.0};
    quarter[2] = {1.0, 0.0, 0.0};
    const scene::GradientTexture around{scene::Axis::x,
                                        {{0.0, Color{0.0f}}, {1.0, Color{1.0f, 2.0f, 0.5f}}}};
    const Sky sky(around, scene::TextureSpace::uv, quarter);
    EXPECT_NEAR(sky.environment.radiance({1.0f, 0.0f, 0.0f}).r, 1.0f, 1e-6f);
    EXPECT_NEAR(sky.environment.radiance({0.0f, 0.0f, 1.0f}).r, 1.5f, 1e-6f);
}

TEST(Environment, SamplesOfPicturesGiveTheLightThereIs) {
    const std::array pictures = {test::picture_of(spots(64, 32))};
    const scene::ImageTexture image{scene::PictureId(0)};
    expect_right_mean(Sky(image, scene::TextureSpace::uv, DMat3{1.0}, pictures).environment, 0.01);
    expect_right_mean(
        Sky(image, scene::TextureSpace::uv, turned_and_stretched(), pictures).environment, 0.01);
}

TEST(Environment, SamplesOfPatternsGiveTheLightThereIs) {
    const auto ramp = ramp_along(scene::Axis::y);
    expect_right_mean(Sky(ramp, scene::TextureSpace::object).environment, 1e-3);
    expect_right_mean(Sky(ramp, scene::TextureSpace::world, turned_and_stretched()).environment,
                      1e-3);
}

TEST(Environment, DensityOfPicturesIsTheOneSaid) {
    const std::array pictures = {test::picture_of(test::random_codes(24, 32, 4))};
    const scene::ImageTexture image{scene::PictureId(0)};
    expect_right_density(Sky(image, scene::TextureSpace::uv, DMat3{1.0}, pictures).environment, 40);
    expect_right_density(
        Sky(image, scene::TextureSpace::uv, turned_and_stretched(), pictures).environment, 40);
    expect_right_density(Sky(ramp_along(scene::Axis::y), scene::TextureSpace::object).environment,
                         32);
}

TEST(Environment, BrightSpotsAreChosenMoreOften) {
    const std::array pictures = {test::picture_of(spots(64, 32))};
    const Sky sky(scene::ImageTexture{scene::PictureId(0)}, scene::TextureSpace::uv, DMat3{1.0},
                  pictures);
    const Vec3 normal{0.0f, 1.0f, 0.0f};
    double most = 0.0;
    double sum = 0.0;
    for (int i = 0; i < 10'000; ++i) {
        const auto s = sky.environment.sample(normal, {i / 10'000.0, std::fmod(i * 0.618, 1.0)});
        most = std::max(most, double{s->irradiance.g});
        sum += double{s->irradiance.g};
    }
    EXPECT_LT(most, 6.0 * sum / 10'000.0);
}

TEST(Environment, DarkPlacesAreChosenToo) {
    image::CodedImage half{2, 1, {0, 0, 0, 255, 255, 255}};
    const std::array pictures = {test::picture_of(half)};
    const Sky sky(scene::ImageTexture{scene::PictureId(0)}, scene::TextureSpace::uv, DMat3{1.0},
                  pictures);
    test::Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 d(test::sphere_direction(random));
        EXPECT_GT(sky.environment.pdf(d, d), 0.001f);
    }
}

TEST(Environment, PolesShowTheirOwnEndOfAPicture) {
    image::CodedImage ground{1, 2, {255, 255, 255, 0, 0, 0}};  // white above black
    const std::array pictures = {test::picture_of(ground)};
    const Sky sky(scene::ImageTexture{scene::PictureId(0)}, scene::TextureSpace::uv, DMat3{1.0},
                  pictures);
    EXPECT_EQ(sky.environment.radiance({0.0f, 1.0f, 0.0f}), (Color{2.0f, 1.0f, 4.0f}));
    EXPECT_EQ(sky.environment.radiance({0.0f, -1.0f, 0.0f}), Color{0.0f});
}

TEST(Environment, SunOfAPictureInFloatsIsChosenByItsLight) {
    image::Image light(64, 32);
    for (Color& pixel : light.pixels) pixel = Color{0.1f};
    light.at(20, 8) = Color{50'000.0f};
    const std::array pictures = {test::picture_of(light)};
    const Sky sky(scene::ImageTexture{scene::PictureId(0)}, scene::TextureSpace::uv, DMat3{1.0},
                  pictures);
    const Vec3 up{0.0f, 1.0f, 0.0f};
    int bright_count = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto s = sky.environment.sample(up, {i / 1000.0, std::fmod(i * 0.618, 1.0)});
        ASSERT_TRUE(s);
        if (sky.environment.radiance(s->wi).g > 100.0f) ++bright_count;
    }
    EXPECT_GT(bright_count, 500);
    expect_right_mean(sky.environment, 0.02);
}

TEST(Environment, BlackOneGivesNoSamples) {
    image::CodedImage black{2, 2, {}};
    black.rgb.assign(12, 0);
    const std::array pictures = {test::picture_of(black)};
    const Sky sky(scene::ImageTexture{scene::PictureId(0)}, scene::TextureSpace::uv, DMat3{1.0},
                  pictures);
    EXPECT_FALSE(sky.environment.sample({0.0f, 1.0f, 0.0f}, {0.5, 0.5}));
    EXPECT_EQ(sky.environment.pdf({0.0f, 1.0f, 0.0f}, {0.0f, 1.0f, 0.0f}), 0.0f);
    EXPECT_EQ(sky.environment.mean_radiance(), Color{0.0f});
}

}  // namespace
}  // namespace lray::shade
