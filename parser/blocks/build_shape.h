// Property values to shapes of the scene.
#pragma once

#include <cstdint>
#include <optional>

#include "base/diagnostics.h"
#include "parser/blocks/property_values.h"
#include "parser/blocks/schema.h"
#include "scene/scene.h"

namespace lray::parser {

/// A shape in its scene: what a node refers to.
struct ShapeRef {
    scene::NodeKind kind{};
    std::uint32_t index = 0;
};

/// Returns the unit vector, whatever the magnitude of a direction that is not 0.
DVec3 unit(DVec3 direction);

/// True if the vectors are parallel as far as doubles can tell.
bool are_parallel(DVec3 u, DVec3 v);

/// Returns the rectangle around `center` whose frame u = +X, v = -Z, n = +Y is turned onto `normal`
/// by the shortest arc. `normal` is not 0.
scene::RectangleShape facing_rectangle(DVec3 center, DVec2 size, DVec3 normal);

/// Adds the shape that the properties describe to the scene. Not for groups, meshes
/// and lights.
/// Errors: empty when the properties contradict each other (E0304, E0411), reported at the block;
/// warns W1201 of a shape without area.
std::optional<ShapeRef> build_shape(const BlockSchema& schema, const PropertyValues& values,
                                    Span span, scene::Scene& scene, Diagnostics& diagnostics);

}  // namespace lray::parser
