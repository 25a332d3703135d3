#include "cli/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <utility>

#include "base/did_you_mean.h"
#include "render/film.h"

namespace lray::cli {

namespace {

constexpr std::uint64_t kMaxSide = std::numeric_limits<std::int32_t>::max();
constexpr std::uint64_t kMaxFrame = 1'000'000'000;  // exact as a number of the language

/// Reads two whole numbers with a colon between them.
std::optional<std::pair<std::uint64_t, std::uint64_t>> parse_range(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == text.npos) return std::nullopt;
    const auto first = parse_number(text.substr(0, colon));
    const auto second = parse_number(text.substr(colon + 1));
    if (!first || !second) return std::nullopt;
    return std::pair(*first, *second);
}

/// A word that an option takes, and what it means.
template <class T>
struct Word {
    std::string_view text{};
    T value{};
};

template <class T>
std::string store_word(T& target, std::string_view text, std::initializer_list<Word<T>> words) {
    std::vector<std::string_view> names;
    std::string listed;
    for (const Word<T>& word : words) {
        if (text == word.text) {
            target = word.value;
            return {};
        }
        const bool is_last = &word == words.end() - 1;
        listed += fmt::format("{}{}", names.empty() ? "" : is_last ? " or " : ", ", word.text);
        names.push_back(word.text);
    }
    const auto meant = meant_names(text, names);
    return fmt::format("takes {}, not `{}`{}", listed, text,
                       meant.empty() ? "" : fmt::format("; did you mean `{}`?", meant.front()));
}

}  // namespace

std::vector<std::string_view> meant_names(std::string_view written,
                                          std::span<const std::string_view> names) {
    // An abbreviation is more likely than a slip, in so far as it is one.
    std::vector<std::string_view> meant;
    std::copy_if(names.begin(), names.end(), std::back_inserter(meant), [&](std::string_view full) {
        return !written.empty() && full.starts_with(written);
    });
    return meant.empty() ? nearest_names(written, names) : meant;
}

std::optional<std::uint64_t> parse_number(std::string_view text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::optional<double> parse_decimal(std::string_view text) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    if (!std::isfinite(number)) return std::nullopt;
    return number;
}

std::string wrong_number(std::string_view text, std::uint64_t low, std::uint64_t high,
                         std::uint64_t largest) {
    const bool is_too_large = !text.empty() && text.find_first_not_of("0123456789") == text.npos;
    if (high == largest && !is_too_large) {
        return fmt::format("takes a whole number from {}, not `{}`", low, text);
    }
    return fmt::format("takes a whole number from {} to {}, not `{}`", low, high, text);
}

std::string store_level(Options& options, std::string_view text) {
    if (text == "1" || text == "2" || text == "3") {
        options.level = static_cast<std::uint32_t>(text[0] - '0');
        return {};
    }
    return fmt::format("takes a level, 1, 2 or 3, not `{}`", text);
}

std::string store_samples(Options& options, std::string_view text) {
    return store_number(options.samples.emplace(), text, 1, render::Film::kMaxSamples);
}

std::string store_sample_range(Options& options, std::string_view text) {
    constexpr std::uint64_t kMaxSamples = render::Film::kMaxSamples;
    const auto range = parse_range(text);
    if (!range || range->second > kMaxSamples) {
        return fmt::format(
            "takes the first sample and the one behind the last like `0:16`, up to {}, not `{}`",
            kMaxSamples, text);
    }
    const auto [begin, end] = *range;
    if (begin >= end) return fmt::format("`{}` holds no sample: A must be less than B", text);
    options.sample_range = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    return {};
}

std::string store_duration(double& seconds, std::string_view text) {
    struct Unit {
        std::string_view name{};
        double seconds = 1.0;
    };
    constexpr std::array<Unit, 4> kUnits{{{"ms", 0.001}, {"s", 1.0}, {"m", 60.0}, {"h", 3600.0}}};
    const std::size_t end = text.find_first_not_of("0123456789.");
    const auto number = parse_decimal(text.substr(0, end));
    const std::string_view written = end == text.npos ? std::string_view{} : text.substr(end);
    const auto unit = std::find_if(kUnits.begin(), kUnits.end(),
                                   [&](const Unit& known) { return known.name == written; });
    if (number && *number > 0.0 && unit != kUnits.end()) {
        seconds = *number * unit->seconds;
        return {};
    }
    std::string wrong =
        fmt::format("takes a duration like `500ms`, `30s`, `5m` or `2h`, not `{}`", text);
    if (number && *number > 0.0 && written.empty()) wrong += fmt::format("; `{}s`?", text);
    return wrong;
}

std::string store_time(Options& options, std::string_view text) {
    return store_duration(options.sample_limits.seconds.emplace(), text);
}

std::string store_noise(Options& options, std::string_view text) {
    const auto number = parse_decimal(text);
    if (!number || !(*number > 0.0) || *number > 1.0) {
        return fmt::format("takes a share of white above 0, like `0.01`, up to 1, not `{}`", text);
    }
    options.sample_limits.noise = *number;
    return {};
}

std::string store_sampler(Options& options, std::string_view text) {
    using enum SamplerKind;
    return store_word<SamplerKind>(options.sampler.emplace(), text,
                                   {{"sobol", sobol}, {"random", random}});
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
    using enum bvh::AccelKind;
    return store_word<bvh::AccelKind>(options.accel.emplace(), text,
                                      {{"none", none}, {"spheres", spheres}, {"boxes", boxes}});
}

std::string store_quality(Options& options, std::string_view text) {
    using enum bvh::BuildQuality;
    return store_word<bvh::BuildQuality>(options.quality.emplace(), text,
                                         {{"low", low}, {"medium", medium}, {"high", high}});
}

std::string store_shading(Options& options, std::string_view text) {
    using enum shade::Shader;
    return store_word<shade::Shader>(options.shader.emplace(), text,
                                     {{"full", full},
                                      {"flat", flat},
                                      {"normals", normals},
                                      {"uv", uv},
                                      {"depth", depth},
                                      {"cost", cost}});
}

std::string store_stats(Options& options, std::string_view text) {
    if (!text.empty() && text != "json") {
        return fmt::format("takes nothing or json, not `{}`", text);
    }
    options.stats = text.empty() ? StatsFormat::text : StatsFormat::json;
    return {};
}

std::string store_format(Options& options, std::string_view text) {
    options.is_film = text == kFilmFormat;
    options.format = image::find_format(text);
    return options.format || options.is_film
               ? std::string{}
               : fmt::format("takes ppm, png, jpg, pfm, exr or film, not `{}`", text);
}

std::string store_png_bits(Options& options, std::string_view text) {
    if (text != "8" && text != "16") return fmt::format("takes 8 or 16, not `{}`", text);
    options.png_bits = text == "8" ? image::PngBits::eight : image::PngBits::sixteen;
    return {};
}

std::string store_threshold(Options& options, std::string_view text) {
    const auto levels = parse_decimal(text);
    if (!levels || !(*levels >= 0.0 && *levels <= 255.0)) {
        return fmt::format("takes levels from 0 to 255, not `{}`", text);
    }
    options.threshold = static_cast<float>(*levels);
    return {};
}

std::string store_color(Options& options, std::string_view text) {
    using enum ColorMode;
    return store_word<ColorMode>(options.color, text,
                                 {{"auto", automatic}, {"always", always}, {"never", never}});
}

std::string store_diagnostics(Options& options, std::string_view text) {
    using Format = DiagnosticsFormat;
    return store_word<Format>(
        options.diagnostics_format, text,
        {{"text", Format::text}, {"json", Format::json}, {"sarif", Format::sarif}});
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
    const auto range = parse_range(text);
    if (!range || range->first > kMaxFrame || range->second > kMaxFrame) {
        return fmt::format("takes the first and the last frame like `0:95`, not `{}`", text);
    }
    if (range->first > range->second) return fmt::format("`{}` ends before it begins", text);
    options.frames = {range->first, range->second};
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
