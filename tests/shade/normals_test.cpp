#include "shade/normals.h"

#include <gtest/gtest.h>

#include "bvh/accel.h"
#include "shade/shader.h"

namespace lray::shade {
namespace {

scene::World world_of_one_sphere() {
    scene::World world;
    world.materials.emplace_back();
    world.materials.back().diffuse = Color{0.25f, 0.5f, 0.75f};
    world.objects.emplace_back();
    world.spheres.push_back({Vec3{0.0f}, 1.0f});
    world.object_ids[static_cast<std::size_t>(scene::PrimitiveKind::sphere)].emplace_back(
        std::size_t{0});
    return world;
}

struct Seen {
    Ray ray{};
    bvh::Hit hit{};
    bvh::TraceCounts counts{};
};

Seen look(const scene::World& world, Vec3 origin, Vec3 dir) {
    Seen seen{{origin, dir}};
    const auto accel = bvh::build(world, {.kind = bvh::AccelKind::none});
    seen.hit = accel->nearest_hit(seen.ray, Interval{}, seen.counts);
    return seen;
}

TEST(Normals, EachDirectionHasItsColour) {
    const scene::World world = world_of_one_sphere();
    for (const Vec3 normal : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{-1, 0, 0}}) {
        const Seen seen = look(world, 3.0f * normal, -normal);
        const Color color = normals(world, seen.ray, seen.hit);
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(color[channel], (normal[channel] + 1.0f) / 2.0f, 1e-6f);
        }
    }
}

TEST(Normals, MissIsBlack) {
    const scene::World world = world_of_one_sphere();
    EXPECT_EQ(normals(world, {}, {}), Color(0.0f));
}

TEST(Shade, CallsTheShaderThatIsAskedFor) {
    const scene::World world = world_of_one_sphere();
    const Seen seen = look(world, {0.0f, 0.0f, 3.0f}, {0.0f, 0.0f, -1.0f});
    ShadeInput input{world, {Shader::flat, Color{0.1f}, 2.0}};
    const auto color = [&](const bvh::Hit& hit) {
        return shade(input, seen.ray, hit, seen.counts);
    };
    EXPECT_EQ(color(seen.hit), Color(0.25f, 0.5f, 0.75f));
    EXPECT_EQ(color({}), Color(0.1f));
    input.settings.shader = Shader::normals;
    EXPECT_EQ(color(seen.hit), Color(0.5f, 0.5f, 1.0f));
    EXPECT_EQ(color({}), Color(0.0f));
    input.settings.shader = Shader::depth;
    EXPECT_EQ(color(seen.hit), Color(0.5f));
    input.settings.shader = Shader::cost;
    EXPECT_EQ(color(seen.hit), Color(0.0f, 0.0f, 0.1f));  // one test
}

}  // namespace
}  // namespace lray::shade
