// What FileAccess remembers of files that were not there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/file_access.h"
#include "tests/support/current_directory.h"
#include "tests/support/temp_directory.h"

namespace lray {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint64_t kMaxSize = 1000;

class FilesMissedTest : public testing::Test {
 protected:
    void SetUp() override {
        directory_.write("scenes/main.lrs", "main");
        directory_.write("scenes/part.lrs", "part");
        directory_.write("lib/common.lrs", "common");
        directory_.write("std/materials.lrs", "library");
        files_.allow("lib", true);
        files_.allow("more", true);
        files_.set_library("std");
        ASSERT_EQ(files_.read_main("scenes/main.lrs", kMaxSize).status, ReadStatus::ok);
    }

    ReadStatus read(std::string_view path) { return files_.read(path, "scenes", kMaxSize).status; }

    test::TempDirectory directory_;
    test::CurrentDirectory current_{directory_.path()};
    FileAccess files_;
};

TEST_F(FilesMissedTest, NoneIfAllAreThere) {
    EXPECT_EQ(read("part.lrs"), ReadStatus::ok);
    EXPECT_EQ(read("std:materials.lrs"), ReadStatus::ok);
    EXPECT_THAT(files_.files_missed(), IsEmpty());
}

TEST_F(FilesMissedTest, EveryPlaceInOrderAndOnce) {
    EXPECT_EQ(read("b.lrs"), ReadStatus::not_found);
    EXPECT_EQ(read("a/c.lrs"), ReadStatus::not_found);
    EXPECT_EQ(read("b.lrs"), ReadStatus::not_found);
    EXPECT_THAT(files_.files_missed(),
                ElementsAre("scenes/b.lrs", "lib/b.lrs", "more/b.lrs", "scenes/a/c.lrs",
                            "lib/a/c.lrs", "more/a/c.lrs"));
    EXPECT_THAT(files_.files_read(), ElementsAre("scenes/main.lrs"));
}

TEST_F(FilesMissedTest, PlacesBeforeTheOneWhereItIs) {
    EXPECT_EQ(read("common.lrs"), ReadStatus::ok);
    EXPECT_THAT(files_.files_missed(), ElementsAre("scenes/common.lrs"));
    // What appears there is what is read from then on.
    directory_.write(files_.files_missed()[0], "new");
    EXPECT_EQ(files_.read("common.lrs", "scenes", kMaxSize).text.view(), "new");
}

TEST_F(FilesMissedTest, ExactNameOfWhatWasFoundIgnoringCase) {
    EXPECT_EQ(read("Part.lrs"), ReadStatus::ok);
    EXPECT_THAT(files_.files_missed(),
                ElementsAre("scenes/Part.lrs", "lib/Part.lrs", "more/Part.lrs"));
}

TEST_F(FilesMissedTest, MainFileAndFilesOfTheLibraryToo) {
    EXPECT_EQ(read("std:woods/oak.lrs"), ReadStatus::not_found);
    EXPECT_EQ(files_.read_main("other.lrs", kMaxSize).status, ReadStatus::not_found);
    EXPECT_THAT(files_.files_missed(), ElementsAre("std/woods/oak.lrs", "other.lrs"));
}

TEST_F(FilesMissedTest, NoPlacesOutsideAndNothingThatIsNoFile) {
    EXPECT_EQ(read("../secret/key.lrs"), ReadStatus::outside);
    EXPECT_EQ(read("/nowhere/key.lrs"), ReadStatus::outside);
    std::filesystem::create_directory("scenes/directory.lrs");
    EXPECT_EQ(read("directory.lrs"), ReadStatus::not_regular);
    EXPECT_EQ(read(""), ReadStatus::not_found);
    EXPECT_THAT(files_.files_missed(), IsEmpty());
}

TEST_F(FilesMissedTest, AreBounded) {
    for (std::size_t i = 0; i <= FileAccess::kMaxFilesMissed; ++i) {
        static_cast<void>(read(std::to_string(i) + ".lrs"));
    }
    EXPECT_EQ(files_.files_missed().size(), FileAccess::kMaxFilesMissed);
    EXPECT_EQ(files_.files_missed().back(), "scenes/333.lrs");
}

}  // namespace
}  // namespace lray
