// Turns the authored graph into the world that is traced.
#pragma once

#include <cstdint>
#include <optional>

#include "base/diagnostics.h"
#include "scene/flatten_plan.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace lray::scene {

struct FlattenLimits {
    std::uint64_t primitives = 50'000'000;  // --max-primitives, as they are stored
    std::uint64_t lights = 100'000;         // --max-lights, those of instances counted each
    SharingRule sharing{};
    KeptSpaces spaces = KeptSpaces::where_textured;
};

/// Returns the primitives and lights of everything under the scene's root, in the order of the
/// graph. What is placed often is stored once (flatten_plan.h), in the space of its node moved to
/// have it near the origin, and instances place it; all else, and every light, is in world space. A
/// sphere under a similarity stays a sphere; other quadrics carry their inverse
/// map. Shapes and faces without area are dropped with a warning (W1201, W1702). Errors: empty when
/// something cannot be placed: a singular or overflowing transform (E0310), coordinates or sizes
/// that the world does not hold (E0304, placer.h), or more primitives, lights or places than the
/// limit (E0513), which is found before anything is made, or a second environment (E0405). The
/// pictures of textures are not copied: the scene has to outlive the world.
std::optional<World> flatten(const Scene& scene, const FlattenLimits& limits,
                             Diagnostics& diagnostics);

}  // namespace lray::scene
