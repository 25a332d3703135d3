// The one entry to the language: a file in, a scene out.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/diagnostics.h"
#include "base/file_access.h"
#include "base/source.h"
#include "scene/scene.h"

namespace lray::parser {

struct LoadLimits {
    std::uint64_t scene_bytes = std::uint64_t{1} << 30;  // --max-scene-bytes, of all files
    std::uint64_t mesh_bytes = std::uint64_t{4} << 30;   // --max-mesh-bytes, of all files
    std::uint32_t nesting = 256;                         // --max-nesting
    std::uint32_t include_depth = 64;                    // --max-include-depth
    std::uint32_t files = 10'000;                        // --max-files
    std::uint64_t steps = 100'000'000;                   // --max-steps, of evaluation
    std::uint64_t value_bytes = std::uint64_t{1} << 30;  // --max-value-bytes, of what is computed

    /// Off: literal blocks go through the full parser. The scene is the same; for tests.
    bool use_literal_fast_path = true;
};

/// Reads, parses, checks and evaluates a scene with all it includes.
/// Errors: empty when any error was reported. Warnings may be reported either way.
std::optional<scene::Scene> load(std::string_view path, const LoadLimits& limits, FileAccess& files,
                                 Sources& sources, Diagnostics& diagnostics);

}  // namespace lray::parser
