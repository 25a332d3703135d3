#include "base/path.h"
#include "tests/support/current_directory.h"
#include "tests/support/temp_directory.h"

#include <gtest/gtest.h>

namespace lray {
namespace {

TEST(Path, DirectoryAndFileName) {
    EXPECT_EQ(directory_of("a/b/c.lrs"), "a/b");
    EXPECT_EQ(directory_of("c.lrs"), ".");
    EXPECT_EQ(directory_of("/c.lrs"), "/");
    EXPECT_EQ(file_name_of("a/b/c.lrs"), "c.lrs");
    EXPECT_EQ(file_name_of("c.lrs"), "c.lrs");
    EXPECT_EQ(file_name_of("a/"), "");
}

TEST(Path, JoinedPathsAreTidy) {
    EXPECT_EQ(join_paths(".", "a.lrs"), "a.lrs");
    EXPECT_EQ(join_paths("", "a.lrs"), "a.lrs");
    EXPECT_EQ(join_paths("./scenes/", "./a.lrs"), "scenes/a.lrs");
    EXPECT_EQ(join_paths("scenes/parts", "../a.lrs"), "scenes/a.lrs");
    EXPECT_EQ(join_paths("scenes", "b//c/../a.lrs"), "scenes/b/a.lrs");
    EXPECT_EQ(join_paths("scenes", "../../a.lrs"), "../a.lrs");
    EXPECT_EQ(join_paths("scenes", ".."), ".");
    EXPECT_EQ(join_paths("/", "a.lrs"), "/a.lrs");
    EXPECT_EQ(join_paths("/scenes", "../../a.lrs"), "/a.lrs");
    EXPECT_EQ(join_paths("scenes", "/x/./a.lrs"), "/x/a.lrs");
}

TEST(Path, DirectoryKeepsItsOwnWayUp) {
    EXPECT_EQ(join_paths("link/../scenes", "a.lrs"), "link/../scenes/a.lrs");
    EXPECT_EQ(join_paths("..", "a.lrs"), "../a.lrs");
    EXPECT_EQ(join_paths("..", "../a.lrs"), "../../a.lrs");
}

TEST(Path, AbsolutePathStartsAtTheCurrentDirectory) {
    const test::TempDirectory directory;
    const test::CurrentDirectory current(directory.path());
    EXPECT_EQ(absolute_path("a.lrs"), directory.path("a.lrs"));
    EXPECT_EQ(absolute_path("x/../a.lrs"), directory.path("a.lrs"));
    EXPECT_EQ(absolute_path("."), directory.path());
    EXPECT_EQ(absolute_path("/x/../a"), "/a");
    EXPECT_EQ(absolute_path("/"), "/");
}

}  // namespace
}  // namespace lray
