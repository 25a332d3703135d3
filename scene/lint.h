// Looks at a scene as a whole for what is allowed but hardly meant, and warns of it.
#pragma once

#include <optional>

#include "base/diagnostics.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace lray::scene {

struct LintSettings {
    std::optional<Resolution> resolution{};  // of the picture, in place of the scene's own
    bool expects_light = false;              // the picture is to show light, if there is any
};

/// Warns of a camera inside an object (W1203), a light inside an opaque one (W1204), a view of
/// nothing (W1205), shapes in the same place (W1206) and, if that is asked for, mirrored nodes
/// (W1303) and a scene without light (W1502). Each is told only where it is sure: what might be
/// meant is left alone. `world` is the flattened `scene`. The time is proportional to the
/// primitives, and small beside flatten()'s.
void lint(const Scene& scene, const World& world, const LintSettings& settings,
          Diagnostics& diagnostics);

}  // namespace lray::scene
