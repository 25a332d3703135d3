// Reads the Neutral File Format.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "base/diagnostics.h"
#include "base/source.h"
#include "scene/formats/nff_scene.h"

namespace lray::scene {

/// What a scene may hold, and how much of that it holds already.
struct NffLimits {
    std::uint64_t nodes = std::numeric_limits<std::uint32_t>::max();  // --max-nodes
    std::uint64_t used_nodes = 0;
    /// --max-value-bytes, of surfaces and lights
    std::uint64_t value_bytes = std::numeric_limits<std::uint64_t>::max();
};

/// Returns what the NFF file held in `sources` says: `v`, `b`, `l`, `f`, `s`, `c`, `p`, `pp` and
/// comments from `#` to the end of their line. Blanks and line ends may stand anywhere between
/// words; `hither` is read and means nothing to who traces rays. Polygons of any form are cut into
/// triangles.
/// Errors: empty when one was reported at its place in the file: E0003 binary, E0304 a number out
/// of range, E0311 no direction of view, E0405 a second `v` or `b`, E0513 and E0516 beyond the
/// limits, E0705 too many corners, E0706 everything else.
/// Source: Haines 1987, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), and the
/// description of NFF 3.1 that comes with the databases.
std::optional<NffScene> read_nff(const Sources& sources, SourceId file, const NffLimits& limits,
                                 Diagnostics& diagnostics);

}  // namespace lray::scene
