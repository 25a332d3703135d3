#include "cli/picture_names.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>

#include "base/path.h"
#include "base/terminal_text.h"
#include "cli/frames.h"
#include "image/write.h"

namespace lray::cli {

namespace {

/// True if nothing has that name, not even a link that leads nowhere.
bool is_free(const std::string& path) {
    struct stat status {};
    return ::lstat(path.c_str(), &status) != 0 && errno == ENOENT;
}

}  // namespace

std::string scene_stem(std::string_view scene_path) {
    constexpr std::string_view kNameless = "scene";
    if (scene_path == "-") return std::string(kNameless);
    const std::string_view name = file_name_of(scene_path);
    const std::string_view stem = name.substr(0, name.rfind('.'));
    return std::string(stem.empty() ? kNameless : stem);
}

std::optional<std::string> next_picture_name(const Options& options, std::string& problem) {
    if (!options.output_path.empty()) {
        return options.frames ? numbered_path(options.output_path, options.frames->first)
                              : options.output_path;
    }
    const std::string stem = scene_stem(options.scene_path);
    const std::string_view extension =
        image::format_name(options.format.value_or(image::Format::png));
    for (int number = 1; number <= kMaxPictureNumber; ++number) {
        std::string name = fmt::format("{}-{:03}.{}", stem, number, extension);
        if (is_free(name)) return name;
    }
    problem = fmt::format(
        "all names from `{0}-001.{1}` to `{0}-{2}.{1}` are taken; name another with `-o`",
        escape_for_terminal(stem), extension, kMaxPictureNumber);
    return std::nullopt;
}

}  // namespace lray::cli
