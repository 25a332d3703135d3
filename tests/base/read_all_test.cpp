#include "base/read_all.h"

#include <fcntl.h>
#include <gtest/gtest.h>

#include <string>

#include "base/descriptor.h"
#include "tests/support/temp_directory.h"

namespace lray {
namespace {

class ReadAllTest : public testing::Test {
 protected:
    ReadAll read(std::uint64_t expected_size, std::uint64_t max_size) const {
        const Descriptor file(open(directory_.path("file").c_str(), O_RDONLY | O_CLOEXEC));
        return read_all(file.fd(), expected_size, max_size);
    }

    test::TempDirectory directory_;
    const std::string content_ = std::string(100'000, 'a') + std::string(200'000, 'b');
    const std::string path_ = directory_.write("file", content_);
};

TEST_F(ReadAllTest, AnotherSizeThanExpectedIsRead) {
    for (const std::uint64_t expected : {0, 1, 299'999, 300'000, 300'001}) {
        const ReadAll result = read(expected, 300'001);
        ASSERT_TRUE(result.text) << expected;
        EXPECT_TRUE(result.text->view() == content_) << expected;
    }
}

TEST_F(ReadAllTest, TheLimitIsInclusiveAndMayBeAnyNumber) {
    for (const std::uint64_t expected : {0, 1, 100'000}) {
        EXPECT_TRUE(read(expected, ~std::uint64_t{0}).text) << expected;
        EXPECT_TRUE(read(expected, 300'000).text) << expected;
        const ReadAll large = read(expected, 299'999);
        EXPECT_TRUE(large.is_too_large && !large.text) << expected;
    }
    EXPECT_TRUE(read(300'000, 299'999).is_too_large);
}

}  // namespace
}  // namespace lray
