#include "gui/file_watch.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/descriptor.h"
#include "tests/support/current_directory.h"
#include "tests/support/temp_directory.h"

namespace lray::gui {
namespace {

namespace fs = std::filesystem;

/// A directory with a scene that is watched, and a clock.
class FileWatchTest : public testing::TestWithParam<WatchMethod> {
 protected:
    void SetUp() override {
        directory_.write("room.lrs", "scene");
        directory_.write("parts/chair.lrs", "chair");
    }

    void watch(const std::vector<std::string>& paths) {
        watch_.watch(paths);
        EXPECT_FALSE(reports()) << "before anything happened";
    }

    /// Lets a second pass; true if a change was reported, which is to be once.
    bool reports() {
        int count = 0;
        for (int i = 0; i < 100; ++i) {
            now_ += 0.01;
            if (watch_.poll(now_)) ++count;
        }
        EXPECT_LE(count, 1);
        return count > 0;
    }

    /// Writes a file as it stands. Another size each time: the clock of a file system may be
    /// coarse.
    void save(const std::string& name) { directory_.write(name, std::string(++saves_, 'x')); }

    test::TempDirectory directory_;
    test::CurrentDirectory current_{directory_.path()};
    FileWatch watch_{GetParam()};
    double now_ = 1000.0;
    std::size_t saves_ = 10;
};

TEST_P(FileWatchTest, WrittenInPlaceIsReported) {
    watch({"room.lrs", "parts/chair.lrs"});
    save("room.lrs");
    EXPECT_TRUE(reports());
    EXPECT_FALSE(reports());
    save("parts/chair.lrs");
    EXPECT_TRUE(reports());
    EXPECT_FALSE(reports());
}

TEST_P(FileWatchTest, TouchedIsReported) {
    watch({"room.lrs"});
    const timespec times[2] = {{1'000'000, 0}, {1'000'000, 0}};
    {
        const Descriptor file(::open("room.lrs", O_WRONLY | O_CLOEXEC));
        ASSERT_EQ(futimens(file.fd(), times), 0);
    }
    EXPECT_TRUE(reports());
}

TEST_P(FileWatchTest, RenamedOverIsReported) {
    watch({"room.lrs"});
    // As vim does: the old one to a backup, a new one under the name.
    save("4913");
    fs::remove("4913");
    fs::rename("room.lrs", "room.lrs~");
    save("room.lrs");
    fs::remove("room.lrs~");
    EXPECT_TRUE(reports());
    // As gedit and lray do: a temporary renamed over it.
    save(".goutputstream-X");
    fs::rename(".goutputstream-X", "room.lrs");
    EXPECT_TRUE(reports());
    // As emacs does: a lock as a dangling link, the old one to a backup.
    fs::create_symlink("user@host.1", ".#room.lrs");
    fs::rename("room.lrs", "room.lrs~");
    save("room.lrs");
    fs::remove(".#room.lrs");
    EXPECT_TRUE(reports());
    EXPECT_FALSE(reports());
}

TEST_P(FileWatchTest, DeletedIsReportedOnceItIsMadeAnew) {
    watch({"room.lrs"});
    fs::remove("room.lrs");
    EXPECT_FALSE(reports());
    save("room.lrs");
    EXPECT_TRUE(reports());
}

TEST_P(FileWatchTest, LinkedUnderTheNameIsReported) {
    save("other.lrs");
    watch({"room.lrs"});
    fs::remove("room.lrs");
    fs::create_hard_link("other.lrs", "room.lrs");
    EXPECT_TRUE(reports());
}

TEST_P(FileWatchTest, OtherNamesAreNot) {
    watch({"room.lrs"});
    for (const char* name : {".room.lrs.swp", "4913", "room.lrs~", "room.lr", "room.lrs.bak",
                             "room.lrsx", "parts/chair.lrs", "parts/room.lrs"}) {
        save(name);
    }
    fs::rename("4913", "4914");
    fs::create_directory("made");
    EXPECT_FALSE(reports());
}

TEST_P(FileWatchTest, ReadingIsNoChange) {
    watch({"room.lrs"});
    EXPECT_EQ(directory_.read("room.lrs"), "scene");
    { const std::fstream opened_for_writing("room.lrs", std::ios::in); }
    EXPECT_FALSE(reports());
}

TEST_P(FileWatchTest, WatchReplacesWhatWasWatched) {
    watch({"room.lrs"});
    watch({"parts/chair.lrs"});
    save("room.lrs");
    EXPECT_FALSE(reports());
    save("parts/chair.lrs");
    EXPECT_TRUE(reports());
    watch({});
    save("parts/chair.lrs");
    EXPECT_FALSE(reports());
    EXPECT_EQ(watch_.watch_count(), 0u);
}

TEST_P(FileWatchTest, ChangeWhileFilesAreReadAgainIsNotLost) {
    watch({"room.lrs"});
    save("room.lrs");
    ASSERT_TRUE(reports());
    save("room.lrs");  // while it is read
    watch_.watch(std::vector<std::string>{"room.lrs", "parts/chair.lrs"});
    EXPECT_TRUE(reports());
    EXPECT_FALSE(reports());
}

TEST_P(FileWatchTest, BehindLinksIsReported) {
    fs::create_directories("real/deep");
    directory_.write("real/deep/scene.lrs", "x");
    fs::create_symlink("real/middle.lrs", "link.lrs");
    fs::create_symlink("deep/scene.lrs", "real/middle.lrs");
    watch({"link.lrs"});
    save("real/deep/scene.lrs");
    EXPECT_TRUE(reports());
    // The link in the middle leads elsewhere.
    save("real/other.lrs");
    fs::create_symlink("other.lrs", "real/new");
    fs::rename("real/new", "real/middle.lrs");
    EXPECT_TRUE(reports());
    save("real/other.lrs");
    EXPECT_TRUE(reports());
    save("real/deep/scene.lrs");
    EXPECT_FALSE(reports());
}

TEST_P(FileWatchTest, LinkToADirectoryThatLeadsElsewhereIsReported) {
    directory_.write("models-1/a.obj", "one");
    directory_.write("models-2/a.obj", "second");
    fs::create_directory_symlink("models-1", "models");
    watch({"models/a.obj"});
    fs::create_directory_symlink("models-2", "new");
    fs::rename("new", "models");
    EXPECT_TRUE(reports());
    save("models-2/a.obj");
    EXPECT_TRUE(reports());
}

TEST_P(FileWatchTest, MissingFileIsReportedOnceItAppears) {
    watch({"room.lrs", "parts/new.lrs"});
    save("parts/new.lrs");
    EXPECT_TRUE(reports());
}

TEST_P(FileWatchTest, MissingDirectoriesAreWaitedFor) {
    watch({"a/b/c/new.lrs"});
    fs::create_directory("a");
    EXPECT_FALSE(reports());
    fs::create_directories("a/b/c");
    EXPECT_FALSE(reports());
    save("a/b/c/new.lrs");
    EXPECT_TRUE(reports());
}

TEST_P(FileWatchTest, MissingDirectoriesMadeAtOnceAreReported) {
    watch({"a/b/c/new.lrs"});
    save("a/b/c/new.lrs");
    EXPECT_TRUE(reports());
    save("a/b/c/new.lrs");
    EXPECT_TRUE(reports());
}

TEST_P(FileWatchTest, DanglingLinkToADirectoryIsWaitedFor) {
    fs::create_symlink("elsewhere/models", "models");
    watch({"models/a.obj"});
    save("elsewhere/models/a.obj");
    EXPECT_TRUE(reports());
}

TEST_P(FileWatchTest, ReplacedDirectoryIsWatchedAgain) {
    watch({"parts/chair.lrs"});
    fs::remove_all("parts");
    EXPECT_FALSE(reports());
    save("parts/chair.lrs");
    EXPECT_TRUE(reports());
    save("parts/chair.lrs");
    EXPECT_TRUE(reports());
}

TEST_P(FileWatchTest, MovedDirectoryIsWatchedWhereThePathLeads) {
    watch({"parts/chair.lrs"});
    fs::rename("parts", "old");
    EXPECT_FALSE(reports());
    save("old/chair.lrs");
    EXPECT_FALSE(reports());
    save("next/chair.lrs");
    fs::rename("next", "parts");
    EXPECT_TRUE(reports());
    save("parts/chair.lrs");
    EXPECT_TRUE(reports());
}

TEST_P(FileWatchTest, DirectoryMovedFurtherUpIsNoticed) {
    save("a/b/c/x.lrs");
    watch({"a/b/c/x.lrs"});
    save("other/b/c/x.lrs");
    fs::rename("a", "old");
    fs::rename("other", "a");
    EXPECT_TRUE(reports());
    save("a/b/c/x.lrs");
    EXPECT_TRUE(reports());
    save("old/b/c/x.lrs");
    EXPECT_FALSE(reports());
}

TEST_P(FileWatchTest, LinksInACircleAreNoHarm) {
    fs::create_symlink("b.lrs", "a.lrs");
    fs::create_symlink("a.lrs", "b.lrs");
    fs::create_symlink("loop", "loop");
    watch({"a.lrs", "loop/x.lrs", "", "/", "no/../../x.lrs", "room.lrs/x.lrs"});
    fs::remove("a.lrs");
    save("a.lrs");
    EXPECT_TRUE(reports());
}

INSTANTIATE_TEST_SUITE_P(Methods, FileWatchTest,
                         testing::Values(WatchMethod::notified, WatchMethod::comparing),
                         [](const auto& method) {
                             return method.param == WatchMethod::notified ? "Notified"
                                                                          : "Comparing";
                         });

/// What only inotify does.
class FileWatchNotified : public FileWatchTest {};
INSTANTIATE_TEST_SUITE_P(Inotify, FileWatchNotified, testing::Values(WatchMethod::notified));

TEST_P(FileWatchNotified, ChangeIsReportedAfterQuiet) {
    watch({"room.lrs"});
    const double begin = now_;
    save("room.lrs");
    EXPECT_FALSE(watch_.poll(begin));
    EXPECT_FALSE(watch_.poll(begin + 0.9 * FileWatch::kQuiet));
    EXPECT_TRUE(watch_.poll(begin + 1.01 * FileWatch::kQuiet));
    EXPECT_FALSE(watch_.poll(begin + 3.0 * FileWatch::kQuiet));
}

TEST_P(FileWatchNotified, FurtherChangesPutTheReportOff) {
    watch({"room.lrs"});
    const double begin = now_;
    for (int i = 0; i < 5; ++i) {
        save("room.lrs");
        EXPECT_FALSE(watch_.poll(begin + i * 0.8 * FileWatch::kQuiet)) << i;
    }
    EXPECT_FALSE(watch_.poll(begin + 4.1 * FileWatch::kQuiet));
    EXPECT_TRUE(watch_.poll(begin + 4.3 * FileWatch::kQuiet));
}

TEST_P(FileWatchNotified, SteadyStreamIsReportedAfterTheLongestTime) {
    watch({"room.lrs"});
    for (const bool is_by_renaming : {false, true}) {
        std::vector<double> reported;
        const double begin = now_;
        for (int i = 0; i < 110; ++i) {
            save(is_by_renaming ? "new" : "room.lrs");
            if (is_by_renaming) fs::rename("new", "room.lrs");
            now_ += 0.01;
            if (watch_.poll(now_)) reported.push_back(now_ - begin);
        }
        ASSERT_EQ(reported.size(), 2u);
        EXPECT_NEAR(reported[0], FileWatch::kLongest, FileWatch::kQuiet + 0.02);
        EXPECT_NEAR(reported[1], 2.0 * FileWatch::kLongest, 2.0 * (FileWatch::kQuiet + 0.02));
        EXPECT_TRUE(reports());
    }
}

TEST_P(FileWatchNotified, FileThatIsBeingFilledIsWaitedFor) {
    fs::remove("room.lrs");
    watch({"room.lrs"});
    std::ofstream slow("room.lrs");
    EXPECT_FALSE(reports());
    slow << "done";
    slow.close();
    EXPECT_TRUE(reports());
}

TEST_P(FileWatchNotified, FilesOfOneDirectoryShareAWatch) {
    std::vector<std::string> paths;
    for (int i = 0; i < 200; ++i) {
        paths.push_back(fmt::format("parts/{}.lrs", i));
        if (i % 2 == 0) save(paths.back());
    }
    paths.push_back(directory_.path("parts/0.lrs"));
    watch(paths);
    EXPECT_EQ(watch_.watch_count(), 1u);
    paths.push_back("room.lrs");
    watch(paths);
    EXPECT_EQ(watch_.watch_count(), 2u);
    save("parts/199.lrs");
    EXPECT_TRUE(reports());
    EXPECT_EQ(watch_.problem(), "");
}

TEST_P(FileWatchNotified, LostEventsCountAsAChange) {
    std::size_t queue_size = 0;
    std::ifstream("/proc/sys/fs/inotify/max_queued_events") >> queue_size;
    if (queue_size == 0 || queue_size > 100'000) GTEST_SKIP() << "queue of " << queue_size;
    watch({"room.lrs"});
    save("a");
    save("b");
    // Equal events one after the other are one.
    for (std::size_t i = 0; i <= queue_size; ++i) {
        const Descriptor file(::open(i % 2 == 0 ? "a" : "b", O_WRONLY | O_CLOEXEC));
    }
    EXPECT_TRUE(reports());
    EXPECT_FALSE(reports());
    save("room.lrs");
    EXPECT_TRUE(reports());
}

TEST_P(FileWatchNotified, DirectoriesBeyondTheLimitAreLookedAt) {
    std::vector<std::string> paths;
    for (std::size_t i = 0; i <= FileWatch::kMaxWatches; ++i) {
        paths.push_back(fmt::format("many/{:05}/x.lrs", i));
        save(paths.back());
    }
    const std::string last = paths.back();
    watch(paths);
    EXPECT_EQ(watch_.watch_count(), FileWatch::kMaxWatches);
    EXPECT_THAT(watch_.problem(), testing::HasSubstr("more than 1000 directories"));
    save(last);
    EXPECT_TRUE(reports());
    save(paths.front());
    EXPECT_TRUE(reports());
    paths.pop_back();
    watch(paths);
    EXPECT_EQ(watch_.problem(), "");
}

// UBSan looks at objects with a vptr through a pipe: meanwhile there must be none, as fmt's are.
TEST(FileWatch, WithoutDescriptorsLooksAtFiles) {
    const test::TempDirectory directory;
    const std::string path = directory.write("room.lrs", "scene");
    rlimit old{};
    ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &old), 0);
    rlimit none = old;
    none.rlim_cur = 0;
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
    FileWatch watch;
    watch.watch(std::vector<std::string>{path});
    const std::string problem = watch.problem();
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &old), 0);
    EXPECT_EQ(problem,
              "the system does not tell when files are saved (too many open files); they are "
              "looked at twice a second");
    EXPECT_FALSE(watch.poll(1.0));
    directory.write("room.lrs", "another scene");
    EXPECT_FALSE(watch.poll(1.0 + 0.9 * FileWatch::kPollPeriod));
    EXPECT_FALSE(watch.poll(1.0 + FileWatch::kPollPeriod));
    EXPECT_TRUE(watch.poll(1.0 + FileWatch::kPollPeriod + 1.01 * FileWatch::kQuiet));
    // Once it is there, it is used.
    watch.watch(std::vector<std::string>{path});
    EXPECT_EQ(watch.problem(), "");
    EXPECT_EQ(watch.watch_count(), 1u);
}

}  // namespace
}  // namespace lray::gui
