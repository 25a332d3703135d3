#include "base/open_beneath.h"
#include "tests/support/temp_directory.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <string>

namespace lray {
namespace {

namespace fs = std::filesystem;

/// The same expectations for the kernel's way and for ours.
class OpenBeneath : public testing::TestWithParam<BeneathMethod> {
 protected:
    void SetUp() override {
        if (GetParam() == BeneathMethod::kernel && best_beneath_method() != BeneathMethod::kernel) {
            GTEST_SKIP() << "this kernel has no openat2";
        }
        directory_.write("root/a.txt", "inside");
        directory_.write("root/sub/b.txt", "below");
        directory_.write("secret.txt", "secret");
        root_ = Descriptor(::open((directory_.path("root")).c_str(), O_PATH | O_DIRECTORY));
        ASSERT_TRUE(root_.is_open());
    }

    /// Returns the content of the file, or "errno <n>".
    std::string read(const std::string& path) const {
        const OpenedBeneath opened =
            open_beneath(root_.fd(), path, O_RDONLY | O_NONBLOCK, GetParam());
        if (!opened.file.is_open()) return "errno " + std::to_string(opened.error);
        std::array<char, 64> buffer{};
        const ssize_t length = ::read(opened.file.fd(), buffer.data(), buffer.size());
        if (length < 0) return "unread " + std::to_string(errno);
        return {buffer.data(), static_cast<std::size_t>(length)};
    }

    void link(const std::string& target, std::string_view name) const {
        fs::create_symlink(target, directory_.path(name));
    }

    static std::string error(int number) { return "errno " + std::to_string(number); }

    test::TempDirectory directory_;
    Descriptor root_;
};

TEST_P(OpenBeneath, FilesBelowAreOpened) {
    EXPECT_EQ(read("a.txt"), "inside");
    EXPECT_EQ(read("sub/b.txt"), "below");
    EXPECT_EQ(read("./sub//b.txt"), "below");
    EXPECT_EQ(read("sub/../a.txt"), "inside");
    EXPECT_EQ(read("."), "unread " + std::to_string(EISDIR));
}

TEST_P(OpenBeneath, TheWayUpLeadsOutside) {
    EXPECT_EQ(read("../secret.txt"), error(EXDEV));
    EXPECT_EQ(read("sub/../../secret.txt"), error(EXDEV));
    EXPECT_EQ(read("../root/a.txt"), error(EXDEV));
    EXPECT_EQ(read(".."), error(EXDEV));
    EXPECT_EQ(read("/etc/passwd"), error(EXDEV));
}

TEST_P(OpenBeneath, LinksInsideAreFollowed) {
    link("a.txt", "root/file");
    link("sub", "root/dir");
    link("../a.txt", "root/sub/up");
    link("file", "root/twice");
    EXPECT_EQ(read("file"), "inside");
    EXPECT_EQ(read("dir/b.txt"), "below");
    EXPECT_EQ(read("dir/up"), "inside");
    EXPECT_EQ(read("twice"), "inside");
    EXPECT_EQ(read("dir/.."), "unread " + std::to_string(EISDIR));
}

TEST_P(OpenBeneath, LinksThatLeaveLeadOutside) {
    link("../secret.txt", "root/file");
    link("..", "root/dir");
    link("../../secret.txt", "root/sub/far");
    link((directory_.path("secret.txt")), "root/absolute");
    link((directory_.path("root/a.txt")), "root/absolute_inside");
    link("../nothing", "root/dangling");
    link("/proc/self/fd/0", "root/magic");
    EXPECT_EQ(read("file"), error(EXDEV));
    EXPECT_EQ(read("dir/secret.txt"), error(EXDEV));
    EXPECT_EQ(read("dir/root/a.txt"), error(EXDEV));
    EXPECT_EQ(read("sub/far"), error(EXDEV));
    EXPECT_EQ(read("absolute"), error(EXDEV));
    EXPECT_EQ(read("absolute_inside"), error(EXDEV));
    EXPECT_EQ(read("dangling"), error(EXDEV));  // not even whether it exists is told
    EXPECT_EQ(read("magic"), error(EXDEV));
}

TEST_P(OpenBeneath, EndlessLinksEnd) {
    link("loop", "root/loop");
    link("pong", "root/ping");
    link("ping", "root/pong");
    EXPECT_EQ(read("loop"), error(ELOOP));
    EXPECT_EQ(read("ping"), error(ELOOP));
}

TEST_P(OpenBeneath, MissingFilesAreMissing) {
    EXPECT_EQ(read("none.txt"), error(ENOENT));
    EXPECT_EQ(read("none/a.txt"), error(ENOENT));
    EXPECT_EQ(read("a.txt/b.txt"), error(ENOTDIR));
    EXPECT_EQ(read(std::string(300, 'x')), error(ENAMETOOLONG));
}

TEST_P(OpenBeneath, FifoDoesNotBlock) {
    ASSERT_EQ(mkfifo((directory_.path("root/fifo")).c_str(), 0600), 0);
    EXPECT_EQ(read("fifo"), "");
}

INSTANTIATE_TEST_SUITE_P(Methods, OpenBeneath,
                         testing::Values(BeneathMethod::kernel, BeneathMethod::walk),
                         [](const auto& method) {
                             return method.param == BeneathMethod::kernel ? "Kernel" : "Walk";
                         });

}  // namespace
}  // namespace lray
