// The program built without Assimp.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/lray_test.h"

namespace lray {
namespace {

class NoImportTest : public LrayTest {};

TEST_F(NoImportTest, MeshOfAnotherFormatIsAnErrorThatSaysWhy) {
    directory_.write("scene.lrs", std::string(kScene) + "mesh { file: \"roof.stl\" }\n");
    directory_.write("roof.stl", "solid roof\nendsolid roof\n");
    const auto result = run({"scene.lrs", "-o", "a.ppm"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(contains(result.err,
                         "scene.lrs:4:14: error[E0705]: `.stl` files are read by a program that "
                         "this lray was built without\n"))
        << result.err;
}

}  // namespace
}  // namespace lray
