#include "shade/transport/media.h"

#include <gtest/gtest.h>

namespace lray::shade {
namespace {

TEST(Media, EmptySpaceHasNoMedium) {
    Media media;
    EXPECT_TRUE(media.is_empty());
    EXPECT_EQ(media.innermost(), Media::kNone);
    media.leave(3);
    EXPECT_TRUE(media.is_empty());
}

TEST(Media, InnermostIsWhatWasEnteredLast) {
    Media media;
    media.enter(4);
    media.enter(7);
    EXPECT_EQ(media.innermost(), 7u);
    EXPECT_TRUE(media.contains(4));
    media.leave(7);
    EXPECT_EQ(media.innermost(), 4u);
    EXPECT_FALSE(media.contains(7));
}

TEST(Media, OuterOneMayBeLeftFirst) {
    Media media;
    media.enter(4);
    media.enter(7);
    media.leave(4);
    EXPECT_EQ(media.innermost(), 7u);
    media.leave(7);
    EXPECT_TRUE(media.is_empty());
}

TEST(Media, OfOneMaterialTwiceTheInnerOneIsLeft) {
    Media media;
    media.enter(4);
    media.enter(4);
    media.leave(4);
    EXPECT_EQ(media.innermost(), 4u);
}

TEST(Media, BeyondItsSizeTheOutermostIsForgotten) {
    Media media;
    for (std::uint32_t i = 0; i <= Media::kMaxCount; ++i) media.enter(i);
    EXPECT_FALSE(media.contains(0));
    EXPECT_TRUE(media.contains(1));
    EXPECT_EQ(media.innermost(), Media::kMaxCount);
}

}  // namespace
}  // namespace lray::shade
