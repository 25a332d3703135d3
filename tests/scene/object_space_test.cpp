// Which objects keep the space of their shape, and where it is.
#include "scene/object_space.h"

#include <gtest/gtest.h>

#include "tests/scene/scene_maker.h"

namespace lray::scene {
namespace {

const Transform kSteps = Transform::scaling({2, -3, 4})
                             .then(Transform::rotation_y(30))
                             .then(Transform::translation({1, 2, 3}));

MaterialId add_textured(SceneMaker& maker, TextureSpace space = TextureSpace::object) {
    const MaterialId id = maker.add_material(Color{0.5f});
    Texture texture;
    texture.space = space;
    maker.scene.textures.push_back(texture);
    maker.scene.materials[id.index()].diffuse.texture_id =
        TextureId{maker.scene.textures.size() - 1};
    return id;
}

Material& material_of(SceneMaker& maker, MaterialId id) {
    return maker.scene.materials[id.index()];
}

/// The space of the first object of a world of one sphere.
const ObjectSpace* space_of_sphere(SceneMaker& maker, MaterialId material, World& world) {
    maker.place(maker.add(SphereShape{}, {.transform = kSteps, .material = material}));
    world = maker.flatten_cleanly();
    return world.object_spaces.find(ObjectId{std::size_t{0}});
}

TEST(ObjectSpace, OfATexturedShapeIsThatBeforeItsSteps) {
    SceneMaker maker;
    World world;
    const ObjectSpace* const space = space_of_sphere(maker, add_textured(maker), world);
    ASSERT_NE(space, nullptr);
    const DVec3 there{0.3, -0.4, 0.5};
    EXPECT_LE(glm::length(space->point(kSteps.point(there)) - there), 1e-14);
}

TEST(ObjectSpace, IsNotKeptWhereNothingDependsOnIt) {
    for (const bool is_textured_in_world : {false, true}) {
        SceneMaker maker;
        World world;
        const MaterialId plain = maker.add_material(Color{0.5f});
        const MaterialId material =
            is_textured_in_world ? add_textured(maker, TextureSpace::world) : plain;
        add_textured(maker);  // another material, of no shape
        EXPECT_EQ(space_of_sphere(maker, material, world), nullptr);
        EXPECT_EQ(world.object_spaces.find(ObjectId{std::size_t{7}}), nullptr);
    }
}

TEST(ObjectSpace, IsKeptForEverythingThatDependsOnIt) {
    const auto expect_kept = [](auto change) {
        SceneMaker maker;
        World world;
        const MaterialId material = maker.add_material(Color{0.5f});
        maker.scene.textures.emplace_back();
        change(material_of(maker, material), TextureId{std::size_t{0}});
        EXPECT_NE(space_of_sphere(maker, material, world), nullptr);
    };
    expect_kept([](Material& material, TextureId id) { material.bump_id = id; });
    expect_kept([](Material& material, TextureId id) { material.normal_map_id = id; });
    expect_kept([](Material& material, TextureId id) {
        material.bump_id = id;
        material.bump_unit = BumpUnit::uv;
    });
    expect_kept([](Material& material, TextureId id) { material.opacity.texture_id = id; });
    expect_kept([](Material& material, TextureId id) {
        material.ambient = Coefficient{Color{0.5f}, id};
    });
    expect_kept([](Material& material, TextureId id) { material.roughness.texture_id = id; });
    expect_kept([](Material& material, TextureId) {
        material.model = ReflectionModel::ward;
        material.roughness = Vec2{0.1f, 0.4f};
    });
}

TEST(ObjectSpace, IsOfTheObjectItWasKeptForAlone) {
    SceneMaker maker;
    const MaterialId textured = add_textured(maker);
    maker.place(maker.add(SphereShape{}));
    maker.place(maker.add(BoxShape{}, {.transform = kSteps, .material = textured}));
    maker.place(maker.add(SphereShape{}));
    maker.place(maker.add(SphereShape{{5, 0, 0}}, {.material = textured}));
    const World world = maker.flatten_cleanly();
    ASSERT_EQ(world.objects.size(), 4u);
    EXPECT_EQ(world.object_spaces.find(ObjectId{std::size_t{0}}), nullptr);
    ASSERT_NE(world.object_spaces.find(ObjectId{std::size_t{1}}), nullptr);
    EXPECT_EQ(world.object_spaces.find(ObjectId{std::size_t{2}}), nullptr);
    ASSERT_NE(world.object_spaces.find(ObjectId{std::size_t{3}}), nullptr);
    // Where the shape says it is, is part of the shape.
    EXPECT_EQ(world.object_spaces.find(ObjectId{std::size_t{3}})->point({5, 0, 0}),
              (DVec3{5, 0, 0}));
}

TEST(ObjectSpace, IsKeptWhereAMaterialMayBeInherited) {
    for (const bool is_textured : {false, true}) {
        SceneMaker maker;
        const MaterialId material =
            is_textured ? add_textured(maker) : maker.add_material(Color{0.5f});
        const NodeId pair =
            maker.add_group({maker.add(SphereShape{}, {.transform = kSteps}),
                             maker.add(SphereShape{}, {.material = maker.add_material({})})});
        maker.place(maker.add_instance(pair, {.material = material}));
        maker.place(maker.add_instance(pair));
        FlattenLimits limits;
        limits.sharing = {1, 1};
        Diagnostics diagnostics;
        const auto world = flatten(maker.scene, limits, diagnostics);
        ASSERT_TRUE(world.has_value());
        ASSERT_EQ(world->prototypes.size(), 1u);
        const ObjectSpaces& spaces = world->prototypes[0].object_spaces;
        EXPECT_EQ(spaces.find(ObjectId{std::size_t{0}}) != nullptr, is_textured);
        EXPECT_EQ(spaces.find(ObjectId{std::size_t{1}}), nullptr);  // it has its own, plain
    }
}

TEST(ObjectSpace, OfAllIsKeptWhenAskedFor) {
    SceneMaker maker;
    maker.place(maker.add(SphereShape{}, {.transform = kSteps}));
    FlattenLimits limits;
    limits.spaces = KeptSpaces::all;
    Diagnostics diagnostics;
    const auto world = flatten(maker.scene, limits, diagnostics);
    ASSERT_TRUE(world.has_value());
    EXPECT_NE(world->object_spaces.find(ObjectId{std::size_t{0}}), nullptr);
}

}  // namespace
}  // namespace lray::scene
