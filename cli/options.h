// What the command line asks for.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/warning_levels.h"
#include "bvh/accel.h"
#include "cli/exit_code.h"
#include "image/write.h"
#include "parser/load.h"
#include "render/options.h"
#include "scene/camera.h"
#include "scene/flatten.h"
#include "shade/shader.h"

namespace lray::cli {

enum class Mode : std::uint8_t {
    render,
    window,
    check,
    format,
    dump,
    deps,
    explain,
    diff,
    merge,
    help,
    version
};
enum class ColorMode : std::uint8_t { automatic, always, never };

enum class DiagnosticsFormat : std::uint8_t { text, json, sarif };
enum class StatsFormat : std::uint8_t { none, text, json };

/// Frames of an animation, both ends included.
struct FrameRange {
    std::uint64_t first = 0;
    std::uint64_t last = 0;

    std::uint64_t count() const { return last - first + 1; }
    friend bool operator==(const FrameRange&, const FrameRange&) = default;
};

struct Options {
    Mode mode = Mode::render;
    std::string scene_path{};   // "-" is stdin
    std::string output_path{};  // "-" is stdout
    std::string explained{};    // the code or topic that --explain asks for

    bool is_formatting = false;           // --fmt, whatever else is asked for
    bool only_lists_unformatted = false;  // --fmt --check
    std::vector<std::string> paths{};     // of --fmt and of commands, in order

    std::optional<std::uint32_t> level{};
    std::optional<std::uint32_t> samples{};             // -ps: rays per pixel
    std::optional<render::SampleRange> sample_range{};  // --samples: only these of them
    std::optional<std::uint64_t> seed{};
    std::optional<scene::Resolution> size{};
    std::optional<render::PixelRect> crop{};
    std::optional<std::string> camera_name{};
    std::optional<image::Format> format{};  // always set once parsed, if a picture is asked for
    bool is_film = false;                   // -o takes the film, in place of a picture
    bool is_resuming = false;               // --resume
    double save_seconds = 30.0;             // --save-every: between two states of --resume
    std::optional<image::PngBits> png_bits{};
    std::optional<int> jpeg_quality{};
    std::optional<float> threshold{};            // of diff, in levels; always set once parsed
    std::optional<bvh::AccelKind> accel{};       // set once parsed, by the level if it is not given
    std::optional<bvh::BuildQuality> quality{};  // of boxes; medium if it is not given
    render::PixelPosition position = render::PixelPosition::random;  // by the level
    std::optional<shade::Shader> shader{};  // set once parsed at level 1; else the scene decides
    std::optional<SamplerKind> sampler{};
    render::SampleLimits sample_limits{};  // --time, --noise
    std::uint32_t thread_count = 0;        // 0: all

    std::vector<parser::Definition> definitions{};  // -D, in order
    std::optional<FrameRange> frames{};             // --frame, --frames
    std::string frame_label{};                      // "frame 3 of 8", of one of several

    std::vector<std::string> include_directories{};  // -I, in order
    std::vector<std::string> allowed_directories{};  // --allow

    ColorMode color = ColorMode::automatic;
    DiagnosticsFormat diagnostics_format = DiagnosticsFormat::text;
    std::optional<std::uint64_t> max_errors{};  // set once parsed; machines get all by default
    WarningLevels warning_levels{};
    StatsFormat stats = StatsFormat::none;
    bool quiet = false;

    parser::LoadLimits load_limits{};
    scene::FlattenLimits flatten_limits{};
    std::uint64_t max_output_pixels = std::uint64_t{1} << 28;
    std::optional<std::uint64_t> max_memory{};  // bytes; 0: whatever the system gives

    std::vector<std::string> warnings{};  // options that have no effect, in words
};

/// The extension and the name of the format of films.
inline constexpr std::string_view kFilmFormat = "film";

/// Reads the arguments (without the program's name). Every option may have one or two dashes and
/// its value in the next argument or after `=`; names are never abbreviated; the last one given
/// counts. --help, --version and --explain need nothing else.
/// A first argument that names a command (commands.h) is followed by its files.
/// Errors: a usage error for what is unknown, missing or does not go together; ExitCode::unbuilt
/// for a format that lray was built without.
std::variant<Options, Failure> parse_options(std::span<const char* const> arguments);

/// What --help prints.
std::string help_text();

/// What --version prints.
std::string version_text();

}  // namespace lray::cli
