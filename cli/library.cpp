#include "cli/library.h"

#include <filesystem>
#include <system_error>

namespace lray::cli {

std::string library_directory() {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (program.empty()) return {};
    const fs::path installed = program.parent_path().parent_path() / "share" / "lray" / "std";
    const fs::path beside = program.parent_path() / "std";
    const bool is_beside = !fs::is_directory(installed, error) && fs::is_directory(beside, error);
    return (is_beside ? beside : installed).string();
}

}  // namespace lray::cli
