#include "shade/flat.h"

#include <gtest/gtest.h>

namespace lray::shade {
namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;

TEST(Flat, MissGivesTheBackground) {
    const scene::World world;
    EXPECT_EQ(flat(world, bvh::Hit{}, {0.1f, 0.2f, 0.3f}), Color(0.1f, 0.2f, 0.3f));
}

TEST(Flat, HitGivesTheDiffuseColourOfItsObject) {
    scene::World world;
    world.materials.resize(3);
    world.materials[1].diffuse = Color{1.0f, 0.5f, 0.25f};
    world.materials[2].diffuse = Color{7.0f, 0.0f, 0.0f};  // beyond 1: kept as it is
    world.objects.resize(2);
    world.objects[0].material = 2;
    world.objects[1].material = 1;
    auto& spheres = world.object_ids[static_cast<std::size_t>(PrimitiveKind::sphere)];
    auto& planes = world.object_ids[static_cast<std::size_t>(PrimitiveKind::plane)];
    spheres = {scene::ObjectId(std::size_t{0}), scene::ObjectId(std::size_t{1})};
    planes = {scene::ObjectId(std::size_t{0})};
    const Color background{0.0f};
    const auto color_of = [&](PrimitiveKind kind, std::size_t index) {
        return flat(world, {1.0f, 0.0f, 0.0f, PrimitiveId(kind, index)}, background);
    };
    EXPECT_EQ(color_of(PrimitiveKind::sphere, 0), Color(7.0f, 0.0f, 0.0f));
    EXPECT_EQ(color_of(PrimitiveKind::sphere, 1), Color(1.0f, 0.5f, 0.25f));
    EXPECT_EQ(color_of(PrimitiveKind::plane, 0), Color(7.0f, 0.0f, 0.0f));
}

TEST(Flat, VertexColoursAreTheirMean) {
    scene::World world;
    scene::Texture texture;
    texture.pattern = scene::VertexColorsTexture{};
    texture.space = scene::TextureSpace::vertex_colors;
    world.textures = {texture};
    world.materials.resize(1);
    world.materials[0].diffuse = {Color{1.0f}, scene::TextureId(std::size_t{0})};
    world.objects.resize(2);
    world.mean_colors = {Color{0.5f, 0.25f, 0.0f}};
    world.object_ids[static_cast<std::size_t>(PrimitiveKind::triangle)] = {
        scene::ObjectId(std::size_t{0}), scene::ObjectId(std::size_t{1})};
    const auto color_of = [&](std::size_t index) {
        return flat(world, {1.0f, 0.0f, 0.0f, PrimitiveId(PrimitiveKind::triangle, index)},
                    Color{0.0f});
    };
    EXPECT_EQ(color_of(0), Color(0.5f, 0.25f, 0.0f));
    EXPECT_EQ(color_of(1), Color(1.0f));
}

}  // namespace
}  // namespace lray::shade
