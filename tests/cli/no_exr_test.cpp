// What a program says that was built without OpenEXR.
#include "tests/cli/lray_test.h"

namespace lray {
namespace {

using NoExr = LrayTest;

TEST_F(NoExr, IsToldBeforeRenderingAndExits5) {
    directory_.write("scene.lrs", "this is no scene");  // is not looked at
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"scene.lrs", "-o", "a.exr"},
          {"scene.lrs", "-o", "-", "--format", "exr"}}) {
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, 5);
        EXPECT_TRUE(contains(result.err, "built without OpenEXR")) << result.err;
        EXPECT_TRUE(contains(result.err, "-o image.pfm")) << result.err;
    }
}

TEST_F(NoExr, ReadingIsToldToo) {
    directory_.write("sky.exr", "\x76\x2f\x31\x01");
    directory_.write("scene.lrs", "camera { }\nsphere { }\nenvironment { image: \"sky.exr\" }\n");
    const auto result = run({"--check", "scene.lrs"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(contains(result.err, "built without OpenEXR")) << result.err;
}

}  // namespace
}  // namespace lray
