#include "base/nearby_files.h"

#include <dirent.h>
#include <fcntl.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "base/did_you_mean.h"
#include "base/path.h"

namespace lray {
namespace {

constexpr int kListFlags = O_RDONLY | O_DIRECTORY | O_NONBLOCK | O_CLOEXEC;

bool equal_ignoring_case(std::string_view a, std::string_view b) {
    return a.size() == b.size() && edit_distance(a, b, 0) == 0;
}

}  // namespace

std::vector<std::string> names_in(Descriptor directory) {
    constexpr std::size_t kMaxNames = 10'000;
    std::vector<std::string> names;
    if (!directory.is_open()) return names;
    const std::unique_ptr<DIR, int (*)(DIR*)> stream(fdopendir(directory.fd()), &closedir);
    if (!stream) return names;
    directory.release();
    while (names.size() < kMaxNames) {
        const dirent* entry = readdir(stream.get());
        if (entry == nullptr) break;
        const std::string_view name = entry->d_name;
        if (name != "." && name != "..") names.emplace_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string nearest_file_name(std::string_view name, const std::vector<std::string>& names) {
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    const std::vector<std::string_view> near = nearest_names(name, candidates);
    return near.empty() ? std::string() : std::string(near.front());
}

Resemblance find_resemblance(int root, const std::string& path, BeneathMethod method) {
    Resemblance result;
    std::string found;
    const std::vector<std::string_view> components = path_components(path);
    for (std::size_t i = 0; i < components.size(); ++i) {
        const std::string_view name = components[i];
        std::vector<std::string> names =
            names_in(open_beneath(root, found.empty() ? "." : found, kListFlags, method).file);
        auto match = std::find(names.begin(), names.end(), name);
        if (match == names.end()) {
            match = std::find_if(names.begin(), names.end(), [&](const std::string& other) {
                return equal_ignoring_case(name, other);
            });
        }
        if (match == names.end()) {
            if (i + 1 == components.size()) result.nearest = nearest_file_name(name, names);
            return result;
        }
        if (!found.empty()) found += '/';
        found += *match;
    }
    result.same_but_case = std::move(found);
    return result;
}

}  // namespace lray
