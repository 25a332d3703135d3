// Turns the authored graph into the world that is traced.
#pragma once

#include <cstdint>
#include <optional>

#include "base/diagnostics.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace lray::scene {

struct FlattenLimits {
    std::uint64_t primitives = 50'000'000;  // --max-primitives
};

/// Returns the world-space primitives of everything under the scene's root, in the order of the
/// graph. A sphere under a similarity stays a sphere; other quadrics carry their inverse map.
/// Errors: empty when something cannot be placed: a singular or overflowing transform (E0310), or
/// more primitives than the limit (E0513).
std::optional<World> flatten(const Scene& scene, const FlattenLimits& limits,
                             Diagnostics& diagnostics);

}  // namespace lray::scene
