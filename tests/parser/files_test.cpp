// Files under several names, the bundled library, and fixes that mend what they are offered for.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/parser/loaded.h"

namespace lray::test {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr std::string_view kCamera = "camera { position: [0, 0, 5] }\n";

Loaded load_in(const TempDirectory& directory, const parser::LoadLimits& limits = {}) {
    return load_file(directory.path("main.lrs"), with_limits(limits));
}

TEST(Files, OneMeshUnderManyNamesIsReadOnce) {
    const TempDirectory directory;
    directory.write("m.obj", kTriangle);
    directory.write("parts/part.lrs", "mesh { file: \"../m.obj\" }\n");
    fs::create_symlink("m.obj", directory.path("link.obj"));
    directory.write("main.lrs", std::string(kCamera) +
                                    "mesh { file: \"m.obj\" }\nmesh { file: \"./m.obj\" }\n"
                                    "mesh { file: \"parts/../m.obj\" }\n"
                                    "mesh { file: \"link.obj\" }\ninclude \"parts/part.lrs\"\n");
    parser::LoadLimits limits;
    limits.mesh_bytes = kTriangle.size();  // no more than once
    const Loaded loaded = load_in(directory, limits);
    ASSERT_TRUE(loaded.scene) << loaded.text();
    EXPECT_EQ(loaded.codes(), "");
    EXPECT_EQ(loaded.scene->meshes.size(), 1u);
    EXPECT_EQ(loaded.scene->groups[loaded.scene->node(loaded.scene->root).index].children.size(),
              5u);
}

TEST(Files, MistakesOfAMeshAreToldOnceHoweverItIsNamed) {
    const TempDirectory directory;
    directory.write("m.obj", "v 0 0 0\nf 1 2 3\n");
    directory.write("main.lrs", "mesh { file: \"m.obj\" }\nmesh { file: \"./m.obj\" }\n");
    EXPECT_EQ(load_in(directory).codes(), "E0702");
}

TEST(Files, CycleThroughAnotherNameIsACycle) {
    for (const bool is_link : {false, true}) {
        const TempDirectory directory;
        directory.write("parts/a.lrs", "sphere { }\n");
        if (is_link) {
            fs::create_symlink("main.lrs", directory.path("again.lrs"));
            directory.write("main.lrs", "include \"again.lrs\"\n");
        } else {
            fs::create_hard_link(directory.write("main.lrs", "include \"again.lrs\"\n"),
                                 directory.path("again.lrs"));
        }
        const Loaded loaded = load_in(directory);
        EXPECT_EQ(loaded.codes(), "E0602") << is_link;
        EXPECT_EQ(loaded.sources.count(), 2u) << "found at once";
    }
}

TEST(Files, LibraryLoadsAndIsCalledByItsName) {
    const TempDirectory directory;
    for (const auto& entry : fs::directory_iterator(LRAY_SOURCE_DIR "/parser/std")) {
        const std::string name = fmt::format("std:{}", entry.path().filename().string());
        directory.write("main.lrs", fmt::format("{}include \"{}\"\nsphere {{ }}\n", kCamera, name));
        const Loaded loaded = load_in(directory);
        EXPECT_EQ(loaded.codes(), "") << name << "\n" << loaded.text();
        EXPECT_EQ(loaded.sources[1].path, name);
    }
    directory.write(
        "main.lrs",
        std::string(kCamera) +
            "include \"std:materials.lrs\"\nsphere { material: gold { shininess: 7 } }\n");
    EXPECT_EQ(load_in(directory).codes(), "");
}

TEST(Files, WhatTheLibraryLacksIsSaidWithWhatItHas) {
    const TempDirectory directory;
    directory.write("materal.lrs", "sphere { }");
    directory.write("main.lrs", "include \"std:materal.lrs\"\n");
    const Loaded loaded = load_in(directory);
    EXPECT_EQ(loaded.text(), "E0601 1:9 `std:materal.lrs` not found in the bundled library\n");
    const Diagnostic& diagnostic = *loaded.diagnostics.sorted().front();
    ASSERT_EQ(diagnostic.notes.size(), 1u);
    EXPECT_TRUE(diagnostic.notes[0].starts_with("the library has std:")) << diagnostic.notes[0];
    EXPECT_NE(diagnostic.notes[0].find("std:materials.lrs"), std::string::npos);
    EXPECT_EQ(diagnostic.hint, "did you mean `std:materials.lrs`?");

    Loaded without;
    FileAccess files;
    parser::load(directory.path("main.lrs"), {}, files, without.sources, without.diagnostics);
    ASSERT_EQ(without.codes(), "E0601");
    EXPECT_EQ(without.diagnostics.sorted().front()->notes,
              std::vector<std::string>{"the library is missing: it belongs beside the program"});
}

TEST(Fixes, MendTheMistakeTheyAreOfferedFor) {
    struct Case {
        std::string_view code{};
        std::string_view wrong{};
        std::string_view right{};
    };
    constexpr std::string_view kHead = "camera { }\nsphere { }\n";
    for (const Case& one : {
             Case{"E0401", "sphere { radios: 1 }", "sphere { radius: 1 }"},
             Case{"E0201", "spere { }", "sphere { }"},
             Case{"E0306", "let a = mix(red, blue, tt: 1)", "let a = mix(red, blue, t: 1)"},
             Case{"E0112", "let a = true && false", "let a = true and false"},
             Case{"E0112", "let a = (true)||(false)", "let a = (true) or (false)"},
             Case{"E0112", "let a = 2**3", "let a = 2^3"},
         }) {
        std::string text = std::string(kHead) + std::string(one.wrong);
        const Loaded wrong = load_text(text);
        ASSERT_EQ(wrong.codes(), one.code) << one.wrong;
        const auto& fix = wrong.diagnostics.sorted().front()->fix;
        ASSERT_TRUE(fix) << one.wrong;
        text.replace(fix->span.offset, fix->span.length, fix->replacement);
        EXPECT_EQ(text.substr(kHead.size()), one.right);
        EXPECT_EQ(load_text(text).codes(), "") << text;
    }
}

TEST(Fixes, AreNotOfferedWhereTheyAreNotSure) {
    // `not a == b` is not (a == b), `!a == b` is (!a) == b.
    const Loaded loaded = load_text("let a = !true == false\nsphere { zebra: 1 }\n");
    ASSERT_TRUE(loaded.has_errors());
    for (const Diagnostic* diagnostic : loaded.diagnostics.sorted()) {
        EXPECT_FALSE(diagnostic->fix) << diagnostic->message;
    }
}

}  // namespace
}  // namespace lray::test
