// Places one light of the graph in the world.
#pragma once

#include <variant>

#include "base/transform.h"
#include "scene/light.h"

namespace lray::scene {

/// Why a light could not be placed.
enum class LightProblem : std::uint8_t {
    too_far,  // beyond the coordinates that a world holds
    no_area,  // an area light of no extent that the world holds
};

/// Returns the light under an invertible map, in world space. The radius of a soft light grows
/// with the root mean square of the map's scales.
std::variant<Light, LightProblem> place_light(const Light& light,
                                              const Transform& world_from_object);

}  // namespace lray::scene
