#include "tests/cli/lray_test.h"

#include <span>

#include "image/read.h"

namespace lray {

test::ProcessResult LrayTest::run(std::vector<std::string> arguments, std::string_view input) {
    arguments.insert(arguments.begin(), LRAY_BINARY);
    return test::run_process(arguments, input, directory_.path());
}

image::Image LrayTest::picture(std::string_view name) {
    const std::string bytes = directory_.read(name);
    std::string error;
    auto image = image::read_image(std::as_bytes(std::span(bytes)), {}, error);
    EXPECT_TRUE(image) << error;
    return image.value_or(image::Image{});
}

}  // namespace lray
