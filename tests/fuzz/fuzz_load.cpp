// Fuzzes all that a scene's bytes reach before rays are traced: load, flatten, and the printing of
// what was wrong.
#include <stdlib.h>  // mkdtemp is POSIX

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "base/assert.h"
#include "base/diagnostic_printer.h"
#include "base/diagnostics.h"
#include "base/file_access.h"
#include "base/source.h"
#include "parser/load.h"
#include "scene/flatten.h"

namespace {

/// A directory of its own, in memory where that is possible, with what a scene may name.
class SceneDirectory {
 public:
    SceneDirectory() {
        const bool has_memory = std::filesystem::is_directory("/dev/shm");
        path_ = (has_memory ? std::filesystem::path("/dev/shm")
                            : std::filesystem::temp_directory_path()) /
                "lray-fuzz-XXXXXX";
        std::string name = path_.string();
        LRAY_ASSERT(mkdtemp(name.data()) != nullptr);
        path_ = name;
        write("part.lrs", "let red = material { diffuse: #f00 }\nsphere { material: red }\n");
        write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\ng one\nf 1 2 3\n");
    }
    SceneDirectory(const SceneDirectory&) = delete;
    SceneDirectory& operator=(const SceneDirectory&) = delete;
    ~SceneDirectory() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    /// Returns the path of the file written.
    std::string write(const char* name, std::string_view text) const {
        const std::filesystem::path path = path_ / name;
        std::ofstream file(path, std::ios::binary | std::ios::trunc);
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
        file.close();
        LRAY_ASSERT(file.good());
        return path.string();
    }

 private:
    std::filesystem::path path_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const SceneDirectory kDirectory;
    const std::string path =
        kDirectory.write("scene.lrs", {reinterpret_cast<const char*>(data), size});

    lray::FileAccess files;
    lray::Sources sources;
    lray::Diagnostics diagnostics;
    // Small limits, so that an input ends in milliseconds; each is met the same way at any size.
    const lray::parser::LoadLimits limits{.scene_bytes = 1u << 20,
                                          .mesh_bytes = 1u << 20,
                                          .nesting = 256,
                                          .include_depth = 8,
                                          .files = 32};
    const auto scene =
        lray::parser::load(path, {.limits = limits}, files, sources, diagnostics).scene;
    LRAY_ASSERT(scene.has_value() == !diagnostics.has_errors());
    if (scene) {
        const auto world = lray::scene::flatten(*scene, {.primitives = 10'000}, diagnostics);
        LRAY_ASSERT(world.has_value() == !diagnostics.has_errors());
    }
    const std::string text = lray::format_diagnostics(diagnostics, sources, {.max_errors = 0});
    LRAY_ASSERT(text.empty() ==
                (diagnostics.error_count() == 0 && diagnostics.warning_count() == 0));
    // Whatever a scene holds, nothing that commands a terminal is printed.
    for (const char c : text) LRAY_ASSERT(c == '\n' || static_cast<unsigned char>(c) >= 0x20);
    return 0;
}
