// read_nff: every mistake at its place.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/scene/formats/nff_reading.h"

namespace lray::scene {
namespace {

TEST(ReadNffMistakes, NumbersThatAreNone) {
    EXPECT_EQ(nff_errors(on_line_2("s 1 x2 3 4")),
              "2:5 E0706 `x2` expected a number, found `x2`\n");
    EXPECT_EQ(nff_errors(on_line_2("s 1 2 3 nan")),
              "2:9 E0706 `nan` expected a finite number, found `nan`\n");
    EXPECT_EQ(nff_errors(on_line_2("s 1 2 3 1e39")),
              "2:9 E0706 `1e39` `1e39` is too large: numbers go up to 3.4e38\n");
    EXPECT_EQ(
        nff_errors(on_line_2("s 1,5 2 3 1")),
        "2:3 E0706 `1,5` expected a number, found `1,5`; decimals are written with a point\n");
    EXPECT_EQ(nff_errors(on_line_2("s - 2 3 1")), "2:3 E0706 `-` expected a number, found `-`\n");
}

TEST(ReadNffMistakes, TooFewNumbers) {
    EXPECT_EQ(nff_errors("b 1 2"), "1:1 E0706 `b 1 2` `b` needs 3 numbers, this has 2\n");
    EXPECT_EQ(nff_errors("f 1 2\ns 0 0 0 1"),
              "1:1 E0706 `f 1 2` `f` needs 8 numbers, this has 2\n");
    EXPECT_EQ(nff_errors(on_line_2("s 1 2 # 3 4")),
              "2:1 E0706 `s 1 2` `s` needs 4 numbers, this has 2\n");
    EXPECT_EQ(nff_errors(on_line_2("c\ns 0 0 0 1")),
              "2:1 E0706 `c` `c` needs 8 numbers, this has 0\n");
    EXPECT_EQ(nff_errors("l 1 2 3 4\nb 0 0 0"),
              "1:1 E0706 `l 1 2 3 4` `l` needs 3 numbers, or 6 with a colour, this has 4\n");
    EXPECT_EQ(nff_errors(on_line_2("p")),
              "2:1 E0706 `p` `p` needs the count of its corners, this has 0\n");
    EXPECT_EQ(nff_errors(on_line_2("pp 3 0 0 0 0 0 1\ns 0 0 0 1\ns 0 0 0 1\ns 0 0 0 1")),
              "2:1 E0706 `pp 3 0 0 0 0 0 1` `pp 3` needs 18 numbers, this has 6\n");
    EXPECT_EQ(nff_errors("v from 1 2 3 at 0 0 0 angle\nb 0 0 0"),
              "1:1 E0706 `v from 1 2 3 at 0 0 0 angle` `angle` needs 1 number, this has 0\n");
}

TEST(ReadNffMistakes, TooManyNumbers) {
    EXPECT_EQ(nff_errors(on_line_2("s 1 2 3 4 5 6")),
              "2:11 E0706 `5` `s` needs 4 numbers; this is one more\n");
    EXPECT_EQ(nff_errors(on_line_2("p 3 0 0 0 1 0 0 0 1 0 7")),
              "2:23 E0706 `7` `p 3` needs 9 numbers; this is one more\n");
    EXPECT_EQ(nff_errors("1 2 3"), "1:1 E0706 `1` expected a statement, found `1`\n");
}

TEST(ReadNffMistakes, WordsThatAreNone) {
    const auto hint_of = [](std::string_view nff) {
        const NffReading reading(nff);
        EXPECT_EQ(reading.diagnostics.error_count(), 1u) << reading.errors();
        return reading.diagnostics.sorted().at(0)->hint;
    };
    EXPECT_EQ(nff_errors(on_line_2("torus 1 2 3\ns 0 0 0 1")),
              "2:1 E0706 `torus` NFF has no `torus`\n");
    EXPECT_EQ(hint_of("sphere 0 0 0 1"), "here it is called `s`");
    EXPECT_EQ(hint_of("S 0 0 0 1"), "did you mean `s`?");
    EXPECT_EQ(hint_of("v form 0 0 1 at 0 0 0"), "did you mean `from`?");
    EXPECT_EQ(nff_errors("// a comment"), "1:1 E0706 `//` comments start with `#`\n");
}

TEST(ReadNffMistakes, CornersThatCannotBe) {
    EXPECT_EQ(nff_errors(on_line_2("p 2 0 0 0 1 0 0")),
              "2:3 E0706 `2` a polygon has 3 corners or more, this is `2`\n");
    EXPECT_EQ(nff_errors(on_line_2("p 3.5 0 0 0 1 0 0")),
              "2:3 E0706 `3.5` a polygon has 3 corners or more, this is `3.5`\n");
    EXPECT_EQ(nff_errors(on_line_2("p -3")),
              "2:3 E0706 `-3` a polygon has 3 corners or more, this is `-3`\n");
    EXPECT_EQ(nff_errors(on_line_2("p 1000000 0 0 0")),
              "2:3 E0706 `1000000` a polygon of 1000000 corners needs 3000000 numbers; the file "
              "ends before\n");
    EXPECT_EQ(nff_errors(on_line_2("p 1e30 0 0 0")),
              "2:3 E0705 `1e30` a polygon can have 1048576 corners, this is `1e30`\n");
}

TEST(ReadNffMistakes, ValuesOutOfRange) {
    EXPECT_EQ(nff_errors(on_line_2("s 0 0 0 -1")),
              "2:9 E0304 `-1` a radius is not negative, this is `-1`\n");
    EXPECT_EQ(nff_errors(on_line_2("s 0 0 0 0")),
              "2:9 E0304 `0` the radius of a sphere is greater than 0\n");
    EXPECT_EQ(nff_errors(on_line_2("c 0 0 0 -1 0 0 1 1")),
              "2:9 E0304 `-1` a radius is not negative, this is `-1`\n");
    EXPECT_EQ(nff_errors(on_line_2("c 0 0 0 0 0 0 1 0")),
              "2:1 E0304 `c 0 0 0 0 0 0 1 0` both radii of this cone are 0\n");
    EXPECT_EQ(nff_errors(on_line_2("c 1 2 3 1 1 2 3 2")),
              "2:1 E0304 `c 1 2 3 1 1 2 3 2` both ends of this cone are the same point\n");
    EXPECT_EQ(nff_errors("f 1 1 1 -1 0 1 0 1"),
              "1:9 E0304 `-1` Kd is not negative, this is `-1`\n");
    EXPECT_EQ(nff_errors("b 0 -1 0"),
              "1:5 E0304 `-1` a part of the background is not negative, this is `-1`\n");
    EXPECT_EQ(
        nff_errors("f 1e20 1 1 1e20 0 1 0 1"),
        "1:1 E0304 `f 1e20 1 1 1e20 0 1 0 1` Kd times the colour is larger than numbers go\n");
}

std::string view(std::string_view rest) {
    return fmt::format("v from 0 0 5 at 0 0 0 {}", rest);
}

TEST(ReadNffMistakes, ViewsWithoutADirection) {
    EXPECT_EQ(nff_errors("v from 1 2 3 at 1 2 3 up 0 1 0 angle 45"),
              "1:1 E0311 `v from 1 2 3 at 1 2 3 up 0 1 0 angle 45` `from` and `at` are the same "
              "point\n");
    EXPECT_EQ(
        nff_errors(view("up 0 0 0 angle 45")),
        "1:1 E0311 `v from 0 0 5 at 0 0 0 up 0 0 0 angle 45` `up` is zero, and no direction\n");
    EXPECT_EQ(nff_errors(view("up 0 0 -2 angle 45")),
              "1:1 E0311 `v from 0 0 5 at 0 0 0 up 0 0 -2 angle 45` the view goes along its `up` "
              "direction\n");
}

TEST(ReadNffMistakes, ViewsThatAreNotWhole) {
    EXPECT_EQ(nff_errors(view("angle 45\nb 0 0 0")),
              "1:1 E0706 `v from 0 0 5 at 0 0 0 angle 45` this view has no `up`\n");
    EXPECT_EQ(nff_errors(view("from 0 0 1")), "1:23 E0402 `from` `from` is set twice\n");
    EXPECT_EQ(
        nff_errors(view("up 0 1 0 angle 180")),
        "1:38 E0304 `180` `angle` is greater than 0 and at most 179 degrees, this is `180`\n");
    EXPECT_EQ(nff_errors(view("up 0 1 0 angle 45 resolution 0 5")),
              "1:52 E0304 `0` a side of the picture has 1 to 1048576 pixels, this is `0`\n");
    EXPECT_EQ(nff_errors(view("up 0 1 0 angle 45 resolution 7 5.5")),
              "1:54 E0304 `5.5` a side of the picture has 1 to 1048576 pixels, this is `5.5`\n");
}

TEST(ReadNffMistakes, SecondViewsAndBackgrounds) {
    const NffReading reading(
        fmt::format("b 0 0 0\nb 1 1 1\n{0}\n{0}\n", view("up 0 1 0 angle 45")));
    EXPECT_EQ(reading.errors(),
              "2:1 E0405 `b 1 1 1` a second `b`: a file has one background\n"
              "4:1 E0405 `v` a second `v`: a file has one view\n");
    const Label& label = reading.diagnostics.sorted().at(1)->labels.at(0);
    EXPECT_EQ(reading.sources.position(label.span).line, 3u);
}

TEST(ReadNffMistakes, ShapesBeforeTheFirstFillAreToldOfOnce) {
    EXPECT_EQ(nff_errors("b 0 0 0\ns 0 0 0 1\npp 3\n0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1\n"),
              "2:1 E0706 `s` `s` before the first `f`, which says what shapes are made of\n");
    EXPECT_EQ(nff_errors("f 1 1 x\ns 0 0 0 1\n"), "1:7 E0706 `x` expected a number, found `x`\n")
        << "a wrong one is there";
}

TEST(ReadNffMistakes, EachStatementIsToldOfOnceAndTheRestIsRead) {
    EXPECT_EQ(nff_errors(on_line_2("s 1 x y z\n5 5\ns 0 0 0\nc 0 0 0 -1\n0 0 1 -1\nq\ns 0 0 0 1")),
              "2:5 E0706 `x` expected a number, found `x`\n"
              "4:1 E0706 `s 0 0 0` `s` needs 4 numbers, this has 3\n"
              "5:9 E0304 `-1` a radius is not negative, this is `-1`\n");
    std::string many;
    for (int i = 0; i < 30; ++i) many += "s 0 0 0 x\n";
    const NffReading reading(on_line_2(many));
    EXPECT_EQ(reading.diagnostics.error_count(), 20u);
    EXPECT_EQ(reading.diagnostics.sorted().back()->notes.at(0),
              "after 20 errors the rest of this file is not read");
}

TEST(ReadNffMistakes, FilesThatAreNoNff) {
    const NffReading binary(std::string_view("b 0 0 0\n\0", 9));
    ASSERT_EQ(binary.diagnostics.error_count(), 1u) << binary.errors();
    EXPECT_EQ(binary.diagnostics.sorted().at(0)->span, Span::make(binary.file, 8, 9));
    EXPECT_EQ(binary.diagnostics.sorted().at(0)->message,
              "this is not NFF text but a binary file: here is a NUL byte");
    EXPECT_EQ(nff_errors(std::string_view("s 1 \0", 5)).substr(0, 9), "1:5 E0003");
    EXPECT_EQ(nff_errors(std::string_view("#\0", 2)).substr(0, 9), "1:2 E0003");
    EXPECT_EQ(nff_errors(std::string_view("\xFF\xFE"
                                          "b\0",
                                          4)),
              "1:1 E0003 `\xFF\xFE` this file is UTF-16; save it as UTF-8\n");
    EXPECT_EQ(nff_errors("nff\nversion 2.00\n"),
              "1:1 E0705 `nff` this is an NFF file of WorldToolKit; read is the Neutral File "
              "Format of Haines\n");
}

TEST(ReadNffMistakes, LimitsHold) {
    NffLimits limits;
    limits.nodes = 12;
    limits.used_nodes = 10;
    EXPECT_EQ(nff_errors(on_line_2("s 0 0 0 1\nl 0 0 0\ns 1 1 1 1\ns 2 2 2 2"), limits),
              "4:1 E0513 `s 1 1 1 1` the scene has more than 12 nodes\n");
    EXPECT_EQ(nff_errors(on_line_2("p 5 0 0 0 1 0 0 2 1 0 1 2 0 0 1 0"), limits).substr(0, 9),
              "2:1 E0513");
    limits = {};
    limits.value_bytes = 2000;
    std::string surfaces;
    for (int i = 0; i < 20; ++i) surfaces += fmt::format("f {} 1 1 1 0 1 0 1\ns 0 0 0 1\n", i);
    EXPECT_NE(nff_errors(surfaces, limits).find("E0516"), std::string::npos);
    std::string lights;
    for (int i = 0; i < 20; ++i) lights += "l 0 0 0\n";
    EXPECT_NE(nff_errors(lights, limits).find("E0516"), std::string::npos);
    std::string same;
    for (int i = 0; i < 20; ++i) same += fmt::format("f 1 1 1 1 0 1 0 1\ns {} 0 0 1\n", i);
    EXPECT_TRUE(NffReading(same, limits).scene) << "one surface";
}

}  // namespace
}  // namespace lray::scene
