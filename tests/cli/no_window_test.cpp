// What a program says that was built without the window.
#include "tests/cli/lray_test.h"

namespace lray {
namespace {

using NoWindow = LrayTest;

TEST_F(NoWindow, IsToldAndExits5) {
    directory_.write("scene.lrs", kScene);
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"scene.lrs"}, {"-n", "3", "-i", "scene.lrs"}}) {
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, 5);
        EXPECT_TRUE(contains(result.err, "built without the window")) << result.err;
        EXPECT_TRUE(contains(result.err, "-o image.png")) << result.err;
    }
}

}  // namespace
}  // namespace lray
