// Files under several names, and the bundled library.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/file_access.h"
#include "tests/support/current_directory.h"
#include "tests/support/temp_directory.h"

namespace lray {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxSize = 1000;

class LibraryTest : public testing::TestWithParam<BeneathMethod> {
 protected:
    void SetUp() override {
        directory_.write("scenes/main.lrs", "main");
        directory_.write("scenes/metals.lrs", "of the scene");
        directory_.write("library/metals.lrs", "of the library");
        directory_.write("library/more/rare.lrs", "rare");
        directory_.write("outside.lrs", "outside");
        files_.set_library("library");
        ASSERT_EQ(files_.read_main("scenes/main.lrs", kMaxSize).status, ReadStatus::ok);
    }

    ReadResult read(std::string_view path, std::string_view from = "scenes") {
        return files_.read(path, from, kMaxSize);
    }

    test::TempDirectory directory_;
    test::CurrentDirectory current_{directory_.path()};
    FileAccess files_{GetParam()};
};

TEST_P(LibraryTest, NameWithPrefixIsOfTheLibraryAndOfNothingElse) {
    const ReadResult result = read("std:metals.lrs");
    ASSERT_EQ(result.status, ReadStatus::ok);
    EXPECT_EQ(result.text.view(), "of the library");
    EXPECT_EQ(result.path, "std:metals.lrs");
    EXPECT_TRUE(result.is_library);
    EXPECT_EQ(read("metals.lrs").text.view(), "of the scene");
    files_.allow("scenes", true);
    directory_.write("scenes/only.lrs", "only here");
    EXPECT_EQ(read("std:only.lrs").status, ReadStatus::not_found);
    EXPECT_EQ(read("rare.lrs").status, ReadStatus::not_found) << "it is not searched";
}

TEST_P(LibraryTest, FilesOfTheLibraryNameEachOther) {
    const ReadResult rare = read("std:more/rare.lrs");
    ASSERT_EQ(rare.status, ReadStatus::ok);
    const ReadResult metals = read("../metals.lrs", rare.directory);
    EXPECT_EQ(metals.text.view(), "of the library");
    EXPECT_EQ(metals.path, "std:metals.lrs");
    EXPECT_EQ(read("more/rare.lrs", metals.directory).text.view(), "rare");
    EXPECT_EQ(read("main.lrs", metals.directory).status, ReadStatus::not_found);
}

TEST_P(LibraryTest, NothingLeadsOutOfIt) {
    fs::create_symlink("../outside.lrs", directory_.path("library/link.lrs"));
    for (const char* path :
         {"std:../outside.lrs", "std:more/../../outside.lrs", "std:/etc/passwd", "std:link.lrs"}) {
        const ReadResult result = read(path);
        EXPECT_EQ(result.status, ReadStatus::not_found) << path;
        EXPECT_EQ(result.text.size(), 0u);
    }
    EXPECT_NE(read("std:").status, ReadStatus::ok);
    EXPECT_NE(read("std:more").status, ReadStatus::ok);
}

TEST_P(LibraryTest, MissingOneTellsWhatThereIs) {
    const ReadResult result = read("std:metal.lrs");
    EXPECT_EQ(result.status, ReadStatus::not_found);
    EXPECT_EQ(result.nearest, "std:metals.lrs");
    EXPECT_EQ(result.available, (std::vector<std::string>{"metals.lrs", "more"}));
    FileAccess without(GetParam());
    without.set_library("nowhere");
    EXPECT_EQ(without.read("std:metals.lrs", ".", kMaxSize).status, ReadStatus::not_found);
    EXPECT_TRUE(without.read("std:metals.lrs", ".", kMaxSize).available.empty());
}

TEST_P(LibraryTest, DirectoryOfThatNameIsNotTheLibrary) {
    directory_.write("std:/main.lrs", "main");
    directory_.write("std:/metals.lrs", "beside it");
    FileAccess files(GetParam());
    files.set_library("library");
    const ReadResult main = files.read_main("std:/main.lrs", kMaxSize);
    ASSERT_EQ(main.status, ReadStatus::ok);
    EXPECT_EQ(files.read("metals.lrs", main.directory, kMaxSize).text.view(), "beside it");
}

TEST_P(LibraryTest, FilesReadAreThoseOnTheDisk) {
    read("std:metals.lrs");
    read("std:./metals.lrs");
    ASSERT_EQ(files_.files_read().size(), 2u);
    EXPECT_EQ(files_.files_read()[0], "scenes/main.lrs");
    EXPECT_EQ(files_.files_read()[1], "library/metals.lrs");
}

TEST_P(LibraryTest, IdentityIsTheSameHoweverAFileIsNamed) {
    fs::create_symlink("metals.lrs", directory_.path("scenes/link.lrs"));
    fs::create_hard_link(directory_.path("scenes/metals.lrs"), directory_.path("scenes/hard.lrs"));
    directory_.write("scenes/copy.lrs", "of the scene");
    const std::string identity = read("metals.lrs").identity;
    EXPECT_FALSE(identity.empty());
    for (const char* path : {"./metals.lrs", "../scenes/metals.lrs", "link.lrs", "hard.lrs"}) {
        EXPECT_EQ(read(path).identity, identity) << path;
    }
    EXPECT_NE(read("copy.lrs").identity, identity);
    EXPECT_NE(read("std:metals.lrs").identity, identity);
    EXPECT_EQ(read("none.lrs").identity, "");
}

TEST_P(LibraryTest, KnownFilesAreFoundButNotReadAgain) {
    const std::string identity = read("metals.lrs").identity;
    const ReadResult again = files_.read("./metals.lrs", "scenes", 1, {identity});
    EXPECT_EQ(again.status, ReadStatus::ok) << "its size does not count again";
    EXPECT_EQ(again.identity, identity);
    EXPECT_EQ(again.text.size(), 0u);
    EXPECT_EQ(files_.read("./metals.lrs", "scenes", 1).status, ReadStatus::too_large);
}

std::vector<BeneathMethod> methods_here() {
    if (best_beneath_method() == BeneathMethod::walk) return {BeneathMethod::walk};
    return {BeneathMethod::kernel, BeneathMethod::walk};
}

INSTANTIATE_TEST_SUITE_P(Methods, LibraryTest, testing::ValuesIn(methods_here()),
                         [](const auto& one) {
                             return one.param == BeneathMethod::kernel ? "kernel" : "walk";
                         });

}  // namespace
}  // namespace lray
