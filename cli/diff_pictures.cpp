#include "cli/diff_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "base/file_access.h"
#include "base/terminal_text.h"
#include "cli/console.h"
#include "cli/named_file.h"
#include "cli/run.h"
#include "image/compare.h"
#include "image/read.h"

namespace lray::cli {

namespace {

constexpr std::uint64_t kMaxHeaderBytes = std::uint64_t{1} << 24;  // and what is beside the pixels

std::variant<image::Image, Failure> read(const std::string& path, const Options& options) {
    FileAccess files;
    const std::uint64_t most = options.max_output_pixels;
    const ReadResult file = files.read_main(path, sizeof(Color) * most + kMaxHeaderBytes);
    if (file.status != ReadStatus::ok) {
        return Failure{ExitCode::usage, fmt::format("`{}`: {}", path, why_unread(file)), {}};
    }
    const image::ReadLimits limits{most};
    std::string error;
    auto picture = image::read_image(std::as_bytes(std::span(file.text.view())), limits, error);
    if (picture) return std::move(*picture);
    if (limits.is_exceeded) {
        return Failure{ExitCode::limit, fmt::format("`{}`: {}", path, error),
                       "raise the limit with `--max-output-pixels N`"};
    }
    return Failure{ExitCode::usage, fmt::format("`{}`: {}", path, error), {}};
}

std::string size_text(const std::string& path, const image::Image& picture) {
    return fmt::format("{} x {} pixels  {}\n", picture.width, picture.height,
                       escape_for_terminal(path));
}

std::string text_of(const image::Difference& difference, float threshold) {
    if (difference.is_none) return "the same to the bit\n";
    std::string text;
    if (difference.max > 0.0f) {
        text += fmt::format("largest difference: {:.2f} levels of 255, at pixel {}, {}\n",
                            double{difference.max}, difference.worst_x, difference.worst_y);
        text += fmt::format("root mean square: {:.4f} levels\n", difference.rms);
    }
    text += fmt::format("pixels beyond {:g} levels: {} ({:.4g} %)\n", double{threshold},
                        difference.beyond_count, 100.0 * difference.share_beyond);
    return text + (difference.beyond_count > 0 ? "different\n"
                   : difference.max > 0.0f     ? "the same within the threshold\n"
                                               : "the same to the eye: what differs is darker than "
                                                 "black or brighter than white\n");
}

}  // namespace

ExitCode diff_pictures(const Options& options) {
    LRAY_ASSERT(options.paths.size() == 2 && options.threshold);
    const auto read_a = read(options.paths[0], options);
    if (const auto* failure = std::get_if<Failure>(&read_a)) return report_failure(*failure);
    const auto read_b = read(options.paths[1], options);
    if (const auto* failure = std::get_if<Failure>(&read_b)) return report_failure(*failure);
    const auto& a = std::get<image::Image>(read_a);
    const auto& b = std::get<image::Image>(read_b);

    std::string text = size_text(options.paths[0], a) + size_text(options.paths[1], b);
    const auto difference = image::compare(a, b, *options.threshold);
    text +=
        difference ? text_of(*difference, *options.threshold) : std::string("different sizes\n");
    const bool is_same = difference && difference->beyond_count == 0;
    if (difference && !options.output_path.empty()) {
        auto opened = open_output(options, options.paths);
        if (const auto* failure = std::get_if<Failure>(&opened)) return report_failure(*failure);
        const auto failure = write_picture(std::move(std::get<OutputFile>(opened)),
                                           image::difference_picture(a, b, *options.threshold),
                                           image::Gamma::srgb, {}, options);
        if (failure) return report_failure(*failure);
    }
    // A picture that goes to stdout leaves no place for words there.
    if (options.output_path == "-") {
        print_message(text);
    } else if (const ExitCode printed = print_requested(text); printed != ExitCode::done) {
        return printed;
    }
    return is_same ? ExitCode::done : ExitCode::scene;
}

}  // namespace lray::cli
