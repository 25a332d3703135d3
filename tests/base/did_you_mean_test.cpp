#include "base/did_you_mean.h"

#include <gtest/gtest.h>

#include <string>

namespace lray {
namespace {

TEST(EditDistance, CountsEachKindOfEditAsOne) {
    EXPECT_EQ(edit_distance("radius", "radius", 9), 0u);
    EXPECT_EQ(edit_distance("radius", "radios", 9), 1u);
    EXPECT_EQ(edit_distance("radius", "radus", 9), 1u);
    EXPECT_EQ(edit_distance("radius", "radiuss", 9), 1u);
    EXPECT_EQ(edit_distance("radius", "raduis", 9), 1u);
    EXPECT_EQ(edit_distance("kitten", "sitting", 9), 3u);
    EXPECT_EQ(edit_distance("", "abc", 9), 3u);
    EXPECT_EQ(edit_distance("ca", "abc", 9), 3u);  // optimal string alignment, not Damerau's 2
}

TEST(EditDistance, IgnoresCaseAndOrderOfItsArguments) {
    EXPECT_EQ(edit_distance("Radius", "rADIUS", 9), 0u);
    EXPECT_EQ(edit_distance("sitting", "kitten", 9), edit_distance("kitten", "sitting", 9));
}

TEST(EditDistance, GivesUpBeyondTheLimit) {
    EXPECT_EQ(edit_distance("kitten", "sitting", 3), 3u);
    EXPECT_EQ(edit_distance("kitten", "sitting", 2), 3u);
    EXPECT_EQ(edit_distance("kitten", "sitting", 0), 1u);
    EXPECT_EQ(edit_distance("a", "abcdefgh", 2), 3u);
}

TEST(NearestNames, NearestFirstAtMostThree) {
    const std::string_view names[] = {"scale", "shale", "stale", "stall", "scales", "sphere"};
    const auto near = nearest_names("scael", names);
    ASSERT_FALSE(near.empty());
    EXPECT_EQ(near[0], "scale");
    EXPECT_LE(nearest_names("stalk", names).size(), 3u);
}

TEST(NearestNames, AThirdOfTheLengthMayDiffer) {
    const std::string_view names[] = {"position"};
    EXPECT_EQ(nearest_names("postion", names).size(), 1u);
    EXPECT_EQ(nearest_names("pstoin", names).size(), 0u);
    const std::string_view letters[] = {"y"};
    EXPECT_EQ(nearest_names("x", letters).size(), 0u);  // nothing in common
    EXPECT_EQ(nearest_names("xy", letters).size(), 1u);
}

TEST(NearestNames, NoneForEndlessNames) {
    const std::string name(100'000, 'a');
    const std::string other(100'000, 'b');
    const std::string_view names[] = {other, name};
    EXPECT_TRUE(nearest_names(name, names).empty());
}

TEST(DidYouMean, NamesAreListedInWords) {
    const std::string_view one[] = {"radius"};
    EXPECT_EQ(did_you_mean("radios", one), "did you mean `radius`?");
    const std::string_view two[] = {"edge_u", "edge_v", "edge_u"};
    EXPECT_EQ(did_you_mean("edge_w", two), "did you mean `edge_u` or `edge_v`?");
    const std::string_view three[] = {"rotate_x", "rotate_y", "rotate_z"};
    EXPECT_EQ(did_you_mean("rotate_w", three),
              "did you mean `rotate_x`, `rotate_y` or `rotate_z`?");
    EXPECT_EQ(did_you_mean("material", one), "");
}

}  // namespace
}  // namespace lray
