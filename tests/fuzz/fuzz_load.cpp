// Fuzzes all that a scene's bytes reach before rays are traced: load, flatten, and the printing of
// what was wrong.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/assert.h"
#include "base/diagnostic_printer.h"
#include "base/diagnostics.h"
#include "base/file_access.h"
#include "base/source.h"
#include "parser/load.h"
#include "scene/flatten.h"
#include "tests/fuzz/scene_directory.h"
#include "tests/fuzz/small_limits.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const lray::fuzz::SceneDirectory kDirectory;
    const std::string path =
        kDirectory.write("scene.lrs", {reinterpret_cast<const char*>(data), size});

    lray::FileAccess files;
    lray::Sources sources;
    lray::Diagnostics diagnostics;
    const auto scene =
        lray::parser::load(path, {.limits = lray::fuzz::kSmallLimits}, files, sources, diagnostics)
            .scene;
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
