// Scenes too large to flatten are refused before anything is made.
#include <gtest/gtest.h>

#include <string>

#include "tests/scene/scene_maker.h"

namespace lray::scene {
namespace {

Mesh make_strip(std::uint32_t triangle_count) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < triangle_count + 2; ++i) {
        mesh.positions.push_back({static_cast<float>(i), static_cast<float>(i % 2), 0.0f});
    }
    for (std::uint32_t i = 0; i < triangle_count; ++i) mesh.triangles.push_back({i, i + 1, i + 2});
    return mesh;
}

bool is_accepted(const Scene& scene, std::uint64_t limit) {
    Diagnostics diagnostics;
    return flatten(scene, {limit}, diagnostics).has_value();
}

TEST(FlattenLimits, CountOfPrimitivesBelowAtAndAboveTheLimit) {
    SceneMaker maker;
    maker.place(maker.add(SphereShape{}));
    const NodeId mesh = maker.add(MeshUse{maker.add_mesh(make_strip(7))});
    maker.place(mesh);
    maker.place(maker.add_instance(mesh));
    maker.place(maker.add_instance(mesh));  // 1 + 3 * 7 = 22
    EXPECT_FALSE(is_accepted(maker.scene, 21));
    EXPECT_TRUE(is_accepted(maker.scene, 22));
    EXPECT_TRUE(is_accepted(maker.scene, 23));
    const Diagnostic error = expect_refused(maker.scene, {21});
    EXPECT_EQ(error.code, Code::E0513);
    EXPECT_EQ(error.span, maker.scene.node(maker.scene.root).span);
    EXPECT_EQ(error.message,
              "the scene has 22 primitives, more than the limit of 21 (`--max-primitives`)");
}

// Each level is a group of two instances of the level below.
NodeId add_doubling(SceneMaker& maker, NodeId node, int levels) {
    for (int i = 0; i < levels; ++i) {
        const NodeId first = maker.add_instance(node);
        const NodeId second = maker.add_instance(node);
        node = maker.add_group({first, second});
    }
    return node;
}

TEST(FlattenLimits, TwoToThe40InstancesAreAFewStoredOnes) {
    SceneMaker maker;
    maker.place(add_doubling(maker, maker.add(SphereShape{}), 40));
    const World world = maker.flatten_cleanly();
    std::size_t stored = world.primitive_count();
    for (const Geometry& prototype : world.prototypes) stored += prototype.primitive_count();
    EXPECT_LE(stored, 3u * 4096);                 // near the root few uses stay as they are
    PlaceOffset leaves = std::uint64_t{1} << 36;  // of 16 spheres each
    EXPECT_GE(world.place_count, leaves);
    EXPECT_FALSE(finite_bounds(world).is_empty());
}

TEST(FlattenLimits, TwoToThe40CopiesAreRefusedAtOnce) {
    SceneMaker maker;
    maker.place(add_doubling(maker, maker.add(SphereShape{}), 40));
    const Diagnostic error = expect_refused(maker.scene, {.sharing = SharingRule::nothing()});
    EXPECT_EQ(error.code, Code::E0513);
    EXPECT_NE(error.message.find("1099511627776 primitives"), std::string::npos) << error.message;
    EXPECT_NE(error.message.find("limit of 50000000"), std::string::npos) << error.message;
    EXPECT_NE(error.message.find("--max-primitives"), std::string::npos) << error.message;
}

TEST(FlattenLimits, CountsThatOverflow64BitsAreRefused) {
    SceneMaker maker;
    maker.place(add_doubling(maker, maker.add(SphereShape{}), 300));
    const Diagnostic error = expect_refused(
        maker.scene, {.primitives = ~std::uint64_t{0} - 1, .sharing = SharingRule::nothing()});
    EXPECT_EQ(error.code, Code::E0513);
    EXPECT_NE(error.message.find("more than"), std::string::npos);
}

TEST(FlattenLimits, PlacesThatOverflow63BitsAreRefused) {
    SceneMaker maker;
    maker.place(add_doubling(maker, maker.add(SphereShape{}), 100));
    const Diagnostic error = expect_refused(maker.scene);
    EXPECT_EQ(error.code, Code::E0513);
    EXPECT_EQ(error.message,
              "the scene's instances lead to more than 18446744073709551615 places; the most is "
              "9223372036854775807");
}

TEST(FlattenLimits, PlacesJustBelow63BitsAreFine) {
    SceneMaker maker;
    // Levels of 16 uses, 15 of them: 2^60 places at the end, and a 16th of that above.
    NodeId node = maker.add(MeshUse{maker.add_mesh(make_strip(16))});
    for (int level = 0; level < 15; ++level) {
        std::vector<NodeId> uses;
        for (int i = 0; i < 16; ++i) uses.push_back(maker.add_instance(node));
        node = maker.add_group(uses);
    }
    maker.place(node);
    const World world = maker.flatten_cleanly();
    EXPECT_GT(world.place_count, PlaceOffset{1} << 60);
    EXPECT_LT(world.place_count, PlaceOffset{1} << 61);
}

TEST(FlattenLimits, InstancesDeeperThanTheMostAreCopiesAndTheMessageSaysSo) {
    // A chain in which each level is a little more than the one below, used twice: stored once each
    // as long as that is allowed.
    const auto make = [](int levels) {
        SceneMaker maker;
        NodeId node = maker.add_group({maker.add(SphereShape{}), maker.add(SphereShape{})});
        for (int i = 0; i < levels; ++i) {
            node = maker.add_group({maker.add_instance(node), maker.add(SphereShape{})});
            maker.place(node);
        }
        return maker;
    };
    const FlattenLimits limits{.primitives = 500, .sharing = {2, 0}};
    Diagnostics diagnostics;
    const auto world = flatten(make(64).scene, limits, diagnostics);
    ASSERT_TRUE(world.has_value());
    EXPECT_EQ(world->prototypes.size(), 63u);  // the last level is used once
    const Diagnostic error = expect_refused(make(400).scene, limits);
    EXPECT_EQ(error.code, Code::E0513);
    ASSERT_EQ(error.notes.size(), 1u);
    EXPECT_EQ(error.notes[0],
              "what is placed often is stored once, but not with more than 64 instances within "
              "each other");
}

TEST(FlattenLimits, MoreThanAWorldCanNumberIsRefusedWhateverTheLimit) {
    SceneMaker maker;
    maker.place(add_doubling(maker, maker.add(SphereShape{}), 29));
    const Diagnostic error = expect_refused(
        maker.scene, {.primitives = ~std::uint64_t{0}, .sharing = SharingRule::nothing()});
    EXPECT_EQ(error.code, Code::E0513);
    EXPECT_NE(error.message.find("the most is 268435456"), std::string::npos) << error.message;
}

TEST(FlattenLimits, TwoToThe40EmptyGroupsTakeNoTime) {
    SceneMaker maker;
    maker.place(add_doubling(maker, maker.add_group({}), 40));
    maker.place(maker.add(SphereShape{}));
    EXPECT_EQ(maker.flatten_cleanly().primitive_count(), 1u);
}

// Few primitives, but a chain of groups that is walked again for each of them.
TEST(FlattenLimits, LongChainsSharedManyTimesAreRefused) {
    SceneMaker maker;
    NodeId node = maker.add(SphereShape{});
    for (int i = 0; i < 100000; ++i) node = maker.add_group({node});
    maker.place(add_doubling(maker, node, 20));
    const Diagnostic error = expect_refused(maker.scene, {.sharing = SharingRule::nothing()});
    EXPECT_EQ(error.code, Code::E0513);
    EXPECT_NE(error.message.find("--max-primitives"), std::string::npos) << error.message;
}

// A mesh of few faces must not bring all vertices of its file into every copy.
TEST(FlattenLimits, UnusedVerticesAreNotCopied) {
    Mesh mesh = make_strip(2);
    mesh.positions.resize(1000000, Vec3{9.0f});
    mesh.parts.push_back({"last", 1, 1});
    SceneMaker maker;
    const MeshId mesh_id = maker.add_mesh(std::move(mesh));
    maker.place(maker.add(MeshUse{mesh_id}));
    maker.place(maker.add(MeshUse{mesh_id, 0}));
    const World world = maker.flatten_cleanly();
    EXPECT_EQ(world.triangles.size(), 3u);
    EXPECT_EQ(world.vertices.size(), 4u + 3u);
    EXPECT_EQ(world.vertices[world.triangles[2].vertices[0]], (Vec3{1, 1, 0}));
    EXPECT_EQ(world.vertices[world.triangles[2].vertices[2]], (Vec3{3, 1, 0}));
}

}  // namespace
}  // namespace lray::scene
