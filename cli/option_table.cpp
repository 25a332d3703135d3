#include "cli/option_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

#include "cli/memory_limit.h"
#include "cli/option_values.h"

namespace lray::cli {

namespace {

constexpr std::uint64_t kMaxDepth = 1000;  // what is nested is read by recursion
constexpr std::uint64_t kMaxCallDepth = 10'000;
constexpr std::uint64_t kMaxThreads = 1024;

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
    OptionSpec{"n", "LEVEL",
               "1: one ray per pixel, no hierarchy; 2: random rays, bounding spheres; 3: a window",
               store_level},
    OptionSpec{"i", "FILE", "the scene; - is stdin; -i may be left out",
               [](Options& o, Value v) { return store_path(o.scene_path, v); }},
    OptionSpec{"o", "FILE", "the picture; - is stdout; without it a window is opened",
               [](Options& o, Value v) { return store_path(o.output_path, v); }},
    OptionSpec{"ps", "N", "rays per pixel", store_samples},
    OptionSpec{"spp", "N", "", store_samples},
    OptionSpec{"samples", "A:B", "of these rays those from A to B, B excluded", store_sample_range},
    OptionSpec{"resume", "", "go on where the same command was interrupted",
               set<&Options::is_resuming, true>},
    OptionSpec{"save-every", "DURATION", "how often --resume saves what there is, 30s if not said",
               [](Options& o, Value v) { return store_duration(o.save_seconds, v); }},
    OptionSpec{"time", "DURATION", "rays for so long, like 30s; 500ms, 5m and 2h too", store_time},
    OptionSpec{"noise", "E", "rays until the standard error of each pixel is so small, 1 is white",
               store_noise},
    OptionSpec{"sampler", "KIND", "sobol, spread evenly, or random", store_sampler},
    OptionSpec{"seed", "N", "other random rays",
               [](Options& o, Value v) { return store_number(o.seed.emplace(), v, 0); }},
    OptionSpec{"size", "WxH", "size of the picture in pixels", store_size},
    OptionSpec{"crop", "X0,Y0,X1,Y1", "only these pixels, from the top left, X1 and Y1 excluded",
               store_crop},
    OptionSpec{"camera", "NAME", "which camera of the scene; the first one otherwise",
               keep<&Options::camera_name>},
    OptionSpec{"format", "KIND", "ppm, png, jpg, pfm, exr or film; otherwise by the extension",
               store_format},
    OptionSpec{"png-bits", "8|16", "of each channel of a PNG; 8", store_png_bits},
    OptionSpec{
        "jpeg-quality", "N", "1 to 100; 90",
        [](Options& o, Value v) { return store_number(o.jpeg_quality.emplace(), v, 1, 100); }},
    OptionSpec{"threshold", "T", "of diff: levels of 255 that a pixel may be off; 1.5",
               store_threshold},
    OptionSpec{"accel", "KIND", "the hierarchy: none, spheres or boxes; the picture is the same",
               store_accel},
    OptionSpec{"quality", "HOW", "of boxes, low, medium or high: how long the building may take",
               store_quality},
    OptionSpec{"shading", "WHAT", "full, flat, normals, uv, depth or cost (tests per ray)",
               store_shading},
    OptionSpec{"D", "NAME=VALUE", "the value of a param of the scene", store_definition},
    OptionSpec{"frame", "N", "this frame of the animation", store_frame},
    OptionSpec{"frames", "A:B", "frames A to B; #### in -o FILE is the number", store_frames},
    OptionSpec{"threads", "N", "0: all; the picture does not depend on it",
               [](Options& o, Value v) { return store_number(o.thread_count, v, 0, kMaxThreads); }},
};

constexpr std::array kInsteadOptions{
    OptionSpec{"check", "", "look for mistakes in the scene, render nothing",
               set<&Options::mode, Mode::check>},
    OptionSpec{"fmt", "",
               "write scenes in the canonical style; with --check, list those that are not",
               set<&Options::is_formatting, true>},
    OptionSpec{"dump", "", "write the scene evaluated: no loops, no functions, the same picture",
               set<&Options::mode, Mode::dump>},
    OptionSpec{"deps", "", "the files that the scene reads, one per line",
               set<&Options::mode, Mode::deps>},
    OptionSpec{"explain", "WORD", "what a code like E0401, a block, a function or a topic means",
               store_explained},
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
    OptionSpec{"stats", "[=json]", "what was rendered and how long it took", store_stats},
    OptionSpec{"quiet", "", "no progress and no notes", set<&Options::quiet, true>},
    OptionSpec{"color", "WHEN", "auto, always or never", store_color},
    OptionSpec{"max-errors", "N", "show at most so many errors; 0: all",
               [](Options& o, Value v) { return store_number(o.max_errors.emplace(), v, 0); }},
    OptionSpec{"diagnostics", "FORM", "text, json (a line each) or sarif", store_diagnostics},
    OptionSpec{"W", "WARNING", "tell this warning, by code or name; all",
               [](Options& o, Value v) { return store_warning_level(o, v, WarningLevel::warn); }},
    OptionSpec{"A", "WARNING", "do not tell this warning; all",
               [](Options& o, Value v) { return store_warning_level(o, v, WarningLevel::allow); }},
    OptionSpec{"deny", "WARNING", "treat this warning as an error; warnings: all that are told",
               [](Options& o, Value v) { return store_warning_level(o, v, WarningLevel::deny); }},
};

/// A limit of loading: its option.
template <auto member, std::uint64_t low = 1,
          std::uint64_t high = std::numeric_limits<std::uint64_t>::max()>
constexpr OptionSpec load_limit(const char* name, const char* help) {
    OptionSpec spec{name, "N", help};
    spec.apply = [](Options& o, Value v) {
        using Integer = std::remove_reference_t<decltype(o.load_limits.*member)>;
        constexpr std::uint64_t kLargest = std::numeric_limits<Integer>::max();
        return store_number(o.load_limits.*member, v, low, std::min(high, kLargest));
    };
    spec.value_of = [](const Options& o) { return std::uint64_t{o.load_limits.*member}; };
    return spec;
}

using parser::LoadLimits;

constexpr std::array kLimitOptions{
    load_limit<&LoadLimits::nesting, 1, kMaxDepth>("max-nesting",
                                                   "brackets and blocks inside one another"),
    load_limit<&LoadLimits::include_depth, 0, kMaxDepth>("max-include-depth",
                                                         "files that include one another"),
    load_limit<&LoadLimits::files>("max-files", "files of a scene"),
    load_limit<&LoadLimits::scene_bytes>("max-scene-bytes",
                                         "size of the scene and what it includes"),
    load_limit<&LoadLimits::mesh_bytes>("max-mesh-bytes", "size of its mesh files in all"),
    load_limit<&LoadLimits::texture_bytes>("max-texture-bytes", "size of its picture files in all"),
    load_limit<&LoadLimits::texture_pixels>("max-texture-pixels", "pixels of its pictures in all"),
    load_limit<&LoadLimits::steps>("max-steps", "steps of evaluation"),
    load_limit<&LoadLimits::call_depth, 1, kMaxCallDepth>("max-call-depth",
                                                          "calls inside one another"),
    load_limit<&LoadLimits::list_size>("max-list-size", "elements of one list"),
    load_limit<&LoadLimits::value_bytes>("max-value-bytes", "memory for the values of a scene"),
    load_limit<&LoadLimits::nodes>("max-nodes", "shapes, groups and instances as written"),
    load_limit<&LoadLimits::printed_bytes>("max-printed-bytes", "text that the scene prints"),
    load_limit<&LoadLimits::import_seconds, 1, 1'000'000>("max-import-seconds",
                                                          "time to import one mesh file"),
    load_limit<&LoadLimits::import_bytes>("max-import-bytes", "memory to import one mesh file"),
    OptionSpec{"max-primitives", "N", "triangles, spheres and so on in all",
               [](Options& o, Value v) { return store_number(o.flatten_limits.primitives, v, 1); },
               [](const Options& o) { return std::uint64_t{o.flatten_limits.primitives}; }},
    OptionSpec{"max-lights", "N", "lights in all",
               [](Options& o, Value v) { return store_number(o.flatten_limits.lights, v, 1); },
               [](const Options& o) { return std::uint64_t{o.flatten_limits.lights}; }},
    OptionSpec{"max-output-pixels", "N", "pixels of the picture",
               [](Options& o, Value v) { return store_number(o.max_output_pixels, v, 1); },
               [](const Options& o) { return o.max_output_pixels; }},
    OptionSpec{"max-memory", "N", "bytes of memory in all; 0: whatever the system gives",
               [](Options& o, Value v) { return store_number(o.max_memory.emplace(), v, 0); },
               [](const Options& o) { return memory_limit(o.max_memory); }},
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
