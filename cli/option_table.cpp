#include "cli/option_table.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <limits>

#include "render/film.h"

namespace lray::cli {

namespace {

constexpr std::uint64_t kMaxDepth = 1000;  // what is nested is read by recursion
constexpr std::uint64_t kMaxThreads = 1024;
constexpr std::uint64_t kMaxSide = std::numeric_limits<std::int32_t>::max();

std::optional<std::uint64_t> parse_number(std::string_view text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

template <class Integer>
std::string store_number(Integer& target, std::string_view text, std::uint64_t low,
                         std::uint64_t high = std::numeric_limits<Integer>::max()) {
    const auto number = parse_number(text);
    if (number && *number >= low && *number <= high) {
        target = static_cast<Integer>(*number);
        return {};
    }
    if (high == std::numeric_limits<Integer>::max()) {
        return fmt::format("takes a whole number from {}, not `{}`", low, text);
    }
    return fmt::format("takes a whole number from {} to {}, not `{}`", low, high, text);
}

std::string store_level(Options& options, std::string_view text) {
    if (text == "1") {
        options.level = 1;
        return {};
    }
    if (text == "2" || text == "3") {
        return fmt::format(
            "{} is not available in this version; `-n 1` is: one ray per pixel, flat painting",
            text);
    }
    return fmt::format("takes a level, 1, 2 or 3, not `{}`", text);
}

std::string store_samples(Options& options, std::string_view text) {
    return store_number(options.samples.emplace(), text, 1, render::Film::kMaxSamples);
}

std::string store_size(Options& options, std::string_view text) {
    const std::size_t cross = text.find_first_of("xX");
    const auto width = parse_number(text.substr(0, cross));
    const auto height = cross == text.npos ? std::nullopt : parse_number(text.substr(cross + 1));
    if (!width || !height || *width < 1 || *width > kMaxSide || *height < 1 || *height > kMaxSide) {
        return fmt::format("takes a width and a height in pixels like `800x600`, not `{}`", text);
    }
    options.size = {static_cast<std::uint32_t>(*width), static_cast<std::uint32_t>(*height)};
    return {};
}

std::string store_crop(Options& options, std::string_view text) {
    std::array<std::uint32_t, 4> edges{};
    std::string_view rest = text;
    bool is_complete = true;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const bool is_last = i + 1 == edges.size();
        const std::size_t comma = is_last ? rest.size() : rest.find(',');
        const auto edge = comma == rest.npos ? std::nullopt : parse_number(rest.substr(0, comma));
        if (!edge || *edge > kMaxSide) {
            is_complete = false;
            break;
        }
        edges[i] = static_cast<std::uint32_t>(*edge);
        if (!is_last) rest.remove_prefix(comma + 1);
    }
    if (!is_complete) {
        return fmt::format("takes four pixel positions X0,Y0,X1,Y1 like `0,0,320,240`, not `{}`",
                           text);
    }
    const render::PixelRect crop{edges[0], edges[1], edges[2], edges[3]};
    if (crop.x0 >= crop.x1 || crop.y0 >= crop.y1) {
        return fmt::format("`{}` holds no pixel: X0 must be less than X1 and Y0 less than Y1",
                           text);
    }
    options.crop = crop;
    return {};
}

std::string store_accel(Options& options, std::string_view text) {
    if (text == "none") {
        options.accel = bvh::AccelKind::none;
        return {};
    }
    if (text == "spheres" || text == "boxes") {
        return fmt::format(
            "{} is not available in this version; `--accel none` is: every ray tests everything",
            text);
    }
    return fmt::format("takes none, spheres or boxes, not `{}`", text);
}

std::string store_format(Options& options, std::string_view text) {
    options.format = image::find_format(text);
    return options.format ? std::string{} : fmt::format("takes ppm or png, not `{}`", text);
}

std::string store_color(Options& options, std::string_view text) {
    if (text == "auto") {
        options.color = ColorMode::automatic;
    } else if (text == "always") {
        options.color = ColorMode::always;
    } else if (text == "never") {
        options.color = ColorMode::never;
    } else {
        return fmt::format("takes auto, always or never, not `{}`", text);
    }
    return {};
}

std::string store_denied(Options& options, std::string_view text) {
    options.deny_warnings = true;
    return text == "warnings" ? std::string{} : fmt::format("takes `warnings`, not `{}`", text);
}

std::string store_path(std::string& target, std::string_view text) {
    target = text;
    return text.empty() ? std::string{"needs a file name, not an empty text"} : std::string{};
}

std::string store_directory(std::vector<std::string>& target, std::string_view text) {
    target.emplace_back(text);
    return text.empty() ? std::string{"needs a directory, not an empty text"} : std::string{};
}

std::string store_explained(Options& options, std::string_view text) {
    options.mode = Mode::explain;
    options.explained = text;
    return {};
}

template <auto member, auto value>
std::string set(Options& options, std::string_view) {
    options.*member = value;
    return {};
}

template <auto member>
std::string keep(Options& options, std::string_view text) {
    options.*member = text;
    return {};
}

using Value = std::string_view;

constexpr std::array kPictureOptions{
    OptionSpec{"n", "LEVEL", "1: one ray per pixel, flat painting, no hierarchy", store_level},
    OptionSpec{"i", "FILE", "the scene; - is stdin; -i may be left out",
               [](Options& o, Value v) { return store_path(o.scene_path, v); }},
    OptionSpec{"o", "FILE", "the picture; - is stdout",
               [](Options& o, Value v) { return store_path(o.output_path, v); }},
    OptionSpec{"ps", "N", "rays per pixel", store_samples},
    OptionSpec{"spp", "N", "", store_samples},
    OptionSpec{"size", "WxH", "size of the picture in pixels", store_size},
    OptionSpec{"crop", "X0,Y0,X1,Y1", "only these pixels, from the top left, X1 and Y1 excluded",
               store_crop},
    OptionSpec{"camera", "NAME", "which camera of the scene; the first one otherwise",
               keep<&Options::camera_name>},
    OptionSpec{"format", "ppm|png", "otherwise by the extension of the picture", store_format},
    OptionSpec{"accel", "none", "the hierarchy; none: every ray tests everything", store_accel},
    OptionSpec{"threads", "N", "0: all; the picture does not depend on it",
               [](Options& o, Value v) { return store_number(o.thread_count, v, 0, kMaxThreads); }},
};

constexpr std::array kInsteadOptions{
    OptionSpec{"check", "", "look for mistakes in the scene, render nothing",
               set<&Options::mode, Mode::check>},
    OptionSpec{"fmt", "",
               "write scenes in the canonical style; with --check, list those that are not",
               set<&Options::is_formatting, true>},
    OptionSpec{"explain", "CODE", "what a code like E0401 means, with an example", store_explained},
    OptionSpec{"help", "", "this text", set<&Options::mode, Mode::help>},
    OptionSpec{"h", "", "", set<&Options::mode, Mode::help>},
    OptionSpec{"version", "", "the version of the program", set<&Options::mode, Mode::version>},
};

constexpr std::array kFileOptions{
    OptionSpec{"I", "DIR", "look here too for files that the scene names",
               [](Options& o, Value v) { return store_directory(o.include_directories, v); }},
    OptionSpec{"allow", "DIR", "let the scene read files below this directory",
               [](Options& o, Value v) { return store_directory(o.allowed_directories, v); }},
};

constexpr std::array kMessageOptions{
    OptionSpec{"stats", "", "what was rendered and how long it took", set<&Options::stats, true>},
    OptionSpec{"quiet", "", "no progress and no notes", set<&Options::quiet, true>},
    OptionSpec{"color", "WHEN", "auto, always or never", store_color},
    OptionSpec{"max-errors", "N", "show at most so many errors; 0: all",
               [](Options& o, Value v) { return store_number(o.max_errors, v, 0); }},
    OptionSpec{"deny", "warnings", "treat warnings as errors", store_denied},
};

constexpr std::array kLimitOptions{
    OptionSpec{
        "max-nesting", "N", "brackets and blocks inside one another",
        [](Options& o, Value v) { return store_number(o.load_limits.nesting, v, 1, kMaxDepth); }},
    OptionSpec{"max-include-depth", "N", "files that include one another",
               [](Options& o, Value v) {
                   return store_number(o.load_limits.include_depth, v, 0, kMaxDepth);
               }},
    OptionSpec{"max-files", "N", "files of a scene",
               [](Options& o, Value v) { return store_number(o.load_limits.files, v, 1); }},
    OptionSpec{"max-scene-bytes", "N", "size of the scene and what it includes",
               [](Options& o, Value v) { return store_number(o.load_limits.scene_bytes, v, 1); }},
    OptionSpec{"max-mesh-bytes", "N", "size of its mesh files in all",
               [](Options& o, Value v) { return store_number(o.load_limits.mesh_bytes, v, 1); }},
    OptionSpec{"max-texture-bytes", "N", "size of its picture files in all",
               [](Options& o, Value v) { return store_number(o.load_limits.texture_bytes, v, 1); }},
    OptionSpec{
        "max-texture-pixels", "N", "pixels of its pictures in all",
        [](Options& o, Value v) { return store_number(o.load_limits.texture_pixels, v, 1); }},
    OptionSpec{"max-steps", "N", "steps of evaluation",
               [](Options& o, Value v) { return store_number(o.load_limits.steps, v, 1); }},
    OptionSpec{"max-value-bytes", "N", "memory for the values of a scene",
               [](Options& o, Value v) { return store_number(o.load_limits.value_bytes, v, 1); }},
    OptionSpec{"max-primitives", "N", "triangles, spheres and so on in all",
               [](Options& o, Value v) { return store_number(o.flatten_limits.primitives, v, 1); }},
    OptionSpec{"max-lights", "N", "lights in all",
               [](Options& o, Value v) { return store_number(o.flatten_limits.lights, v, 1); }},
    OptionSpec{"max-output-pixels", "N", "pixels of the picture",
               [](Options& o, Value v) { return store_number(o.max_output_pixels, v, 1); }},
};

constexpr std::array kGroups{
    OptionGroup{"Picture", kPictureOptions}, OptionGroup{"Instead of a picture", kInsteadOptions},
    OptionGroup{"Files", kFileOptions},      OptionGroup{"Messages", kMessageOptions},
    OptionGroup{"Limits", kLimitOptions},
};

}  // namespace

std::span<const OptionGroup> option_groups() {
    return kGroups;
}

std::string spelled(std::string_view option_name) {
    return fmt::format("{}{}", option_name.size() <= 2 ? "-" : "--", option_name);
}

}  // namespace lray::cli
