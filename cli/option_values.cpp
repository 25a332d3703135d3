#include "cli/option_values.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "render/film.h"

namespace lray::cli {

namespace {

constexpr std::uint64_t kMaxSide = std::numeric_limits<std::int32_t>::max();
constexpr std::uint64_t kMaxFrame = 1'000'000'000;  // exact as a number of the language

}  // namespace

std::optional<std::uint64_t> parse_number(std::string_view text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::string wrong_number(std::string_view text, std::uint64_t low, std::uint64_t high,
                         std::uint64_t largest) {
    if (high == largest) return fmt::format("takes a whole number from {}, not `{}`", low, text);
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

std::string store_diagnostics(Options& options, std::string_view text) {
    if (text == "text") {
        options.diagnostics_format = DiagnosticsFormat::text;
    } else if (text == "json") {
        options.diagnostics_format = DiagnosticsFormat::json;
    } else if (text == "sarif") {
        options.diagnostics_format = DiagnosticsFormat::sarif;
    } else {
        return fmt::format("takes text, json or sarif, not `{}`", text);
    }
    return {};
}

std::string store_definition(Options& options, std::string_view text) {
    const std::size_t equal = text.find('=');
    if (equal == text.npos || equal == 0) {
        return fmt::format("takes a name and a value like `n=200`, not `{}`", text);
    }
    options.definitions.push_back(
        {std::string(text.substr(0, equal)), std::string(text.substr(equal + 1))});
    return {};
}

std::string store_frame(Options& options, std::string_view text) {
    std::uint64_t number = 0;
    std::string wrong = store_number(number, text, 0, kMaxFrame);
    if (wrong.empty()) options.frames = {number, number};
    return wrong;
}

std::string store_frames(Options& options, std::string_view text) {
    const std::size_t colon = text.find(':');
    const auto first = parse_number(text.substr(0, colon));
    const auto last = colon == text.npos ? std::nullopt : parse_number(text.substr(colon + 1));
    if (!first || !last || *first > kMaxFrame || *last > kMaxFrame) {
        return fmt::format("takes the first and the last frame like `0:95`, not `{}`", text);
    }
    if (*first > *last) return fmt::format("`{}` ends before it begins", text);
    options.frames = {*first, *last};
    return {};
}

std::string store_warning_level(Options& options, std::string_view text, WarningLevel level) {
    return options.warning_levels.set(text, level).value_or(std::string{});
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

}  // namespace lray::cli
