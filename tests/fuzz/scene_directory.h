// A directory of a fuzzer's own, in memory where that is possible, with what a scene may name.
#pragma once

#include <stdlib.h>  // mkdtemp is POSIX

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "base/assert.h"

namespace lray::fuzz {

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
        write("library.lrs",
              "param size = 2 in [1, 9]\n"
              "fn twice(x) = 2 * x * size\n"
              "component ball(r = 1) { sphere { radius: r } children { } }\n");
        write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\ng one\nf 1 2 3\n");
        write("picture.ppm", "P6\n2 2\n255\nabcdefghijkl");
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

}  // namespace lray::fuzz
