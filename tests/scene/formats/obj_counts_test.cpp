// Counting OBJ statements, exactly and from samples.
#include "scene/formats/obj_counts.h"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace lray::scene::obj {
namespace {

TEST(CountStatements, CountsByKeywordWhateverFollows) {
    const Counts counts = count_statements(
        Text("v 1 2 3\n  v x\nv\nvt 0\nvn\nvp 1\nf 1 2 3\n\tf 1/1 2//2\nfo 1\n# v 1\ng v\n"));
    EXPECT_EQ(counts.positions, 3u);
    EXPECT_EQ(counts.uvs, 1u);
    EXPECT_EQ(counts.normals, 1u);
    EXPECT_EQ(counts.faces, 2u);
    EXPECT_EQ(counts.corners, 5u);
}

TEST(CountStatements, JoinedLinesAreOneStatement) {
    const Counts counts = count_statements(Text("f 1 2 \\\r\nv 3 \\\n4\ng a\\\nv\nv 1 2 3"));
    EXPECT_EQ(counts.positions, 1u);
    EXPECT_EQ(counts.faces, 1u);
    EXPECT_EQ(counts.corners, 5u);
}

TEST(EstimateCounts, SmallTextIsCounted) {
    const Counts counts = estimate_counts(Text("v 1 2 3\nf 1 1 1\n"));
    EXPECT_EQ(counts.positions, 1u);
    EXPECT_EQ(counts.corners, 3u);
}

TEST(EstimateCounts, LargeTextIsNearlyRightAndNotBelow) {
    std::string text;
    for (int i = 0; i < 150'000; ++i) text += fmt::format("v {0} {0}.5 -{0}.25\n", i % 1000);
    for (int i = 0; i < 300'000; ++i) text += fmt::format("f {0} {0} {0}\n", i % 90'000 + 1);
    const Text padded(text);
    const Counts exact = count_statements(padded);
    const Counts estimate = estimate_counts(padded);
    EXPECT_EQ(exact.positions, 150'000u);
    EXPECT_EQ(exact.corners, 900'000u);
    EXPECT_GE(estimate.positions, exact.positions);
    EXPECT_LE(estimate.positions, exact.positions * 11 / 10);
    EXPECT_GE(estimate.faces, exact.faces);
    EXPECT_LE(estimate.faces, exact.faces * 11 / 10);
    EXPECT_EQ(estimate.uvs, 0u);
}

TEST(EstimateCounts, NeverMoreThanTheBytesHold) {
    // Positions exactly where samples are taken, comments elsewhere.
    const std::size_t size = std::size_t{1} << 23;
    std::string text(size, '#');
    for (std::size_t window = 0; window < 64; ++window) {
        const std::size_t begin = size / 64 * window;
        for (std::size_t i = 0; i + 8 <= (std::size_t{1} << 14); i += 8) {
            text.replace(begin + i, 8, "\nv 0 0 0");
        }
        text[begin + (std::size_t{1} << 14)] = '\n';
    }
    EXPECT_LE(estimate_counts(Text(text)).positions, size / 8);
}

}  // namespace
}  // namespace lray::scene::obj
