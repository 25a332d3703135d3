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

TEST(FlattenLimits, TwoToThe40InstancesAreRefusedAtOnce) {
    SceneMaker maker;
    maker.place(add_doubling(maker, maker.add(SphereShape{}), 40));
    const Diagnostic error = expect_refused(maker.scene);
    EXPECT_EQ(error.code, Code::E0513);
    EXPECT_NE(error.message.find("1099511627776 primitives"), std::string::npos) << error.message;
    EXPECT_NE(error.message.find("limit of 50000000"), std::string::npos) << error.message;
    EXPECT_NE(error.message.find("--max-primitives"), std::string::npos) << error.message;
}

TEST(FlattenLimits, CountsThatOverflow64BitsAreRefused) {
    SceneMaker maker;
    maker.place(add_doubling(maker, maker.add(SphereShape{}), 300));
    const Diagnostic error = expect_refused(maker.scene, {~std::uint64_t{0} - 1});
    EXPECT_EQ(error.code, Code::E0513);
    EXPECT_NE(error.message.find("more than"), std::string::npos);
}

TEST(FlattenLimits, MoreThanAWorldCanNumberIsRefusedWhateverTheLimit) {
    SceneMaker maker;
    maker.place(add_doubling(maker, maker.add(SphereShape{}), 29));
    const Diagnostic error = expect_refused(maker.scene, {~std::uint64_t{0}});
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
    const Diagnostic error = expect_refused(maker.scene);
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
