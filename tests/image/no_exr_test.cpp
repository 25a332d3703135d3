// What reading says where lray is built without OpenEXR.
#include <gtest/gtest.h>

#include "image/exr.h"
#include "image/read.h"
#include "image/write.h"
#include "tests/image/pictures.h"

namespace lray::image {
namespace {

TEST(NoExr, ReadingSaysSoAndNothingIsWritten) {
    EXPECT_FALSE(is_built(Format::exr));
    EXPECT_TRUE(is_built(Format::pfm));
    std::string error;
    EXPECT_FALSE(read_pixels(test::bytes_of("\x76\x2f\x31\x01"), {}, error));
    EXPECT_EQ(error,
              "this lray was built without OpenEXR; save the picture as Radiance HDR or PFM");
}

}  // namespace
}  // namespace lray::image
