// import_mesh: nothing that an importer does is more than one error.
#include "scene/formats/import_mesh.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "tests/scene/formats/import.h"

namespace lray::scene {
namespace {

std::string hostile(std::string_view what, ImportSettings settings = {}) {
    settings.program = LRAY_HOSTILE_IMPORTER;
    return Import("a.fbx", what, settings).error();
}

TEST(ImportMesh, WhatAnImporterMayDoWrongIsOneError) {
    EXPECT_EQ(hostile("crash"), "E0701 the importer of .fbx files crashed on `a.fbx`");
    EXPECT_EQ(hostile("abort"), "E0701 the importer of .fbx files crashed on `a.fbx`");
    EXPECT_EQ(hostile("exit"), "E0701 the importer of .fbx files has failed on `a.fbx`");
    const std::string nonsense =
        "E0701 the importer of .fbx files has answered what makes no sense on `a.fbx`";
    EXPECT_EQ(hostile("silence"), nonsense);
    EXPECT_EQ(hostile("garbage"), nonsense);
    EXPECT_EQ(hostile("anything"), "E0701 `a.fbx` is not understood: \x1b[2J");
}

TEST(ImportMesh, AnImporterThatHangsIsStopped) {
    for (const char* how : {"hang", "close and hang"}) {
        EXPECT_EQ(hostile(how, {.seconds = 1}),
                  "E0516 `a.fbx` is not imported after 1 seconds; raise the limit with "
                  "`--max-import-seconds N`");
    }
}

TEST(ImportMesh, AnImporterThatWritesWithoutEndIsStopped) {
    EXPECT_EQ(hostile("endless", {.bytes = std::uint64_t{256} << 20}),
              "E0516 `a.fbx` needs more than 268435456 bytes to be imported; raise the limit with "
              "`--max-import-bytes N`");
}

TEST(ImportMesh, AnImporterReachesNothing) {
    EXPECT_EQ(hostile("files"), "E0701 `a.fbx` is not understood: reaches nothing");
    EXPECT_EQ(hostile("descriptors"), "E0701 `a.fbx` is not understood: has none");
    const std::string stopped =
        "E0701 the importer of .fbx files was stopped: it did what an "
        "importer has no need of on `a.fbx`";
    EXPECT_EQ(hostile("socket"), stopped);
    EXPECT_EQ(hostile("process"), stopped);
    EXPECT_EQ(hostile("code"), stopped);
}

TEST(ImportMesh, AnImporterHasAMemoryLimit) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer reserves terabytes";
#endif
    EXPECT_EQ(hostile("memory"), "E0701 `a.fbx` is not understood: has a limit");
}

TEST(ImportMesh, ProgramsThatAreNotThere) {
    EXPECT_EQ(Import("a.STL", "x", {}).error(),
              "E0705 `.stl` files are read by a program that this lray was built without; save the "
              "mesh as OBJ or PLY; or install Assimp and build lray again");
    ImportSettings missing;
    missing.program = "/nowhere/lray-import";
    EXPECT_EQ(Import("a.stl", "x", missing).error(),
              "E0701 the importer of .stl files could not be started on `a.stl`");
}

}  // namespace
}  // namespace lray::scene
