// Runs the program in a directory of the test's own.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "tests/support/process.h"
#include "tests/support/temp_directory.h"

namespace lray {

/// A sphere in the middle of 64 x 48 pixels, and a light.
inline constexpr const char* kScene =
    "render { resolution: [64, 48] }; point_light { position: [2, 5, 5] }\n"
    "camera { position: [0, 0, 5], look_at: [0, 0, 0] }\n"
    "sphere { radius: 1 }\n";

inline bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

class LrayTest : public testing::Test {
 protected:
    test::ProcessResult run(std::vector<std::string> arguments, std::string_view input = {});

    /// Reads a picture that the program wrote.
    image::Image picture(std::string_view name);

    test::TempDirectory directory_;
};

}  // namespace lray
