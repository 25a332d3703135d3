#include "base/file_access.h"
#include "tests/support/current_directory.h"
#include "tests/support/temp_directory.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace lray {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxSize = 1000;

/// A tree of files with scenes/ as the main file's directory, seen by both ways of opening.
class FileAccessTest : public testing::TestWithParam<BeneathMethod> {
 protected:
    void SetUp() override {
        directory_.write("scenes/main.lrs", "main");
        directory_.write("scenes/materials.lrs", "materials");
        directory_.write("scenes/parts/wheel.lrs", "wheel");
        directory_.write("scenes/parts/Bolt.lrs", "bolt");
        directory_.write("lib/std.lrs", "library");
        directory_.write("secret/key.lrs", "secret");
        ASSERT_EQ(files_.read_main("scenes/main.lrs", kMaxSize).status, ReadStatus::ok);
    }

    ReadResult read(std::string_view path, std::string_view from = "scenes") {
        return files_.read(path, from, kMaxSize);
    }

    test::TempDirectory directory_;
    test::CurrentDirectory current_{directory_.path()};
    FileAccess files_{GetParam()};
};

TEST_P(FileAccessTest, FileBesideTheMainFileIsRead) {
    const ReadResult result = read("materials.lrs");
    EXPECT_EQ(result.status, ReadStatus::ok);
    EXPECT_EQ(result.text.view(), "materials");
    EXPECT_EQ(result.path, "scenes/materials.lrs");
    EXPECT_EQ(result.directory, "scenes");
    EXPECT_FALSE(result.is_absolute || result.used_backslash || result.differs_in_case);
}

TEST_P(FileAccessTest, PathsAreRelativeToTheFileTheyAreWrittenIn) {
    const ReadResult wheel = read("./parts//wheel.lrs");
    EXPECT_EQ(wheel.path, "scenes/parts/wheel.lrs");
    EXPECT_EQ(wheel.directory, "scenes/parts");
    EXPECT_EQ(read("wheel.lrs", wheel.directory).text.view(), "wheel");
    const ReadResult up = read("../materials.lrs", wheel.directory);
    EXPECT_EQ(up.status, ReadStatus::ok);
    EXPECT_EQ(up.path, "scenes/materials.lrs");
}

TEST_P(FileAccessTest, MainInTheCurrentDirectoryShowsBareNames) {
    const test::CurrentDirectory scenes(directory_.path("scenes"));
    FileAccess files(GetParam());
    const ReadResult main = files.read_main("main.lrs", kMaxSize);
    EXPECT_EQ(main.path, "main.lrs");
    EXPECT_EQ(main.directory, ".");
    EXPECT_EQ(files.read("parts/wheel.lrs", main.directory, kMaxSize).path, "parts/wheel.lrs");
}

TEST_P(FileAccessTest, DirectoryOfTheMainFileMayLeadThroughALink) {
    // link/.. is elsewhere, not the current directory.
    fs::create_directory(directory_.path("elsewhere"));
    directory_.write("elsewhere/scenes/other.lrs", "other");
    fs::create_directory(directory_.path("elsewhere/deep"));
    fs::create_directory_symlink("elsewhere/deep", directory_.path("link"));
    directory_.write("elsewhere/scenes/main.lrs", "main elsewhere");
    FileAccess files(GetParam());
    const ReadResult main = files.read_main("link/../scenes/main.lrs", kMaxSize);
    EXPECT_EQ(main.text.view(), "main elsewhere");
    const ReadResult other = files.read("other.lrs", main.directory, kMaxSize);
    EXPECT_EQ(other.text.view(), "other");
    EXPECT_EQ(other.path, "link/../scenes/other.lrs");
}

TEST_P(FileAccessTest, WhatIsNotBelowAnAllowedDirectoryIsOutside) {
    for (const char* path : {"../secret/key.lrs", "parts/../../secret/key.lrs",
                             "../secret/none.lrs", "../../../../../../etc/passwd"}) {
        const ReadResult result = read(path);
        EXPECT_EQ(result.status, ReadStatus::outside) << path;
        EXPECT_EQ(result.text.size(), 0u);
        EXPECT_EQ(result.nearest, "");
    }
    EXPECT_EQ(read("/etc/passwd").status, ReadStatus::outside);
    EXPECT_EQ(read("/etc/passwd").allow, "/etc");
    const std::string allow = read("../secret/key.lrs").allow;
    ASSERT_FALSE(allow.empty());
    files_.allow(allow, false);
    EXPECT_EQ(read("../secret/key.lrs").text.view(), "secret");
    EXPECT_EQ(read("../secret/key.lrs").path, "secret/key.lrs");
}

TEST_P(FileAccessTest, PrefixOfANameIsNotItsDirectory) {
    directory_.write("scenes-private/key.lrs", "secret");
    EXPECT_EQ(read("../scenes-private/key.lrs").status, ReadStatus::outside);
}

TEST_P(FileAccessTest, LinkInsideIsFollowedLinkToOutsideIsNot) {
    fs::create_symlink("parts/wheel.lrs", directory_.path("scenes/inner.lrs"));
    fs::create_symlink("../secret/key.lrs", directory_.path("scenes/file.lrs"));
    fs::create_directory_symlink("../secret", directory_.path("scenes/dir"));
    fs::create_symlink("/proc/self/environ", directory_.path("scenes/proc.lrs"));
    EXPECT_EQ(read("inner.lrs").text.view(), "wheel");
    EXPECT_EQ(read("file.lrs").status, ReadStatus::outside);
    EXPECT_EQ(read("file.lrs").allow, directory_.path("secret"));
    EXPECT_EQ(read("dir/key.lrs").status, ReadStatus::outside);
    EXPECT_EQ(read("dir/kee.lrs").status, ReadStatus::outside);
    EXPECT_EQ(read("dir/kee.lrs").nearest, "");
    EXPECT_EQ(read("dir/KEY.lrs").status, ReadStatus::outside);
    EXPECT_EQ(read("proc.lrs").status, ReadStatus::outside);
}

TEST_P(FileAccessTest, LinkIntoAnotherAllowedDirectoryIsFollowed) {
    fs::create_symlink("../secret/key.lrs", directory_.path("scenes/file.lrs"));
    fs::create_symlink(directory_.path("scenes/parts/wheel.lrs"),
                       directory_.path("scenes/absolute.lrs"));
    EXPECT_EQ(read("absolute.lrs").text.view(), "wheel");
    files_.allow("secret", false);
    EXPECT_EQ(read("file.lrs").text.view(), "secret");
}

TEST_P(FileAccessTest, AbsolutePathBelowAnAllowedDirectoryIsToldApart) {
    const ReadResult result = read(directory_.path("scenes/materials.lrs"));
    EXPECT_EQ(result.status, ReadStatus::ok);
    EXPECT_TRUE(result.is_absolute);
}

TEST_P(FileAccessTest, SearchedDirectoriesComeAfterTheFilesOwn) {
    EXPECT_EQ(read("std.lrs").status, ReadStatus::not_found);
    files_.allow("lib", true);
    const ReadResult library = read("std.lrs");
    EXPECT_EQ(library.text.view(), "library");
    EXPECT_EQ(library.path, "lib/std.lrs");
    EXPECT_EQ(library.directory, "lib");
    EXPECT_EQ(library.searched, (std::vector<std::string>{"scenes/std.lrs", "lib/std.lrs"}));
    directory_.write("scenes/std.lrs", "own");
    EXPECT_EQ(read("std.lrs").text.view(), "own");
}

TEST_P(FileAccessTest, AllowedIsNotSearched) {
    files_.allow("lib", false);
    EXPECT_EQ(read("std.lrs").status, ReadStatus::not_found);
    EXPECT_EQ(read("../lib/std.lrs").status, ReadStatus::ok);
}

TEST_P(FileAccessTest, DirectoriesAreSearchedForSoManyMissingFilesOnly) {
    for (std::size_t i = 0; i < FileAccess::kMaxSearches; ++i) {
        EXPECT_EQ(read("parts/weel.lrs").nearest, "parts/wheel.lrs");
    }
    EXPECT_EQ(read("parts/weel.lrs").nearest, "");
    EXPECT_EQ(read("parts/weel.lrs").status, ReadStatus::not_found);
    EXPECT_EQ(read("parts/wheel.lrs").status, ReadStatus::ok);
}

TEST_P(FileAccessTest, MissingFileTellsPlacesAndTheNearestName) {
    files_.allow("lib", true);
    files_.allow("no-such-directory", true);
    const ReadResult result = read("parts/weel.lrs");
    EXPECT_EQ(result.status, ReadStatus::not_found);
    EXPECT_EQ(result.path, "scenes/parts/weel.lrs");
    EXPECT_EQ(result.nearest, "parts/wheel.lrs");
    EXPECT_EQ(result.searched,
              (std::vector<std::string>{"scenes/parts/weel.lrs", "lib/parts/weel.lrs",
                                        "no-such-directory/parts/weel.lrs"}));
    EXPECT_EQ(read("nothing-like-it.png").nearest, "");
    EXPECT_EQ(read("").status, ReadStatus::not_found);
    EXPECT_EQ(read(std::string_view("materials.lrs\0.png", 18)).status, ReadStatus::not_found);
}

TEST_P(FileAccessTest, FileFoundByIgnoringCaseIsReadUnderItsRealName) {
    const ReadResult result = read("Parts/bolt.LRS");
    EXPECT_EQ(result.status, ReadStatus::ok);
    EXPECT_TRUE(result.differs_in_case);
    EXPECT_EQ(result.text.view(), "bolt");
    EXPECT_EQ(result.path, "scenes/parts/Bolt.lrs");
    EXPECT_EQ(result.directory, "scenes/parts");
    directory_.write("scenes/parts/bolt.lrs", "exact");
    EXPECT_EQ(read("parts/bolt.lrs").text.view(), "exact");
    EXPECT_FALSE(read("parts/bolt.lrs").differs_in_case);
}

TEST_P(FileAccessTest, BackslashIsReadAsASlash) {
    const ReadResult result = read("parts\\wheel.lrs");
    EXPECT_EQ(result.status, ReadStatus::ok);
    EXPECT_TRUE(result.used_backslash);
    EXPECT_EQ(result.path, "scenes/parts/wheel.lrs");
    EXPECT_EQ(read("..\\secret\\key.lrs").status, ReadStatus::outside);
}

TEST_P(FileAccessTest, OnlyRegularFilesAreRead) {
    EXPECT_EQ(read("parts").status, ReadStatus::not_regular);
    EXPECT_EQ(read(".").status, ReadStatus::not_regular);
    ASSERT_EQ(mkfifo((directory_.path("scenes/fifo")).c_str(), 0600), 0);
    EXPECT_EQ(read("fifo").status, ReadStatus::not_regular);  // and does not wait for a writer
    const test::CurrentDirectory scenes(directory_.path("scenes"));
    const Descriptor socket(::socket(AF_UNIX, SOCK_STREAM, 0));
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strcpy(address.sun_path, "socket");
    ASSERT_EQ(::bind(socket.fd(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(files_.read("socket", ".", kMaxSize).status, ReadStatus::not_regular);
    files_.allow("/dev", false);
    EXPECT_EQ(files_.read("/dev/zero", ".", kMaxSize).status, ReadStatus::not_regular);
}

TEST_P(FileAccessTest, SizeIsBoundedBeforeAnythingIsReserved) {
    directory_.write("scenes/fits.lrs", std::string(kMaxSize, 'x'));
    directory_.write("scenes/large.lrs", std::string(kMaxSize + 1, 'x'));
    EXPECT_EQ(read("fits.lrs").text.size(), kMaxSize);
    EXPECT_EQ(read("large.lrs").status, ReadStatus::too_large);
    EXPECT_EQ(read("large.lrs").text.size(), 0u);
    // A hole of 8 TiB takes no space on the disk; it must take none in memory.
    directory_.write("scenes/hole.lrs", "");
    ASSERT_EQ(truncate((directory_.path("scenes/hole.lrs")).c_str(), off_t{1} << 43), 0);
    EXPECT_EQ(read("hole.lrs").status, ReadStatus::too_large);
    EXPECT_EQ(files_.read("hole.lrs", "scenes", ~std::uint64_t{0}).status, ReadStatus::too_large);
}

TEST_P(FileAccessTest, NameTooLongIsUnreadableInWords) {
    const ReadResult result = read(std::string(300, 'x'));
    EXPECT_EQ(result.status, ReadStatus::unreadable);
    EXPECT_EQ(result.reason, "file name too long");
}

TEST_P(FileAccessTest, FileWithoutPermissionIsUnreadable) {
    if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
    ASSERT_EQ(chmod((directory_.path("scenes/materials.lrs")).c_str(), 0), 0);
    EXPECT_EQ(read("materials.lrs").status, ReadStatus::unreadable);
    EXPECT_EQ(read("materials.lrs").reason, "permission denied");
}

TEST_P(FileAccessTest, FileThatChangesWhileReadGivesSomeOfItsStates) {
    const std::string path = directory_.path("scenes/changing.lrs");
    constexpr std::size_t kSize = 1 << 20;
    directory_.write("scenes/changing.lrs", std::string(kSize, 'x'));
    std::atomic<bool> is_done{false};
    std::thread changer([&] {
        while (!is_done) {
            static_cast<void>(::truncate(path.c_str(), 10) == 0);
            static_cast<void>(::truncate(path.c_str(), 2 * kSize) == 0);
        }
    });
    for (int i = 0; i < 200; ++i) {
        const ReadResult result = files_.read("changing.lrs", "scenes", 4 * kSize);
        EXPECT_EQ(result.status, ReadStatus::ok);
        EXPECT_LE(result.text.size(), 2 * kSize);
        EXPECT_EQ(result.text.data()[result.text.size()], '\0');
    }
    is_done = true;
    changer.join();
}

TEST_P(FileAccessTest, FilesReadAreListedOnceInOrder) {
    read("materials.lrs");
    read("parts/wheel.lrs");
    read("./materials.lrs");
    read("none.lrs");
    EXPECT_EQ(std::vector<std::string>(files_.files_read().begin(), files_.files_read().end()),
              (std::vector<std::string>{"scenes/main.lrs", "scenes/materials.lrs",
                                        "scenes/parts/wheel.lrs"}));
}

TEST_P(FileAccessTest, MainFileMayBeAnywhere) {
    const std::string path = directory_.path("scenes/../secret/key.lrs");
    const ReadResult result = FileAccess(GetParam()).read_main(path, kMaxSize);
    EXPECT_EQ(result.status, ReadStatus::ok);
    EXPECT_EQ(result.path, path);  // as the user gave it
    EXPECT_FALSE(result.is_absolute);
}

TEST_P(FileAccessTest, MainFileMissingOrUnfitIsToldSo) {
    FileAccess files(GetParam());
    const ReadResult missing = files.read_main("scenes/mian.lrs", kMaxSize);
    EXPECT_EQ(missing.status, ReadStatus::not_found);
    EXPECT_EQ(missing.nearest, "scenes/main.lrs");
    EXPECT_EQ(files.read_main("scenes", kMaxSize).status, ReadStatus::not_regular);
    EXPECT_EQ(files.read_main("scenes/main.lrs", 3).status, ReadStatus::too_large);
    EXPECT_EQ(files.read_main("/dev/zero", kMaxSize).status, ReadStatus::too_large);
    EXPECT_EQ(files.read_main("", kMaxSize).status, ReadStatus::not_found);
    EXPECT_TRUE(files.files_read().empty());
}

TEST_P(FileAccessTest, MainFileMayBeAFifo) {
    const std::string path = directory_.path("fifo");
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    const std::string content(700, 'x');
    std::thread writer([&] { std::ofstream(path) << content; });
    FileAccess files(GetParam());
    const ReadResult result = files.read_main(path, kMaxSize);
    writer.join();
    EXPECT_EQ(result.status, ReadStatus::ok);
    EXPECT_EQ(result.text.view(), content);
    EXPECT_EQ(result.directory, ".");  // what it includes is looked for in the current directory
    EXPECT_EQ(files.read("scenes/materials.lrs", ".", kMaxSize).status, ReadStatus::ok);
}

TEST_P(FileAccessTest, MainFileMayBeStandardInput) {
    int ends[2] = {-1, -1};
    ASSERT_EQ(pipe(ends), 0);
    const Descriptor saved(dup(STDIN_FILENO));
    ASSERT_EQ(dup2(ends[0], STDIN_FILENO), STDIN_FILENO);
    Descriptor(ends[0]).close();
    // More than a pipe holds, so that the reader must go on reading.
    const std::string content(200'000, 'x');
    std::thread writer([&] {
        Descriptor end(ends[1]);
        std::size_t done = 0;
        while (done < content.size()) {
            const ssize_t count = ::write(end.fd(), content.data() + done, content.size() - done);
            if (count <= 0) break;
            done += static_cast<std::size_t>(count);
        }
    });
    FileAccess files(GetParam());
    const ReadResult result = files.read_main("-", content.size());
    writer.join();
    dup2(saved.fd(), STDIN_FILENO);
    EXPECT_EQ(result.status, ReadStatus::ok);
    EXPECT_EQ(result.path, "<stdin>");
    EXPECT_EQ(result.directory, ".");
    EXPECT_EQ(result.text.view(), content);
    EXPECT_TRUE(files.files_read().empty());
}

std::vector<BeneathMethod> methods_here() {
    if (best_beneath_method() == BeneathMethod::walk) return {BeneathMethod::walk};
    return {BeneathMethod::kernel, BeneathMethod::walk};
}

INSTANTIATE_TEST_SUITE_P(Methods, FileAccessTest, testing::ValuesIn(methods_here()),
                         [](const auto& method) {
                             return method.param == BeneathMethod::kernel ? "Kernel" : "Walk";
                         });

}  // namespace
}  // namespace lray
