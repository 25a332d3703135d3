#include "cli/stored_views.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/assert.h"
#include "base/diagnostics.h"
#include "base/output_file.h"
#include "base/path.h"
#include "base/source.h"
#include "base/terminal_text.h"
#include "parser/load.h"
#include "parser/tools/camera_text.h"

namespace lray::cli {

namespace {

constexpr std::string_view kFirstLine =
    "// Views stored with Shift and F1 to F9 in the viewer of lray, which writes this file anew\n";
constexpr std::string_view kExtension = ".views.lrs";

/// Nine cameras take a few kilobytes.
constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 20;

// A file of views is read while somebody waits for the window.
parser::LoadSettings views_settings() {
    parser::LoadSettings settings;
    settings.limits.scene_bytes = kMaxBytes;
    settings.limits.mesh_bytes = kMaxBytes;
    settings.limits.texture_bytes = kMaxBytes;
    settings.limits.texture_pixels = kMaxBytes;
    settings.limits.files = 100;
    settings.limits.steps = 1'000'000;
    settings.limits.value_bytes = 16 * kMaxBytes;
    settings.limits.list_size = 100'000;
    settings.limits.nodes = 100'000;
    return settings;
}

std::string name_of(int number) {
    return fmt::format("view {}", number);
}

std::optional<int> number_of(std::string_view name) {
    for (int number = 1; number <= kMaxStoredViews; ++number) {
        if (name == name_of(number)) return number;
    }
    return std::nullopt;
}

std::string shown(const std::string& path) {
    return fmt::format("`{}`", escape_for_terminal(path));
}

/// What the file is, found out without waiting for it: a FIFO has no writer.
ReadResult look_at(const std::string& path, FileAccess& files) {
    const std::string directory = directory_of(path);
    files.allow(directory, false);
    ReadResult found = files.read(file_name_of(path), directory, kMaxBytes);
    if (found.differs_in_case) found.status = ReadStatus::not_found;
    return found;
}

/// What keeps a file from being read, in words; empty if nothing does or it is not there.
std::string obstacle(const ReadResult& found) {
    switch (found.status) {
        case ReadStatus::ok:
        case ReadStatus::not_found:
            return {};
        case ReadStatus::outside:
            return "it leads to another directory";
        case ReadStatus::not_regular:
            return "it is not a file";
        case ReadStatus::too_large:
            return fmt::format("it has more than {} bytes", kMaxBytes);
        case ReadStatus::unreadable:
            return found.reason;
    }
    LRAY_ASSERT(false);
}

std::string first_error(const Diagnostics& diagnostics, const Sources& sources) {
    for (const Diagnostic* diagnostic : diagnostics.sorted()) {
        if (diagnostic->severity != Severity::error) continue;
        std::string text = escape_for_terminal(diagnostic->message);
        if (diagnostic->span.is_nowhere()) return text;
        const Position at = sources.position(diagnostic->span);
        return fmt::format("{}:{}:{}: {}",
                           escape_for_terminal(sources[diagnostic->span.source].path), at.line,
                           at.column, text);
    }
    return "it cannot be read";
}

struct Cameras {
    StoredViews views{};
    bool are_views_alone = true;  // each camera is one of ours, once
};

/// Reads what look_at() found.
Cameras load_views(const std::string& path, FileAccess& files, std::string& problem) {
    Sources sources;
    Diagnostics diagnostics;
    const parser::LoadResult loaded =
        parser::load(path, views_settings(), files, sources, diagnostics);
    Cameras cameras;
    if (!loaded.scene) {
        problem = fmt::format("the views in {} are not read: {}", shown(path),
                              first_error(diagnostics, sources));
        return cameras;
    }
    for (const scene::Camera& camera : loaded.scene->cameras) {
        const std::optional<int> number = number_of(camera.name);
        const bool is_new = number && cameras.views.emplace(*number, camera).second;
        cameras.are_views_alone = cameras.are_views_alone && is_new;
    }
    return cameras;
}

/// Why a file that is there must not be replaced; empty if it may be.
std::string reason_to_keep(const std::string& path) {
    FileAccess files;
    const ReadResult found = look_at(path, files);
    std::string reason = obstacle(found);
    if (!reason.empty()) return reason;
    if (found.status == ReadStatus::not_found) {
        struct stat status {};
        if (::lstat(path.c_str(), &status) != 0) return {};
        return S_ISLNK(status.st_mode) ? "it is a link to a file that is not there"
                                       : "it cannot be looked into";
    }
    constexpr std::string_view kMore = "it holds more than stored views";
    std::string_view text = found.text.view();
    if (text.starts_with(kFirstLine)) text.remove_prefix(kFirstLine.size());
    if (!parser::is_cameras_alone(text)) return std::string(kMore);
    if (text.empty()) return {};
    std::string problem;
    const Cameras cameras = load_views(path, files, problem);
    return problem.empty() && cameras.are_views_alone ? "" : std::string(kMore);
}

}  // namespace

std::string views_path(std::string_view scene_path) {
    constexpr std::string_view kScene = ".lrs";
    if (scene_path == "-") return {};
    const bool has_name = file_name_of(scene_path).size() > kScene.size();
    if (has_name && scene_path.ends_with(kScene)) scene_path.remove_suffix(kScene.size());
    return std::string(scene_path) + std::string(kExtension);
}

StoredViews read_views(const std::string& path, FileAccess& files, std::string& problem) {
    const ReadResult found = look_at(path, files);
    const std::string reason = obstacle(found);
    if (!reason.empty()) {
        problem = fmt::format("the views in {} are not read: {}", shown(path), reason);
    }
    if (found.status != ReadStatus::ok) return {};
    return load_views(path, files, problem).views;
}

std::string write_views(const std::string& path, const StoredViews& views) {
    if (const std::string reason = reason_to_keep(path); !reason.empty()) {
        return fmt::format("{} is left as it is: {}; move or rename it to store views", shown(path),
                           reason);
    }
    std::string text(kFirstLine);
    for (const auto& [number, view] : views) {
        LRAY_ASSERT(number >= 1 && number <= kMaxStoredViews);
        scene::Camera camera = view;
        camera.name = name_of(number);
        text += parser::camera_text(camera) + "\n";
    }
    std::string error;
    std::optional<OutputFile> file = OutputFile::open(path, error);
    if (!file) return error;
    return file->write(text) && file->commit() ? std::string() : file->error();
}

}  // namespace lray::cli
