// The archive that is handed in: ./dev dist.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/process.h"
#include "tests/support/temp_directory.h"

namespace lray {
namespace {

namespace fs = std::filesystem;

/// A copy of the sources, as an archive unpacks them: without git, without what was built.
void copy_sources(const std::string& target) {
    for (const auto& entry : fs::directory_iterator(LRAY_SOURCE_DIR)) {
        const std::string name = entry.path().filename().string();
        if (name == ".git" || name.starts_with("build") || name.ends_with(".tar.gz")) continue;
        fs::copy(entry.path(), fs::path(target) / name, fs::copy_options::recursive);
    }
}

TEST(Dist, UnpacksIntoAFolderOfTheNameWhichIsReadyToBuild) {
    const test::TempDirectory directory;
    const std::string sources = directory.path("sources");
    fs::create_directory(sources);
    copy_sources(sources);
    directory.write("sources/build/leftover.o", "not to be handed in");
    const auto made = test::run_process({sources + "/dev", "dist", "curie_joliot"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_EQ(made.err, "");
    const std::string archive = sources + "/curie_joliot.tar.gz";
    const auto unpacked = test::run_process({"/bin/tar", "xzf", archive}, {}, directory.path());
    ASSERT_EQ(unpacked.exit_code, 0) << unpacked.err;
    EXPECT_EQ(directory.names(), (std::vector<std::string>{"curie_joliot", "sources"}));
    EXPECT_FALSE(fs::exists(directory.path("curie_joliot/build")));
    for (const char* name : {"README.md", "grammar.md", "CMakeLists.txt", "cli/main.cpp"}) {
        EXPECT_EQ(directory.read(std::string("curie_joliot/") + name),
                  test::read_bytes(std::string(LRAY_SOURCE_DIR "/") + name));
    }
    const auto configured = test::run_process(
        {LRAY_CMAKE, "-S", directory.path("curie_joliot"), "-B", directory.path("out")});
    EXPECT_EQ(configured.exit_code, 0) << configured.err;
}

TEST(Dist, NamesThatAreNoFolderAreRefused) {
    const std::string dev = LRAY_SOURCE_DIR "/dev";
    for (const char* name : {"", "a b", "../a", "-x", ".hidden", "a/b"}) {
        const auto result = test::run_process({dev, "dist", name});
        EXPECT_EQ(result.exit_code, 2) << name;
        EXPECT_NE(result.err.find("is no name for a folder"), std::string::npos) << result.err;
    }
    EXPECT_EQ(test::run_process({dev, "dist"}).exit_code, 2);
}

}  // namespace
}  // namespace lray
