// What cannot be placed is refused where it is used, also when it is stored once.
#include <gtest/gtest.h>

#include "tests/scene/scene_maker.h"

namespace lray::scene {
namespace {

constexpr SharingRule kEager{2, 0};

/// A group of so many unit spheres in a row along x.
NodeId add_row(SceneMaker& maker, int count) {
    std::vector<NodeId> spheres;
    for (int i = 0; i < count; ++i) {
        spheres.push_back(maker.add(SphereShape{{3.0 * i, 0, 0}, 1.0}));
    }
    return maker.add_group(spheres);
}

TEST(FlattenSharingErrors, AMapThatCannotBeInvertedIsReportedWhereItIsUsed) {
    SceneMaker maker;
    const NodeId row = add_row(maker, 3);
    maker.place(maker.add_instance(row));
    const NodeId flat = maker.add_instance(row, {.transform = Transform::scaling(DVec3{1, 0, 1})});
    maker.place(flat);
    const Diagnostic error = expect_refused(maker.scene, {.sharing = kEager});
    EXPECT_EQ(error.code, Code::E0310);
    EXPECT_EQ(error.span, maker.scene.node(flat).span);
}

TEST(FlattenSharingErrors, PlacesBeyondTheWorldAreReportedWhereTheyAreUsed) {
    SceneMaker maker;
    const NodeId row = add_row(maker, 3);
    maker.place(maker.add_instance(row));
    const NodeId far = maker.add_instance(row, {.transform = Transform::translation({0, 2e18, 0})});
    maker.place(far);
    const Diagnostic error = expect_refused(maker.scene, {.sharing = kEager});
    EXPECT_EQ(error.code, Code::E0304);
    EXPECT_EQ(error.span, maker.scene.node(far).span);
    EXPECT_EQ(error.message,
              "this instance reaches to 2e+18 in the world; coordinates end at 1e+18");
}

TEST(FlattenSharingErrors, ScalesThatMultiplyToNothingAreReported) {
    SceneMaker maker;
    NodeId node = add_row(maker, 2);
    for (int i = 0; i < 5; ++i) {
        const NodeSettings small{.transform = Transform::scaling(1e-4)};
        node = maker.add_group({maker.add_instance(node, small), maker.add_instance(node, small)});
    }
    maker.place(node);
    Diagnostics diagnostics;
    EXPECT_FALSE(flatten(maker.scene, {.sharing = kEager}, diagnostics).has_value());
    ASSERT_EQ(diagnostics.error_count(), 2u);  // at both uses
    const Diagnostic& error = *diagnostics.sorted().front();
    EXPECT_EQ(error.code, Code::E0304);
    EXPECT_EQ(error.message,
              "what this instance places is 1e-20 thin in the world; the least is 1e-18");
}

TEST(FlattenSharingErrors, AnErrorInASharedThingIsToldOnce) {
    SceneMaker maker;
    const NodeId bad = maker.add(SphereShape{}, {.transform = Transform::scaling(0.0)});
    const NodeId pair = maker.add_group({bad, maker.add(SphereShape{})});
    maker.place(maker.add_instance(pair));
    maker.place(maker.add_instance(pair));
    const Diagnostic error = expect_refused(maker.scene, {.sharing = kEager});
    EXPECT_EQ(error.code, Code::E0310);
    EXPECT_EQ(error.span, maker.scene.node(bad).span);
}

}  // namespace
}  // namespace lray::scene
