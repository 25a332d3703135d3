// read_obj: every mistake at its place.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "tests/scene/formats/obj_reading.h"

namespace lray::scene {
namespace {

TEST(ReadObjMistakes, NumbersThatAreNone) {
    EXPECT_EQ(errors(on_line_4("v 1 x2 3")), "4:5 E0701 `x2` expected a number, found `x2`\n");
    EXPECT_EQ(errors(on_line_4("v 1 2.5.1 3")),
              "4:5 E0701 `2.5.1` expected a number, found `2.5.1`\n");
    EXPECT_EQ(errors(on_line_4("vn 1 -- 3")), "4:6 E0701 `--` expected a number, found `--`\n");
    EXPECT_EQ(errors(on_line_4("vt é")), "4:4 E0701 `é` expected a number, found `é`\n");
    EXPECT_EQ(errors(on_line_4("v 1 2e 3")), "4:5 E0701 `2e` expected a number, found `2e`\n");
    EXPECT_EQ(errors(on_line_4("v 1 2 3\\4")),
              "4:7 E0701 `3\\4` expected a number, found `3\\4`\n");
    EXPECT_EQ(
        errors(on_line_4("v 1 2,5 3")),
        "4:5 E0701 `2,5` expected a number, found `2,5`; decimals are written with a point\n");
    const std::string long_token = std::string(31, 'x') + "\xC3\xA9" + std::string(10, 'x');
    EXPECT_EQ(errors(on_line_4("v 1 2 " + long_token)),
              fmt::format("4:7 E0701 `{}` expected a number, found `{}...`\n", long_token,
                          std::string(31, 'x')));
}

TEST(ReadObjMistakes, TooFewNumbers) {
    EXPECT_EQ(errors(on_line_4("v 1 2 ")), "4:1 E0701 `v 1 2` `v` needs 3 numbers, this has 2\n");
    EXPECT_EQ(errors(on_line_4("v # 1 2 3")), "4:1 E0701 `v` `v` needs 3 numbers, this has 0\n");
    EXPECT_EQ(errors("v 1 2 3\nf 1 1 1\nv 1 \\\n\n"),
              "3:1 E0701 `v 1` `v` needs 3 numbers, this has 1\n");
}

TEST(ReadObjMistakes, TooFewNumbersInOtherStatements) {
    EXPECT_EQ(errors(on_line_4("\tvn 1")), "4:2 E0701 `vn 1` `vn` needs 3 numbers, this has 1\n");
    EXPECT_EQ(errors(on_line_4("vt")), "4:1 E0701 `vt` `vt` needs 1 to 3 numbers, this has 0\n");
}

TEST(ReadObjMistakes, NumbersThatAreNotFiniteOrTooLarge) {
    EXPECT_EQ(errors(on_line_4("v nan 2 3")),
              "4:3 E0701 `nan` expected a finite number, found `nan`\n");
    EXPECT_EQ(errors(on_line_4("v 1 -Inf 3")),
              "4:5 E0701 `-Inf` expected a finite number, found `-Inf`\n");
    EXPECT_EQ(errors(on_line_4("vt -nan(ind)")),
              "4:4 E0701 `-nan(ind)` expected a finite number, found `-nan(ind)`\n");
    EXPECT_EQ(errors(on_line_4("v 1 2 1e999")),
              "4:7 E0701 `1e999` `1e999` is too large: numbers go up to 3.4e38\n");
    EXPECT_EQ(errors(on_line_4("vn 1 -3.5e38 3")),
              "4:6 E0701 `-3.5e38` `-3.5e38` is too large: numbers go up to 3.4e38\n");
    const Mesh mesh = read(on_line_4("v 3.4028234e38 -3.4028234e38 1e-60"));
    EXPECT_EQ(mesh.positions[3],
              Vec3(std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest(), 0.0f));
}

TEST(ReadObjMistakes, CornersThatAreNone) {
    const std::string expected = "expected a corner like `1`, `1/2`, `1//3` or `1/2/3`, found";
    for (const char* corner :
         {"x", "2x", "2.5", "+2", "/2", "2/x", "2//x", "2/2/2/2", "2/-", "-", "1,", "1/2/x"}) {
        const std::string text =
            fmt::format("{0}vt 0 0\nvt 0 0\nvn 0 0 1\nvn 0 0 1\nf 1 {1} 3\n", kTriangle, corner);
        EXPECT_EQ(errors(text), fmt::format("8:5 E0701 `{0}` {1} `{0}`\n", corner, expected));
    }
}

TEST(ReadObjMistakes, FacesWithTooFewCorners) {
    EXPECT_EQ(errors(on_line_4("f 1 2  # 3")),
              "4:1 E0701 `f 1 2` a face needs at least 3 corners, this has 2\n");
    EXPECT_EQ(errors(on_line_4("f")),
              "4:1 E0701 `f` a face needs at least 3 corners, this has 0\n");
}

TEST(ReadObjMistakes, IndicesOutOfRangeOfTheWholeFile) {
    EXPECT_EQ(errors(on_line_4("f 1 2 9999")), "4:7 E0702 `9999` vertex 9999 of 3\n");
    EXPECT_EQ(errors(on_line_4("f 4 2 1\nv 1 1 1\nf 1 5 2")), "6:5 E0702 `5` vertex 5 of 4\n");
    EXPECT_EQ(errors(on_line_4("vt 0 0\nf 1/1 2/2 3/1")),
              "5:9 E0702 `2` texture coordinate 2 of 1\n");
    EXPECT_EQ(errors(on_line_4("vn 0 0 1\nf 1//1 2//1 3//7")), "5:16 E0702 `7` normal 7 of 1\n");
    EXPECT_EQ(errors(on_line_4("f 1/1 2/1 3/1")),
              "4:5 E0702 `1` texture coordinate 1, but this file has no texture coordinates\n");
}

TEST(ReadObjMistakes, IndicesAtTheEdgesOfTheirTypes) {
    for (const char* index : {"4294967294", "4294967295", "4294967296", "4294967297",
                              "18446744073709551617", "99999999999999999999999999999999"}) {
        EXPECT_EQ(errors(on_line_4(fmt::format("f 1 2 {}", index))),
                  fmt::format("4:7 E0702 `{0}` vertex {0} of 3\n", index));
    }
    EXPECT_EQ(read(on_line_4("f 0000000000000000000000003 1 2")).triangles[0],
              (IndexTriple{2, 0, 1}));
}

TEST(ReadObjMistakes, IndexZero) {
    EXPECT_EQ(errors(on_line_4("f 0 1 2")), "4:3 E0702 `0` vertex 0: indices start at 1\n");
    EXPECT_EQ(errors(on_line_4("vn 0 0 1\nf 1//1 2//00 3//1")),
              "5:11 E0702 `00` normal 00: indices start at 1\n");
}

TEST(ReadObjMistakes, NegativeIndicesBeforeTheFirst) {
    EXPECT_EQ(errors(on_line_4("f -1 -2 -4\nv 1 1 1")),
              "4:9 E0702 `-4` vertex -4, but only 3 come before this statement\n");
    EXPECT_EQ(errors(fmt::format("f -1 1 2\n{}f 1 2 3", kTriangle)),
              "1:3 E0702 `-1` vertex -1, but none comes before this statement\n");
    EXPECT_EQ(
        errors("v 0 0 0\nf 1 1 -4294967297\nv 0 0 0"),
        "2:7 E0702 `-4294967297` vertex -4294967297, but only 1 comes before this statement\n");
}

TEST(ReadObjMistakes, NoFaces) {
    EXPECT_EQ(errors(kTriangle), "1:1 E0704 `` this file has no faces (`f` statements)\n");
    EXPECT_EQ(errors(""), "1:1 E0704 `` this file has no faces (`f` statements)\n");
    EXPECT_EQ(errors("f\\"), "1:1 E0704 `` this file has no faces (`f` statements)\n");
}

TEST(ReadObjMistakes, AWrongFileWithoutFacesIsOnlyWrong) {
    EXPECT_EQ(errors("v 1 2\n"), "1:1 E0701 `v 1 2` `v` needs 3 numbers, this has 2\n");
}

TEST(ReadObjMistakes, BinaryFiles) {
    using namespace std::string_view_literals;
    EXPECT_EQ(errors("v 0 0 0\n# a\0b\nf 1 1 1\n"sv),
              "2:4 E0003 `\0` this is not OBJ text but a binary file: here is a NUL byte\n"sv);
    EXPECT_EQ(errors("v 0 0 0\nf 1 1 1\n\0"sv),
              "3:1 E0003 `\0` this is not OBJ text but a binary file: here is a NUL byte\n"sv);
    EXPECT_EQ(errors("\xFF\xFEv\0 \0"sv),
              "1:1 E0003 `\xFF\xFE` this file is UTF-16; save it as UTF-8\n");
}

TEST(ReadObjMistakes, SeveralAreToldInOneRunEachOnItsLine) {
    EXPECT_EQ(errors(on_line_4("v a b c\nf 1 2 4\nf 1 2 5\nvn 1 0\nf 1//1 2//1 3//x")),
              "4:3 E0701 `a` expected a number, found `a`\n"
              "6:7 E0702 `5` vertex 5 of 4\n"
              "7:1 E0701 `vn 1 0` `vn` needs 3 numbers, this has 2\n"
              "8:13 E0701 `3//x` expected a corner like `1`, `1/2`, `1//3` or `1/2/3`, found "
              "`3//x`\n");
}

TEST(ReadObjMistakes, AfterTwentyTheRestIsNotRead) {
    std::string text(kTriangle);
    for (int i = 0; i < 50; ++i) text += "f 1 2 7\n";
    const Reading reading(text);
    const auto sorted = reading.diagnostics.sorted();
    ASSERT_EQ(sorted.size(), 20u);
    EXPECT_TRUE(sorted[18]->notes.empty());
    ASSERT_EQ(sorted[19]->notes.size(), 1u);
    EXPECT_EQ(sorted[19]->notes[0], "after 20 errors the rest of this file is not read");
}

TEST(ReadObjMistakes, AnywhereLoadedHasNoLabel) {
    Sources sources;
    const SourceId file = sources.add("a.obj", Text("v 1 2\n"));
    Diagnostics diagnostics;
    EXPECT_FALSE(read_obj(sources, file, {}, diagnostics));
    ASSERT_EQ(diagnostics.error_count(), 1u);
    EXPECT_TRUE(diagnostics.sorted()[0]->labels.empty());
}

TEST(ReadObjMistakes, AFaceOfTooManyCorners) {
    constexpr std::size_t kMost = std::size_t{1} << 20;
    std::string text = "v 0 0 0\nf";
    for (std::size_t i = 0; i < kMost; ++i) text += " 1";
    EXPECT_EQ(read(text).triangles.size(), kMost - 2);
    text += " 1\n";
    EXPECT_EQ(errors(text),
              "2:2097155 E0705 `1` a face can have 1048576 corners; this is one more\n");
}

}  // namespace
}  // namespace lray::scene
