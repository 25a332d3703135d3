// What goes together on the command line, what is chosen where nothing is said, and --help.
#include "cli/options.h"

#include <fmt/format.h>

#include <string_view>

#include "cli/commands.h"
#include "cli/frames.h"
#include "cli/option_table.h"
#include "cli/read_arguments.h"

namespace lray::cli {

namespace {

constexpr const char* kUsage = "lray -n 1 -i scene.lrs -o image.ppm";
constexpr std::uint64_t kMaxErrorsShown = 20;
constexpr float kUsualThreshold = 1.5f;  // levels: what rounding to 8 bits may do is below

/// The text as a shell reads it back: in quotes where it needs them.
std::string quoted(std::string_view text) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+:@%,=";
    if (!text.empty() && text.find_first_not_of(kPlain) == text.npos) return std::string(text);
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

/// "rooms/hall.lrs" -> "hall.ppm".
std::string suggested_output(std::string_view scene_path) {
    const std::size_t slash = scene_path.rfind('/');
    if (slash != scene_path.npos) scene_path.remove_prefix(slash + 1);
    const std::string_view extension = image::extension(scene_path);
    if (!extension.empty()) scene_path.remove_suffix(extension.size() + 1);
    return fmt::format("{}.ppm", scene_path == "-" ? "image" : scene_path);
}

/// A level that writes a picture has to be told where.
std::optional<Failure> check_output(const Options& options) {
    if (!options.output_path.empty()) return std::nullopt;
    const std::string fix =
        fmt::format("lray -n {} -i {} -o {}", *options.level, quoted(options.scene_path),
                    quoted(suggested_output(options.scene_path)));
    return usage_error(
        fmt::format("level {} writes a picture; say where with `-o`", *options.level), fix);
}

/// A window shows one frame, and saves pictures to files.
std::optional<Failure> check_window(const Options& options) {
    if (options.frames && options.frames->count() > 1) {
        return usage_error("a window shows one frame", "choose it with `--frame N`");
    }
    if (options.output_path == "-") {
        return usage_error("a window cannot save to stdout",
                           "name a file, or leave `-o` out: pictures get numbers then");
    }
    return std::nullopt;
}

std::optional<Failure> check_formatting(const Options& options) {
    if (options.output_path.empty()) return std::nullopt;
    if (options.only_lists_unformatted) {
        return usage_error("`--fmt --check` writes nothing; leave `-o` out");
    }
    if (options.paths.size() == 1) return std::nullopt;
    return usage_error(fmt::format("`-o` takes one scene, not {}", options.paths.size()),
                       "without `-o` each is written in its place");
}

std::optional<Failure> check_frames(const Options& options) {
    const bool is_several = options.frames && options.frames->count() > 1;
    if (is_several && options.scene_path == "-") {
        return usage_error("several frames need a scene that can be read again, not stdin");
    }
    if (is_several && options.diagnostics_format == DiagnosticsFormat::sarif) {
        return usage_error("a SARIF log is about one frame",
                           "`--diagnostics json` takes several, or choose one with `--frame N`");
    }
    return std::nullopt;
}

std::optional<Failure> check_numbering(const Options& options) {
    const bool is_several = options.frames && options.frames->count() > 1;
    if (!is_several || has_frame_number(options.output_path)) return std::nullopt;
    return usage_error(fmt::format("`-o {}` is one picture, for {} frames", options.output_path,
                                   options.frames->count()),
                       "put #### where the number of the frame belongs, like `-o out-####.png`");
}

std::optional<Failure> find_format(Options& options) {
    if (options.format || options.is_film) return std::nullopt;
    if (options.output_path == "-") {
        options.format = image::Format::ppm;
        return std::nullopt;
    }
    if (options.output_path.empty()) {  // of a window
        options.format = image::Format::png;
        return std::nullopt;
    }
    const std::string_view extension = image::extension(options.output_path);
    options.format = image::find_format(extension);
    options.is_film = extension == kFilmFormat;
    if (options.format || options.is_film) return std::nullopt;
    const std::string help =
        "end its name in .ppm, .png, .jpg, .pfm or .exr, or choose with "
        "`--format ppm|png|jpg|pfm|exr`";
    if (extension.empty()) {
        return usage_error(
            fmt::format("`{}` has no extension that names a format", options.output_path), help);
    }
    return usage_error(fmt::format("no picture format is called `{}`", extension), help);
}

std::optional<Failure> choose_format(Options& options) {
    if (auto failure = find_format(options)) return failure;
    if (options.is_film || image::is_built(*options.format)) return std::nullopt;
    return Failure{ExitCode::unbuilt, "this lray was built without OpenEXR",
                   "PFM holds the same light: `-o image.pfm`"};
}

/// Options of a format that is not written.
void warn_of_format(Options& options) {
    const auto warn = [&](std::string_view option, image::Format format) {
        if (options.format == format) return;
        const std::string_view chosen =
            options.is_film ? kFilmFormat : image::format_name(*options.format);
        options.warnings.push_back(fmt::format("`{}` is ignored: the picture is {}, not {}", option,
                                               chosen, image::format_name(format)));
    };
    if (options.png_bits) warn("--png-bits", image::Format::png);
    if (options.jpeg_quality) warn("--jpeg-quality", image::Format::jpg);
}

/// What a command has to be told.
std::optional<Failure> finish_command(const Command& command, Options& options) {
    if (auto failure = check_paths(command, options.paths.size())) return failure;
    options.threshold = options.threshold.value_or(kUsualThreshold);
    if (options.output_path.empty()) {
        if (command.mode == Mode::diff) return std::nullopt;
        return usage_error(
            fmt::format("`lray {}` writes a file; say where with `-o`", command.name),
            std::string(command.example));
    }
    if (auto failure = choose_format(options)) return failure;
    if (options.is_film && command.mode == Mode::diff) {
        return usage_error("a difference is a picture, no film", "end the name in .png");
    }
    warn_of_format(options);
    return std::nullopt;
}

std::optional<Failure> check_samples(const Options& options) {
    const auto& range = options.sample_range;
    if (!range || !options.samples || range->begin < *options.samples) return std::nullopt;
    return usage_error(fmt::format("`--samples {}:{}` begins behind the last of `-ps {}`",
                                   range->begin, range->end, *options.samples),
                       "they count from 0; without `-ps` the range alone says which");
}

/// A part of the samples is to be added to the other parts: it must be known which they are.
std::optional<Failure> check_limits(const Options& options) {
    if (!options.sample_range || !options.sample_limits.is_any()) return std::nullopt;
    return usage_error(fmt::format("`--samples {}:{}` and `{}` do not go together",
                                   options.sample_range->begin, options.sample_range->end,
                                   options.sample_limits.seconds ? "--time" : "--noise"),
                       "a part of the samples is always rendered whole; leave one of the two out");
}

/// Films are added up, and their samples with them: each pixel has the same.
std::optional<Failure> check_film(const Options& options) {
    if (!options.is_film) return std::nullopt;
    if (options.mode == Mode::window) {
        return usage_error("a window saves pictures, no films", "end the name in .png");
    }
    if (!options.sample_limits.is_any()) return std::nullopt;
    return usage_error(fmt::format("a film and `{}` do not go together",
                                   options.sample_limits.seconds ? "--time" : "--noise"),
                       "each pixel of a film has the same samples; say how many with `-ps N`");
}

std::optional<Failure> check_resume(const Options& options) {
    if (!options.is_resuming || options.output_path != "-") return std::nullopt;
    return usage_error("`--resume` cannot go on with what was written to stdout",
                       "name a file with `-o`: what there is is kept beside it");
}

/// A level is a set of defaults: what is given by hand stays.
void apply_level(Options& options) {
    const bool is_first = options.level == 1u;
    const bvh::AccelKind usual = is_first             ? bvh::AccelKind::none
                                 : options.level == 2 ? bvh::AccelKind::spheres
                                                      : bvh::AccelKind::boxes;
    options.accel = options.accel.value_or(usual);
    options.position = is_first ? render::PixelPosition::center : render::PixelPosition::random;
    if (is_first && !options.shader) options.shader = shade::Shader::flat;
}

void warn_of_ignored(Options& options) {
    if (options.quality && options.accel != bvh::AccelKind::boxes) {
        options.warnings.push_back(
            "`--quality` is ignored: only boxes have a choice; `--accel boxes` builds them");
    }
    if (options.is_resuming && options.mode == Mode::window) {
        options.warnings.push_back("`--resume` is ignored: a window begins anew");
    }
    if (options.position != render::PixelPosition::center) return;
    const auto warn = [&](const std::string& option) {
        options.warnings.push_back(fmt::format(
            "`{}` is ignored: level 1 sends one ray through the centre of each pixel", option));
    };
    if (options.samples.value_or(1) != 1) warn(fmt::format("-ps {}", *options.samples));
    if (const auto& range = options.sample_range) {
        warn(fmt::format("--samples {}:{}", range->begin, range->end));
    }
    if (options.seed) warn(fmt::format("--seed {}", *options.seed));
    if (options.sampler) warn("--sampler");
    if (options.sample_limits.seconds) warn("--time");
    if (options.sample_limits.noise) warn("--noise");
}

}  // namespace

std::variant<Options, Failure> parse_options(std::span<const char* const> arguments) {
    Options options;
    const Command* const command = arguments.empty() ? nullptr : find_command(arguments[0]);
    if (command != nullptr) {
        options.mode = command->mode;
        arguments = arguments.subspan(1);
    }
    if (auto failure = read_arguments(arguments, command, options)) return *failure;
    switch (options.mode) {
        case Mode::explain:
        case Mode::help:
        case Mode::version:
            return options;
        case Mode::diff:
        case Mode::merge:
            if (auto failure = finish_command(*command, options)) return *failure;
            return options;
        case Mode::check:
        case Mode::deps:
        case Mode::dump:
        case Mode::format:
        case Mode::render:
        case Mode::window:
            break;
    }
    if (options.threshold) {
        return usage_error("`--threshold` is an option of `lray diff`", "lray diff a.png b.png");
    }
    const bool is_text = options.diagnostics_format == DiagnosticsFormat::text;
    if (!options.max_errors) options.max_errors = is_text ? kMaxErrorsShown : 0;
    if (options.is_formatting) {
        options.only_lists_unformatted = options.mode == Mode::check;
        options.mode = Mode::format;
        if (options.paths.empty()) {
            return usage_error("no scene is given", "lray --fmt scene.lrs");
        }
        if (auto failure = check_formatting(options)) return *failure;
        return options;
    }
    if (options.scene_path.empty()) return usage_error("no scene is given", kUsage);
    if (auto failure = check_frames(options)) return *failure;
    if (options.mode == Mode::dump) {
        if (options.frames && options.frames->count() > 1) {
            return usage_error("`--dump` writes one frame", "choose it with `--frame N`");
        }
        if (options.output_path.empty()) options.output_path = std::string("-");
    }
    if (options.mode != Mode::render) return options;
    const bool is_level_of_window = options.level.value_or(3) == 3;
    if (is_level_of_window && (options.level || options.output_path.empty())) {
        options.mode = Mode::window;
    }
    const auto check_target = options.mode == Mode::window ? check_window : check_output;
    if (auto failure = check_target(options)) return *failure;
    if (auto failure = check_numbering(options)) return *failure;
    if (auto failure = choose_format(options)) return *failure;
    if (auto failure = check_samples(options)) return *failure;
    if (auto failure = check_limits(options)) return *failure;
    if (auto failure = check_film(options)) return *failure;
    if (auto failure = check_resume(options)) return *failure;
    apply_level(options);
    warn_of_format(options);
    warn_of_ignored(options);
    return options;
}

std::string help_text() {
    std::string text = fmt::format(
        "lray {}: renders scenes written in the .lrs language\n\n"
        "usage: lray scene.lrs\n"
        "       {}\n"
        "       lray -n 2 -ps 16 -i scene.lrs -o image.ppm\n"
        "       lray scene.lrs -o image.png\n"
        "       lray --check scene.lrs\n"
        "       lray --fmt scene.lrs\n\n"
        "Options may have one or two dashes; the last one given counts.\n",
        LRAY_VERSION, kUsage);
    text += "\nCommands:\n";
    for (const Command& command : commands()) {
        text += fmt::format("  {:<24} {}\n", fmt::format("{} {}", command.name, command.arguments),
                            command.help);
    }
    for (const OptionGroup& group : option_groups()) {
        text += fmt::format("\n{}:\n", group.title);
        for (std::size_t i = 0; i < group.options.size(); ++i) {
            const OptionSpec& spec = group.options[i];
            if (*spec.help == '\0') continue;
            const std::string value =
                spec.takes_value()
                    ? fmt::format("{}{}", spec.may_take_value() ? "" : " ", spec.value)
                    : "";
            std::string names = spelled(spec.name) + value;
            for (std::size_t k = i + 1; k < group.options.size() && *group.options[k].help == '\0';
                 ++k) {
                names += fmt::format(", {}{}", spelled(group.options[k].name), value);
            }
            text += fmt::format("  {:<24} {}\n", names, spec.help);
        }
    }
    return text;
}

std::string version_text() {
    return fmt::format("lray {}\n", LRAY_VERSION);
}

}  // namespace lray::cli
