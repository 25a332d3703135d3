// Pictures as the bytes of a file, written by the writers themselves.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "image/write.h"
#include "tests/support/temp_directory.h"

namespace lray::test {

using Texts = std::vector<std::pair<std::string, std::string>>;

inline std::string written(const image::Image& picture, image::Format format,
                           const Texts& metadata = {}, const image::WriteSettings& settings = {},
                           image::Gamma gamma = image::Gamma::srgb) {
    const TempDirectory directory;
    std::string error;
    auto out = OutputFile::open(directory.path("a"), error);
    EXPECT_TRUE(out) << error;
    EXPECT_TRUE(image::write_image(*out, picture, format, gamma, metadata, error, settings))
        << error;
    EXPECT_TRUE(out->commit()) << out->error();
    return directory.read("a");
}

}  // namespace lray::test
