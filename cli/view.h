// Which camera, size, part of the picture and samples: the command line over the camera over the
// scene.
#pragma once

#include <variant>

#include "cli/exit_code.h"
#include "cli/options.h"
#include "render/view.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace lray::cli {

using render::View;

/// True if the picture shows light where the scene has it: no other shading is asked for.
bool expects_light(const Options& options);

/// Chooses the view. A scene without a camera gets one that sees all of the world.
/// Errors: a usage error for an unknown camera or a crop that leaves the picture, a limit error
/// for a picture of more pixels than allowed.
std::variant<View, Failure> choose_view(const scene::Scene& scene, const scene::World& world,
                                        const Options& options);

}  // namespace lray::cli
