#include "base/path.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace lray {

std::vector<std::string_view> path_components(std::string_view path) {
    std::vector<std::string_view> components;
    while (!path.empty()) {
        const std::size_t end = std::min(path.find('/'), path.size());
        const std::string_view name = path.substr(0, end);
        if (!name.empty() && name != ".") components.push_back(name);
        path.remove_prefix(std::min(end + 1, path.size()));
    }
    return components;
}

std::string directory_of(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    if (slash == std::string_view::npos) return ".";
    return std::string(slash == 0 ? path.substr(0, 1) : path.substr(0, slash));
}

std::string_view file_name_of(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

std::string join_paths(std::string_view directory, std::string_view path) {
    const bool is_absolute = path.starts_with('/');
    std::string joined(is_absolute ? "/" : directory);
    while (joined.starts_with("./")) joined.erase(0, joined.find_first_not_of('/', 1));
    while (joined.size() > 1 && joined.ends_with('/')) joined.pop_back();
    if (joined == ".") joined.clear();
    for (const std::string_view name : path_components(path)) {
        if (name == "..") {
            if (joined == "/") continue;
            const std::string_view last = file_name_of(joined);
            if (!last.empty() && last != "..") {
                const std::size_t slash = joined.rfind('/');
                joined.erase(slash == std::string::npos ? 0 : (slash == 0 ? 1 : slash));
                continue;
            }
        }
        if (!joined.empty() && joined != "/") joined += '/';
        joined += name;
    }
    return joined.empty() ? "." : joined;
}

std::string absolute_path(std::string_view path) {
    if (path.starts_with('/')) return join_paths("/", path);
    std::error_code error;
    const std::string current = std::filesystem::current_path(error).string();
    return join_paths(join_paths("/", current), path);
}

}  // namespace lray
