// The one entry to the language: a file in, a scene out.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/file_access.h"
#include "base/source.h"
#include "scene/scene.h"

namespace lray::parser {

struct LoadLimits {
    std::uint64_t scene_bytes = std::uint64_t{1} << 30;      // --max-scene-bytes, of all files
    std::uint64_t mesh_bytes = std::uint64_t{4} << 30;       // --max-mesh-bytes, of all files
    std::uint64_t texture_bytes = std::uint64_t{256} << 20;  // --max-texture-bytes, of all files
    std::uint64_t texture_pixels = std::uint64_t{1} << 26;   // --max-texture-pixels, of all files
    std::uint32_t nesting = 256;                             // --max-nesting
    std::uint32_t include_depth = 64;                        // --max-include-depth
    std::uint32_t files = 10'000;                            // --max-files
    std::uint64_t steps = 100'000'000;                       // --max-steps, of evaluation
    std::uint64_t value_bytes = std::uint64_t{1} << 30;    // --max-value-bytes, of what is computed
    std::uint32_t call_depth = 1000;                       // --max-call-depth
    std::uint64_t list_size = 100'000'000;                 // --max-list-size, elements of one list
    std::uint64_t nodes = 50'000'000;                      // --max-nodes, of the scene as written
    std::uint64_t printed_bytes = std::uint64_t{1} << 20;  // --max-printed-bytes
    std::uint32_t import_seconds = 60;                     // --max-import-seconds, of one file
    std::uint64_t import_bytes = std::uint64_t{4} << 30;   // --max-import-bytes, memory for one
};

/// `-D name=value`: replaces the default of a `param`.
struct Definition {
    std::string name{};  // `lib.name` for a param of an import
    std::string value{};
};

struct LoadSettings {
    LoadLimits limits{};
    std::vector<Definition> definitions{};
    std::string importer{};  // the program that imports other meshes than OBJ and PLY; empty: none
    double frame = 0.0;      // of the animation: `frame`, and `time` = start + frame / fps
    std::function<void(std::string_view)> print{};  // takes each printed line; none: dropped

    /// Off: no literal fast path, and components are evaluated at each use. The scene is the same;
    /// for tests.
    bool use_literal_fast_path = true;
    bool use_memo = true;
};

/// So many params are listed, of so many choices each.
inline constexpr std::size_t kMaxListedParams = 1000;
inline constexpr std::size_t kMaxListedChoices = 1000;
/// Bytes of the text of a value that is listed, and of all choices together.
inline constexpr std::size_t kMaxParamText = 1000;
inline constexpr std::size_t kMaxChoicesText = std::size_t{1} << 20;

/// The numbers that a param may be, both ends included.
struct ParamRange {
    double least = 0.0;
    double greatest = 0.0;
    double value = 0.0;
    double default_value = 0.0;
    bool is_whole = false;  // whole numbers alone
};

/// A param with the value that it had, and what it may be. A `literal` is text that `-D name=`
/// reads as the same value, to the bit.
struct ParamValue {
    std::string name{};  // `lib.name` for a param of an import
    Span place{};        // of the name
    std::string value{};
    std::string default_value{};
    bool has_literals = false;          // else both are as a message shows them
    std::optional<ParamRange> range{};  // a number between bounds
    std::vector<std::string>
        choices{};  // one of these literals; without range and choices: anything
};

struct LoadResult {
    std::optional<scene::Scene> scene{};        // empty when any error was reported
    std::vector<std::string> usage_mistakes{};  // of the definitions, a sentence each
    /// The params that were evaluated and fit, in that order; after an error those before it. Some
    /// may not be listed where there are very many.
    std::vector<ParamValue> params{};
};

/// Reads, parses, checks and evaluates a scene with all it includes and imports.
/// Errors: no scene, reported; or what is wrong with the definitions, in `usage_mistakes`.
/// Warnings may be reported either way.
LoadResult load(std::string_view path, const LoadSettings& settings, FileAccess& files,
                Sources& sources, Diagnostics& diagnostics);

}  // namespace lray::parser
