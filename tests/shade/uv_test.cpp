#include "shade/uv.h"

#include <gtest/gtest.h>

#include "shade/shader.h"

namespace lray::shade {
namespace {

scene::World world_of_a_floor() {
    scene::World world;
    world.materials.emplace_back();
    world.objects.emplace_back();
    world.planes.emplace_back();
    world.object_ids[static_cast<std::size_t>(scene::PrimitiveKind::plane)].emplace_back(
        std::size_t{0});
    return world;
}

Color color_above(const scene::World& world, float x, float z) {
    const Ray ray{{x, 2.0f, z}, {0.0f, -1.0f, 0.0f}};
    const bvh::Hit hit{.t = 2.0f,
                       .primitive_id = scene::PrimitiveId(scene::PrimitiveKind::plane, 0)};
    return uv(world, ray, hit);
}

TEST(Uv, ShowsWhatIsBehindThePoint) {
    const scene::World world = world_of_a_floor();
    EXPECT_EQ(color_above(world, 3.25f, -2.5f), (Color{0.25f, 0.5f, 0.0f}));
    EXPECT_EQ(color_above(world, 0.0f, 0.0f), (Color{0.0f, 0.0f, 0.0f}));
}

TEST(Uv, OfNegativeNumbersRunsTheSameWay) {
    const scene::World world = world_of_a_floor();
    EXPECT_EQ(color_above(world, -0.25f, 0.5f), (Color{0.75f, 0.5f, 0.0f}));
    EXPECT_EQ(color_above(world, -3.0f, 4.0f), (Color{0.0f, 0.0f, 0.0f}));
    // Just below 0: not 1, which no fraction is.
    EXPECT_EQ(color_above(world, -1e-12f, 0.0f).x, 0.0f);
}

TEST(Uv, MissIsBlack) {
    EXPECT_EQ(uv(world_of_a_floor(), {}, {}), Color{0.0f});
}

TEST(Uv, IsShownWhenAskedFor) {
    const scene::World world = world_of_a_floor();
    const ShadeInput input{world, {Shader::uv}};
    const Ray ray{{0.25f, 2.0f, -0.75f}, {0.0f, -1.0f, 0.0f}};
    const bvh::Hit hit{.t = 2.0f,
                       .primitive_id = scene::PrimitiveId(scene::PrimitiveKind::plane, 0)};
    EXPECT_EQ(shade(input, ray, hit, {}), (Color{0.25f, 0.75f, 0.0f}));
}

}  // namespace
}  // namespace lray::shade
