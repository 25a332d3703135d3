#include "base/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "base/descriptor.h"
#include "tests/support/current_directory.h"
#include "tests/support/temp_directory.h"

namespace lray {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

/// Opens, expecting success.
OutputFile open(const std::string& path) {
    std::string error;
    std::optional<OutputFile> file = OutputFile::open(path, error);
    EXPECT_TRUE(file) << error;
    if (!file) std::abort();
    return std::move(*file);
}

/// Opens, expecting failure, and returns its words.
std::string refusal(const std::string& path) {
    std::string error;
    EXPECT_FALSE(OutputFile::open(path, error));
    return error;
}

unsigned mode_of(const std::string& path) {
    struct stat status {};
    return stat(path.c_str(), &status) == 0 ? static_cast<unsigned>(status.st_mode) & 07777u : ~0u;
}

/// Returns the id of a process that has ended.
pid_t dead_process() {
    const pid_t child = fork();
    if (child == 0) _exit(0);
    int status = 0;
    waitpid(child, &status, 0);
    return child;
}

TEST(OutputFile, CommitPutsTheFileInPlace) {
    const test::TempDirectory directory;
    OutputFile file = open(directory.path("a.ppm"));
    EXPECT_EQ(directory.names().size(), 1u);
    EXPECT_TRUE(directory.names()[0].starts_with(".a.ppm.lray-tmp." + std::to_string(getpid())));
    EXPECT_TRUE(file.write("P6 "));
    EXPECT_TRUE(file.write(std::vector<std::byte>{std::byte{'1'}, std::byte{0}}));
    EXPECT_TRUE(file.commit());
    EXPECT_EQ(directory.names(), Names{"a.ppm"});
    EXPECT_EQ(directory.read("a.ppm"), std::string("P6 1\0", 5));
}

TEST(OutputFile, OldFileSurvivesWithoutCommit) {
    const test::TempDirectory directory;
    directory.write("a.ppm", "old");
    {
        OutputFile file = open(directory.path("a.ppm"));
        EXPECT_TRUE(file.write(std::string(1'000'000, 'x')));
        EXPECT_EQ(directory.read("a.ppm"), "old");
    }
    EXPECT_EQ(directory.read("a.ppm"), "old");
    EXPECT_EQ(directory.names(), Names{"a.ppm"});
}

TEST(OutputFile, SmallAndLargeWritesKeepTheirOrder) {
    const test::TempDirectory directory;
    std::string expected;
    {
        OutputFile file = open(directory.path("a"));
        for (std::size_t i = 0; i < 300; ++i) {
            const std::string part(i % 7 == 0 ? 70'000 : i, static_cast<char>('a' + i % 26));
            EXPECT_TRUE(file.write(part));
            expected += part;
        }
        EXPECT_TRUE(file.commit());
    }
    EXPECT_EQ(directory.read("a"), expected);
}

TEST(OutputFile, MovedFileCommitsOnce) {
    const test::TempDirectory directory;
    OutputFile first = open(directory.path("a"));
    OutputFile second = std::move(first);
    EXPECT_TRUE(second.write("x"));
    OutputFile third = open(directory.path("b"));
    third = std::move(second);  // what it held is given up
    EXPECT_TRUE(third.commit());
    EXPECT_EQ(directory.names(), Names{"a"});
}

TEST(OutputFile, PermissionsAreAsTheUmaskGivesOrTheOldFiles) {
    const test::TempDirectory directory;
    const mode_t old_mask = umask(027);
    EXPECT_TRUE(open(directory.path("new")).commit());
    EXPECT_EQ(mode_of(directory.path("new")), 0640u);
    directory.write("old", "");
    ASSERT_EQ(chmod((directory.path("old")).c_str(), 0606), 0);
    EXPECT_TRUE(open(directory.path("old")).commit());
    EXPECT_EQ(mode_of(directory.path("old")), 0606u);
    umask(old_mask);
}

TEST(OutputFile, LinkStaysAndItsTargetIsWritten) {
    const test::TempDirectory directory;
    directory.write("real/a.ppm", "old");
    fs::create_symlink("real/a.ppm", directory.path("link.ppm"));
    fs::create_symlink("link.ppm", directory.path("twice.ppm"));
    OutputFile file = open(directory.path("twice.ppm"));
    EXPECT_TRUE(file.write("new"));
    EXPECT_TRUE(file.commit());
    EXPECT_TRUE(fs::is_symlink(directory.path("link.ppm")));
    EXPECT_TRUE(fs::is_symlink(directory.path("twice.ppm")));
    EXPECT_EQ(directory.read("real/a.ppm"), "new");

    fs::create_symlink("real/b.ppm", directory.path("dangling.ppm"));
    EXPECT_TRUE(open(directory.path("dangling.ppm")).commit());
    EXPECT_TRUE(fs::is_symlink(directory.path("dangling.ppm")));
    EXPECT_TRUE(fs::is_regular_file(directory.path("real/b.ppm")));
}

TEST(OutputFile, CurrentDirectoryMayChangeBeforeCommit) {
    const test::TempDirectory directory;
    const test::CurrentDirectory outer(directory.path());
    OutputFile file = open("a.ppm");
    fs::create_directory("sub");
    const test::CurrentDirectory inner("sub");
    EXPECT_TRUE(file.commit());
    EXPECT_EQ(directory.names(), (Names{"a.ppm", "sub"}));
}

TEST(OutputFile, UnfitTargetIsRefusedAtOnceInWords) {
    const test::TempDirectory directory;
    const test::CurrentDirectory current(directory.path());
    fs::create_directory("sub");
    directory.write("file", "");
    EXPECT_EQ(refusal("none/a.ppm"), "cannot write `none/a.ppm`: there is no directory `none`");
    EXPECT_EQ(refusal("sub"), "cannot write `sub`: it is a directory");
    EXPECT_EQ(refusal("sub/"), "cannot write `sub/`: it is a directory");
    EXPECT_EQ(refusal("file/a.ppm"), "cannot write `file/a.ppm`: not a directory");
    EXPECT_EQ(refusal(""), "cannot write ``: this is no file name");
    const std::string long_name(300, 'x');
    EXPECT_EQ(refusal(long_name), "cannot write `" + long_name + "`: file name too long");
    EXPECT_EQ(directory.names(), (Names{"file", "sub"}));
}

TEST(OutputFile, LongestNameIsWritten) {
    const test::TempDirectory directory;
    const std::string name(255, 'x');
    EXPECT_TRUE(open(directory.path(name)).commit());
    EXPECT_EQ(directory.names(), Names{name});
}

TEST(OutputFile, PlaceWithoutPermissionIsRefused) {
    if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    const test::TempDirectory directory;
    directory.write("closed/a.ppm", "old");
    directory.write("b.ppm", "old");
    ASSERT_EQ(chmod((directory.path("b.ppm")).c_str(), 0400), 0);
    EXPECT_NE(refusal(directory.path("b.ppm")).find("permission denied"), std::string::npos);
    ASSERT_EQ(chmod((directory.path("closed")).c_str(), 0500), 0);
    EXPECT_NE(refusal(directory.path("closed/a.ppm")).find("permission denied"), std::string::npos);
    ASSERT_EQ(chmod((directory.path("closed")).c_str(), 0700), 0);
}

TEST(OutputFile, DirectoryThatTakesNoFilesIsRefused) {
    // /proc refuses new files even to root.
    if (!fs::is_directory("/proc/self")) GTEST_SKIP() << "no /proc here";
    const std::string error = refusal("/proc/a.ppm");
    EXPECT_TRUE(error.starts_with("cannot write `/proc/a.ppm`: directory `/proc`: ")) << error;
}

TEST(OutputFile, FullDiskIsToldInWords) {
    if (access("/dev/full", W_OK) != 0) GTEST_SKIP() << "no /dev/full here";
    OutputFile file = open("/dev/full");
    EXPECT_FALSE(file.write(std::string(100'000, 'x')));
    EXPECT_EQ(file.error(), "cannot write `/dev/full`: no space left on device");
    EXPECT_FALSE(file.write("x"));
    EXPECT_FALSE(file.commit());
    OutputFile late = open("/dev/full");
    EXPECT_TRUE(late.write("x"));  // still in the buffer
    EXPECT_FALSE(late.commit());
    EXPECT_EQ(late.error(), file.error());
}

TEST(OutputFile, FileSizeLimitKeepsTheOldFile) {
    const test::TempDirectory directory;
    directory.write("a.ppm", "old");
    // In a child, as the limit cannot be given back.
    const pid_t child = fork();
    if (child == 0) {
        signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{100'000, 100'000};
        setrlimit(RLIMIT_FSIZE, &limit);
        std::string error;
        auto file = OutputFile::open(directory.path("a.ppm"), error);
        const bool is_refused = file && !file->write(std::string(200'000, 'x')) &&
                                file->error().ends_with(": file too large") && !file->commit();
        _exit(is_refused && directory.names() == Names{"a.ppm"} ? 0 : 1);
    }
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(directory.read("a.ppm"), "old");
}

TEST(OutputFile, FifoIsWrittenDirectly) {
    const test::TempDirectory directory;
    const std::string path = directory.path("fifo");
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    std::string received;
    std::thread reader([&] { received = directory.read("fifo"); });
    {
        OutputFile file = open(path);
        EXPECT_TRUE(file.write("through the pipe"));
        EXPECT_TRUE(file.commit());
    }
    reader.join();
    EXPECT_EQ(received, "through the pipe");
    EXPECT_EQ(directory.names(), Names{"fifo"});
}

TEST(OutputFile, ReaderThatHasGoneAwayIsToldInWords) {
    const test::TempDirectory directory;
    const std::string path = directory.path("fifo");
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    const auto old_handler = signal(SIGPIPE, SIG_IGN);
    Descriptor reader(::open(path.c_str(), O_RDONLY | O_NONBLOCK));
    OutputFile file = open(path);
    reader.close();
    EXPECT_FALSE(file.write(std::string(100'000, 'x')));
    EXPECT_EQ(file.error(), "cannot write `" + path + "`: its reader has gone away");
    signal(SIGPIPE, old_handler);
}

/// Makes a file standard output while it lives.
class RedirectedStdout {
 public:
    explicit RedirectedStdout(const std::string& path) {
        const Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600));
        dup2(file.fd(), STDOUT_FILENO);
    }
    ~RedirectedStdout() { dup2(saved_.fd(), STDOUT_FILENO); }

 private:
    Descriptor saved_{dup(STDOUT_FILENO)};
};

TEST(OutputFile, StandardOutputIsWrittenAsItIs) {
    const test::TempDirectory directory;
    directory.write("out", "before ");
    {
        const RedirectedStdout redirected(directory.path("out"));
        for (const char* path : {"-", "/dev/stdout", "/dev/fd/1"}) {
            OutputFile file = open(path);
            EXPECT_TRUE(file.write("x"));
            EXPECT_TRUE(file.commit());
        }
        EXPECT_GE(fcntl(STDOUT_FILENO, F_GETFD), 0) << "standard output must stay open";
    }
    // Appended as the shell's >> asks for; neither replaced nor overwritten.
    EXPECT_EQ(directory.read("out"), "before xxx");
    EXPECT_EQ(directory.names(), Names{"out"});
}

TEST(OutputFile, TemporariesOfDeadProcessesAreSwept) {
    const test::TempDirectory directory;
    const std::string dead = std::to_string(dead_process());
    const std::string alive = std::to_string(getppid());
    directory.write(".a.ppm.lray-tmp." + dead + ".0", "stale");
    directory.write(".other.png.lray-tmp." + dead + ".12", "stale");
    const Names kept = {".a.ppm.lray-tmp." + alive + ".0",  // its process lives
                        ".a.ppm.lray-tmp." + dead,          // no name of ours
                        ".a.ppm.lray-tmp." + dead + ".x", ".lray-tmp.notes",
                        "a.ppm.lray-tmp." + dead + ".0"};
    for (const std::string& name : kept) directory.write(name, "kept");
    fs::create_directory(directory.path(".d.lray-tmp." + dead + ".0"));
    fs::create_symlink("a", directory.path(".l.lray-tmp." + dead + ".0"));
    EXPECT_TRUE(open(directory.path("a.ppm")).commit());
    Names expected = kept;
    expected.push_back("a.ppm");
    expected.push_back(".d.lray-tmp." + dead + ".0");
    expected.push_back(".l.lray-tmp." + dead + ".0");
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(directory.names(), expected);
}

TEST(OutputFile, LockedTemporaryIsInUseElsewhere) {
    const test::TempDirectory directory;
    const std::string name = ".a.ppm.lray-tmp." + std::to_string(dead_process()) + ".0";
    const Descriptor other(::open(directory.write(name, "in use").c_str(), O_RDONLY));
    ASSERT_EQ(flock(other.fd(), LOCK_EX), 0);
    EXPECT_TRUE(open(directory.path("a.ppm")).commit());
    EXPECT_EQ(directory.names(), (Names{name, "a.ppm"}));
}

TEST(OutputFile, TwoWritersOfOneTargetDoNotMeet) {
    const test::TempDirectory directory;
    OutputFile first = open(directory.path("a"));
    OutputFile second = open(directory.path("a"));
    EXPECT_TRUE(first.write("first"));
    EXPECT_TRUE(second.write("second"));
    EXPECT_TRUE(first.commit());
    EXPECT_EQ(directory.read("a"), "first");
    EXPECT_TRUE(second.commit());
    EXPECT_EQ(directory.read("a"), "second");
    EXPECT_EQ(directory.names(), Names{"a"});
}

}  // namespace
}  // namespace lray
