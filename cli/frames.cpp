#include "cli/frames.h"

#include <fmt/format.h>

#include "base/assert.h"
#include "base/path.h"

namespace lray::cli {

bool has_frame_number(std::string_view path) {
    return file_name_of(path).find('#') != std::string_view::npos;
}

std::string numbered_path(std::string_view path, std::uint64_t frame) {
    if (!has_frame_number(path)) return std::string(path);
    const std::size_t last = path.rfind('#');
    const std::size_t before = path.find_last_not_of('#', last);
    const std::size_t begin = before == path.npos ? 0 : before + 1;
    return fmt::format("{}{:0{}}{}", path.substr(0, begin), frame, last + 1 - begin,
                       path.substr(last + 1));
}

std::uint64_t frame_count(const Options& options) {
    return options.frames ? options.frames->count() : 1;
}

Options options_of_frame(const Options& options, std::uint64_t index) {
    LRAY_ASSERT(index < frame_count(options));
    Options result = options;
    if (!options.frames) return result;
    const std::uint64_t frame = options.frames->first + index;
    result.frames = {frame, frame};
    result.output_path = numbered_path(options.output_path, frame);
    if (frame_count(options) > 1) {
        result.frame_label = fmt::format("frame {} of {}", index + 1, frame_count(options));
    }
    return result;
}

}  // namespace lray::cli
