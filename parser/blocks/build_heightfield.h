// Property values to meshes of heights: from a function, lists, a picture, or a terrain's seed.
#pragma once

#include <array>
#include <optional>

#include "base/diagnostics.h"
#include "parser/blocks/property_values.h"
#include "parser/builtins/builtins.h"
#include "parser/file_loader.h"
#include "parser/values/operators.h"
#include "scene/scene.h"

namespace lray::parser {

/// A heightfield's or terrain's properties, and where they were written.
struct HeightProperties {
    const PropertyValues& values;
    const std::array<Span, kMaxProperties>& value_spans;
    Span span{};  // of the block

    /// Where a property's value stands; the block, if it was taken over from another.
    Span span_of(std::size_t slot) const {
        return value_spans[slot].is_nowhere() ? span : value_spans[slot];
    }
};

/// What building takes and adds to.
struct HeightBuild {
    FileLoader& files;
    Budget& budget;
    Runtime& runtime;
    scene::Scene& scene;
    Diagnostics& diagnostics;
};

/// Returns the use of the mesh that a `heightfield` describes, which joins the scene.
/// Errors: empty; E0301 and E0304 for heights that are not numbers or do not fit a float, what the
/// function reports, E0512 and E0516 before memory is taken, E06.. and E0703 for the picture.
std::optional<scene::MeshUse> build_heightfield(const HeightProperties& properties,
                                                const HeightBuild& build);

/// Returns the use of the mesh that a `terrain` describes, which joins the scene.
/// Errors: empty; E0304 for a size that does not fit a float, E0512 and E0516 before memory is
/// taken.
std::optional<scene::MeshUse> build_terrain(const HeightProperties& properties,
                                            const HeightBuild& build);

}  // namespace lray::parser
