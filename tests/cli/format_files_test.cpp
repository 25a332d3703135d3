// `lray --fmt` as people run it: what is written where, what is said, and that nothing is lost.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "tests/support/process.h"
#include "tests/support/temp_directory.h"

namespace lray {
namespace {

constexpr const char* kUntidy = "let a=1\nsphere{radius:a;center:[0,1,0]}\n";
constexpr const char* kTidy = "let a = 1\nsphere { radius: a, center: [0, 1, 0] }\n";
constexpr const char* kBroken = "sphere { radius: (1 }\n";

class FormatFiles : public testing::Test {
 protected:
    test::ProcessResult run(std::vector<std::string> arguments, std::string_view input = {}) {
        arguments.insert(arguments.begin(), {LRAY_BINARY, "--fmt"});
        return test::run_process(arguments, input, directory_.path());
    }

    test::TempDirectory directory_;
};

TEST_F(FormatFiles, RewritesInPlaceWhatChangesAndSaysSo) {
    directory_.write("a.lrs", kUntidy);
    directory_.write("b.lrs", kTidy);
    const std::filesystem::path b = std::filesystem::path(directory_.path()) / "b.lrs";
    const auto written_before = std::filesystem::last_write_time(b);
    const auto result = run({"a.lrs", "b.lrs"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "formatted a.lrs\n");
    EXPECT_EQ(directory_.read("a.lrs"), kTidy);
    EXPECT_EQ(std::filesystem::last_write_time(b), written_before);
    EXPECT_EQ(directory_.names(), (std::vector<std::string>{"a.lrs", "b.lrs"}));
    const auto again = run({"a.lrs", "b.lrs"});
    EXPECT_EQ(again.exit_code, 0);
    EXPECT_EQ(again.out + again.err, "");
}

TEST_F(FormatFiles, CheckListsAndWritesNothing) {
    directory_.write("a.lrs", kUntidy);
    directory_.write("b.lrs", kTidy);
    directory_.write("c.lrs", kUntidy);
    const auto result = run({"--check", "a.lrs", "b.lrs", "c.lrs"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(result.out, "a.lrs\nc.lrs\n");
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(directory_.read("a.lrs"), kUntidy);
    const auto tidy = run({"--check", "b.lrs"});
    EXPECT_EQ(tidy.exit_code, 0);
    EXPECT_EQ(tidy.out + tidy.err, "");
}

TEST_F(FormatFiles, WritesElsewhereWithO) {
    directory_.write("a.lrs", kUntidy);
    EXPECT_EQ(run({"a.lrs", "-o", "b.lrs"}).exit_code, 0);
    EXPECT_EQ(directory_.read("a.lrs"), kUntidy);
    EXPECT_EQ(directory_.read("b.lrs"), kTidy);
    const auto result = run({"b.lrs", "-o", "-"});
    EXPECT_EQ(result.out, kTidy) << "also when nothing changes";
    EXPECT_EQ(result.err, "");
}

TEST_F(FormatFiles, StdinGoesToStdout) {
    const auto result = run({"-"}, kUntidy);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.out, kTidy);
    EXPECT_EQ(result.err, "");
    const auto checked = run({"--check", "-"}, kUntidy);
    EXPECT_EQ(checked.exit_code, 1);
    EXPECT_EQ(checked.out, "<stdin>\n");
}

TEST_F(FormatFiles, NffIsNotFormatted) {
    directory_.write("a.nff", "s 0 0\n");
    const auto result = run({"a.nff"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("`a.nff` is NFF; only `.lrs` files are formatted"), std::string::npos)
        << result.err;
    EXPECT_EQ(directory_.read("a.nff"), "s 0 0\n");
}

TEST_F(FormatFiles, BrokenFilesAreLeftAloneAndTheOthersGoOn) {
    directory_.write("a.lrs", kBroken);
    directory_.write("b.lrs", kUntidy);
    const auto result = run({"a.lrs", "missing.lrs", "b.lrs"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("a.lrs:1:20: error[E0101]: expected `)` to close `(` at 1:18"),
              std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find("error[E0601]: `missing.lrs` not found"), std::string::npos);
    EXPECT_NE(result.err.find("1 error; nothing formatted\n"), std::string::npos);
    EXPECT_TRUE(result.err.ends_with("formatted b.lrs\n")) << result.err;
    EXPECT_EQ(directory_.read("a.lrs"), kBroken);
    EXPECT_EQ(directory_.read("b.lrs"), kTidy);
    const auto to_stdout = run({"-"}, kBroken);
    EXPECT_EQ(to_stdout.exit_code, 1);
    EXPECT_EQ(to_stdout.out, "");
    EXPECT_EQ(run({"--check", "a.lrs"}).exit_code, 1);
}

TEST_F(FormatFiles, LinksAndPermissionsSurvive) {
    directory_.write("a.lrs", kUntidy);
    const std::filesystem::path top = directory_.path();
    std::filesystem::permissions(top / "a.lrs", std::filesystem::perms(0640));
    std::filesystem::create_symlink("a.lrs", top / "link.lrs");
    EXPECT_EQ(run({"link.lrs"}).exit_code, 0);
    EXPECT_EQ(directory_.read("a.lrs"), kTidy);
    EXPECT_TRUE(std::filesystem::is_symlink(top / "link.lrs"));
    EXPECT_EQ(std::filesystem::status(top / "a.lrs").permissions(), std::filesystem::perms(0640));
}

TEST_F(FormatFiles, PipesHaveNoPlaceToBeRewritten) {
    ASSERT_EQ(mkfifo((std::filesystem::path(directory_.path()) / "pipe").c_str(), 0600), 0);
    const auto result = run({"pipe"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("`pipe` is no file that could be rewritten"), std::string::npos);
}

TEST_F(FormatFiles, OutputThatCannotBeWrittenIsTold) {
    directory_.write("a.lrs", kUntidy);
    const auto result = run({"a.lrs", "-o", "no/such/directory.lrs"});
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_EQ(directory_.read("a.lrs"), kUntidy);
}

TEST_F(FormatFiles, PictureOfAFormattedSceneIsTheSame) {
    directory_.write(
        "a.lrs",
        "camera{position:[0,0,5];look_at:[0,0,0]};render{resolution:[16,12]}\n"
        "let r=.5;sphere{ radius : r , material{ diffuse:#F0A ; } }box{translate:[-1.,0,0]}\n");
    const auto picture = [&] {
        return test::run_process({LRAY_BINARY, "-n", "1", "a.lrs", "-o", "-"}, {},
                                 directory_.path());
    };
    const auto before = picture();
    ASSERT_EQ(before.exit_code, 0) << before.err;
    EXPECT_EQ(run({"a.lrs"}).err, "formatted a.lrs\n");
    EXPECT_TRUE(picture().out == before.out);
}

}  // namespace
}  // namespace lray
