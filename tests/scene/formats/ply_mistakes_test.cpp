// read_ply: every mistake at its place.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "tests/scene/formats/ply_reading.h"

namespace lray::scene::ply {
namespace {

TEST(ReadPlyMistakes, FilesThatAreNone) {
    EXPECT_EQ(error_of("solid cube\n"),
              "1:1 E0701 `solid cube` a PLY file begins with a line `ply`; this is none");
    EXPECT_EQ(error_of(""), "1:1 E0701 `` a PLY file begins with a line `ply`; this is none");
    EXPECT_EQ(error_of("\x7f"
                       "ELF\1\2"),
              "E0701 at byte 0: a PLY file begins with a line `ply`; this is none");
    EXPECT_EQ(error_of("ply"), "1:1 E0701 `ply` a PLY file begins with a line `ply`; this is none");
}

TEST(ReadPlyMistakes, HeadersThatDoNotEnd) {
    EXPECT_EQ(error_of("ply\nformat ascii 1.0\nelement vertex 3"),
              "3:1 E0701 `` the header does not end: no line `end_header` follows");
    EXPECT_EQ(error_of(std::string("ply\n\x01\x02\x03", 7)),
              "E0701 at byte 4: the header does not end: no line `end_header` follows");
}

std::string error_in_header(std::string_view lines) {
    return error_of(header("ascii", lines));
}

TEST(ReadPlyMistakes, LinesOfTheHeader) {
    EXPECT_EQ(error_of("ply\nend_header\n"),
              "2:1 E0701 `end_header` the header has no line like `format ascii 1.0`");
    EXPECT_EQ(error_of("ply\nformat text 1.0\nend_header\n"),
              "2:8 E0701 `text` the format is `ascii`, `binary_little_endian` or "
              "`binary_big_endian`, not `text`");
    EXPECT_EQ(error_of("ply\nformat ascii 2.0\nend_header\n"),
              "2:14 E0705 `2.0` PLY of version 1.0 is read, this is `2.0`");
    EXPECT_EQ(error_in_header("format ascii 1.0\n"), "3:8 E0701 `ascii` the format is told twice");
    EXPECT_EQ(error_in_header("elements vertex 3\n"),
              "3:1 E0701 `elements` expected `format`, `element`, `property`, `comment` or "
              "`end_header`, found `elements`");
    EXPECT_EQ(error_in_header("element\n"),
              "3:1 E0701 `element` expected a line like `element vertex 3`");
    EXPECT_EQ(error_in_header("element vertex\n"),
              "3:1 E0701 `element vertex` expected how many `vertex` there are, found ``");
    EXPECT_EQ(error_in_header("element vertex -3\n"),
              "3:16 E0701 `-3` expected how many `vertex` there are, found `-3`");
    EXPECT_EQ(error_in_header("element vertex 3x\n"),
              "3:16 E0701 `3x` expected how many `vertex` there are, found `3x`");
    EXPECT_EQ(error_in_header("element vertex 18446744073709551616\n"),
              "3:16 E0701 `18446744073709551616` `18446744073709551616` rows are more than any "
              "file holds");
    EXPECT_EQ(error_in_header("element vertex 3 4\n"),
              "3:18 E0701 `4` expected the line to end, found `4`");
    EXPECT_EQ(error_in_header("element a 0\nelement a 0\n"),
              "4:9 E0701 `a` there is an element `a` already");
    EXPECT_EQ(error_in_header("property float x\n"),
              "3:1 E0701 `property float x` this property comes before any element");
}

TEST(ReadPlyMistakes, PropertiesOfTheHeader) {
    const auto error = [](std::string_view line) {
        return error_in_header(fmt::format("element a 0\n{}\n", line));
    };
    EXPECT_EQ(error("property vec3 x"),
              "4:10 E0701 `vec3` expected a type like `float` or `uchar`, found `vec3`");
    EXPECT_EQ(error("property list float int x"),
              "4:15 E0701 `float` how long a list is, is a whole number, not a `float`");
    EXPECT_EQ(error("property float"),
              "4:1 E0701 `property float` expected a line like `property float x`");
    EXPECT_EQ(error("property float x\nproperty int x"),
              "5:14 E0701 `x` there is a property `x` already");
    EXPECT_EQ(error("property float x y"), "4:18 E0701 `y` expected the line to end, found `y`");
}

TEST(ReadPlyMistakes, HeadersWithoutEnd) {
    std::string elements;
    for (int i = 0; i < 100; ++i) elements += fmt::format("element e{} 0\n", i);
    EXPECT_EQ(error_in_header(elements),
              "103:1 E0701 `end_header` this file has no element `vertex`");
    EXPECT_EQ(error_in_header(elements + "element vertex 0\n"),
              "103:9 E0705 `vertex` a file can have 100 elements; this is one more");
    std::string properties = "element vertex 0\n";
    for (int i = 0; i < 1000; ++i) properties += fmt::format("property int p{}\n", i);
    EXPECT_EQ(error_in_header(properties),
              "3:1 E0701 `element vertex 0` a vertex has the properties `x`, `y` and `z`; here is "
              "no `x`");
    EXPECT_EQ(error_in_header(properties + "property int x\n"),
              "1004:14 E0705 `x` a file can have 1000 properties; this is one more");
}

TEST(ReadPlyMistakes, FilesWithoutWhatAMeshNeeds) {
    EXPECT_EQ(error_in_header("element vertex 0\nproperty float x\nproperty float z\n"),
              "3:1 E0701 `element vertex 0` a vertex has the properties `x`, `y` and `z`; here is "
              "no `y`");
    EXPECT_EQ(error_in_header(fmt::format("element vertex 0\n{}", kXyz)),
              "7:1 E0704 `end_header` this file has points only: no element `face` or `tristrips`");
    EXPECT_EQ(error_in_header(fmt::format("element vertex 0\n{}element face 0\n"
                                          "property list uchar int vertex_indices\n",
                                          kXyz)),
              "7:1 E0704 `element face 0` this file has no faces");
    EXPECT_EQ(error_of(header("ascii", fmt::format("element vertex 0\n{}element face 1\n"
                                                   "property int vertex_indices\n",
                                                   kXyz)) +
                       "0\n"),
              "7:1 E0701 `element face 1` a face has a list `vertex_indices`; here is none");
    EXPECT_EQ(error_in_header(fmt::format("element vertex 0\n{}element face 0\n"
                                          "property list uchar float vertex_indices\n",
                                          kXyz)),
              "8:1 E0701 `property list uchar float vertex_indices` the numbers of vertices are "
              "whole: `int`, not `float`");
}

TEST(ReadPlyMistakes, CountsThatTheFileCannotHold) {
    EXPECT_EQ(error_of(header("binary_little_endian",
                              fmt::format("element vertex 4000000000\n{}", kXyz)) +
                       "0123456789"),
              "3:1 E0701 `element vertex 4000000000` 4000000000 rows of `vertex` take 12 bytes or "
              "more each, but the file has only 10 for them");
    EXPECT_EQ(error_of(header("ascii", fmt::format("element vertex 1\n{}element face "
                                                   "18446744073709551615\n"
                                                   "property list uchar int vertex_indices\n",
                                                   kXyz)) +
                       "0 0 0\n3 0 0 0"),
              "7:1 E0701 `element face 18446744073709551615` 18446744073709551615 rows of `face` "
              "take 2 bytes or more each, but the file has only 8 for them");
    // Rows without properties take nothing and end at once.
    EXPECT_EQ(mesh_of(header("ascii", fmt::format("element a 18446744073709551615\n"
                                                  "element vertex 3\n{}element face 1\n"
                                                  "property list uchar int vertex_indices\n",
                                                  kXyz)) +
                      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2")
                  .triangles.size(),
              1u);
}

TEST(ReadPlyMistakes, FacesInText) {
    EXPECT_EQ(error_of(ascii_face("3 0 1 3")), "13:7 E0702 `3` face 0 names vertex 3 of 3");
    EXPECT_EQ(error_of(ascii_face("3 0 -1 2")), "13:5 E0702 `-1` face 0 names vertex -1 of 3");
    EXPECT_EQ(error_of(ascii_face("3 0 1 99999999999")),
              "13:7 E0702 `99999999999` face 0 names vertex 99999999999 of 3");
    EXPECT_EQ(error_of(ascii_face("3 0 1 1.5")),
              "13:7 E0701 `1.5` expected a whole number, found `1.5`");
    EXPECT_EQ(error_of(ascii_face("3 0 1 1e30")),
              "13:7 E0701 `1e30` expected a whole number, found `1e30`");
    EXPECT_EQ(error_of(ascii_face("3 0 1 nan")),
              "13:7 E0701 `nan` expected a whole number, found `nan`");
    EXPECT_EQ(error_of(ascii_face(" 2 0 1")),
              "13:2 E0701 `2` a face needs at least 3 corners, this has 2");
    EXPECT_EQ(error_of(ascii_face("-3 0 1")),
              "13:1 E0701 `-3` a list `vertex_indices` of -3 values");
    EXPECT_EQ(error_of(ascii_face("1048577 0 1")),
              "13:1 E0705 `1048577` a face can have 1048576 corners, this has 1048577");
    EXPECT_EQ(error_of(ascii_face("4 0 1 2")),
              "13:1 E0701 `4 0 1 2` `face` 0 goes on, but its line has only 4 numbers");
    EXPECT_EQ(error_of(ascii_face("  ")), "14:1 E0701 `` the file ends before `face` 0 of 1");
}

TEST(ReadPlyMistakes, VerticesInText) {
    const auto error = [](std::string_view row) {
        return error_of(header("ascii", fmt::format("element vertex 3\n{}element face 0\n"
                                                    "property list uchar int vertex_indices\n",
                                                    kXyz)) +
                        fmt::format("0 0 0\n{}\n0 1.00 0\n", row));
    };
    EXPECT_EQ(error("1 zero 0"), "11:3 E0701 `zero` expected a number, found `zero`");
    EXPECT_EQ(error("1 2,5 0"), "11:3 E0701 `2,5` expected a number, found `2,5`");
    EXPECT_EQ(error("1 2"), "11:1 E0701 `1 2` `vertex` 1 goes on, but its line has only 2 numbers");
    EXPECT_EQ(error("1 nan 0"),
              "11:1 E0701 `1 nan 0` vertex 1 has a number that is not finite, or beyond 3.4e38");
    EXPECT_EQ(error("1 0 -1e39"),
              "11:1 E0701 `1 0 -1e39` vertex 1 has a number that is not finite, or beyond 3.4e38");
    // The header takes 154 bytes, the first row 6.
    EXPECT_EQ(error(std::string("1 \0 0", 5)),
              "E0003 this file says that it is text, but byte 162 of it is NUL");
    EXPECT_EQ(error("1 \x1b[2J 0"), "E0701 at byte 162: expected a number, found `\x1b[2J`");
}

/// A file in binary with three vertices and this behind them.
std::string binary_error(std::string_view lines, const Bytes& rows) {
    Bytes body(false);
    body.add_all(0.0f, 0, 0, 1, 0, 0, 0, 1, 0);
    return error_of(
        header("binary_little_endian", fmt::format("element vertex 3\n{}{}", kXyz, lines)) +
        body.text() + rows.text());
}

constexpr std::string_view kFaces = "element face 2\nproperty list uchar int vertex_indices\n";

TEST(ReadPlyMistakes, FacesInBinary) {
    // The header takes 169 bytes, the vertices 36, a triangle 13.
    const auto error = [](auto... corners) {
        Bytes rows(false);
        rows.add(std::uint8_t{3}).add_all(std::int32_t{0}, 1, 2);
        rows.add(static_cast<std::uint8_t>(sizeof...(corners))).add_all(std::int32_t{corners}...);
        return binary_error(kFaces, rows);
    };
    EXPECT_EQ(error(0, 1, 9999), "E0702 face 1, at byte 227, names vertex 9999 of 3");
    EXPECT_EQ(error(-1, 1, 2), "E0702 face 1, at byte 219, names vertex -1 of 3");
    EXPECT_EQ(error(0, 1, 2, 3), "E0702 face 1, at byte 231, names vertex 3 of 3");
    EXPECT_EQ(error(0, 1), "E0701 face 1, at byte 218, has 2 corners: it needs at least 3");
}

TEST(ReadPlyMistakes, ListsInBinary) {
    Bytes negative(false);
    negative.add_all(std::int32_t{-1}, 0, 0);
    EXPECT_EQ(binary_error("element face 1\nproperty list int int vertex_indices\n", negative),
              "E0701 `face` 0, at byte 203, has a list of -1 values");
    Bytes huge(false);
    huge.add_all(std::int32_t{0x7fffffff}, 0, 0);
    EXPECT_EQ(binary_error("element face 1\nproperty list uint int vertex_indices\n", huge),
              "E0701 `face` 0, at byte 204, has a list of 8589934588 bytes, but the file ends "
              "after 8");
    Bytes many(false);
    many.add(std::uint32_t{(1u << 20) + 1});
    for (std::uint32_t i = 0; i <= 1u << 20; ++i) many.add(std::uint8_t{0});
    EXPECT_EQ(binary_error("element face 1\nproperty list uint uchar vertex_indices\n", many),
              "E0705 face 0, at byte 206, has 1048577 corners; it can have 1048576");
    Bytes strip(false);
    strip.add_all(std::int32_t{4}, 0, 1, 2, -2);
    EXPECT_EQ(binary_error("element tristrips 1\nproperty list int int vertex_indices\n", strip),
              "E0702 strip 0, at byte 224, names vertex -2 of 3");
}

TEST(ReadPlyMistakes, VerticesInBinary) {
    Bytes body(true);
    body.add_all(0.0f, 0, 0, 1, 0, 0, 0, std::numeric_limits<float>::infinity(), 0);
    body.add_all(std::uint8_t{0}, 0);
    EXPECT_EQ(
        error_of(header("binary_big_endian", fmt::format("element vertex 3\n{}{}", kXyz, kFaces)) +
                 body.text()),
        "E0701 vertex 2, at byte 190, has a number that is not finite");
}

}  // namespace
}  // namespace lray::scene::ply
