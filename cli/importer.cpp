#include "cli/importer.h"

#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace lray::cli {

std::string importer_program() {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (program.empty()) return {};
    const fs::path directory = program.parent_path();
    for (const fs::path& importer : {directory.parent_path() / "libexec" / "lray" / "lray-import",
                                     directory / "lray-import"}) {
        if (access(importer.c_str(), X_OK) == 0) return importer.string();
    }
    return {};
}

}  // namespace lray::cli
