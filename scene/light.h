// Lights, as they are authored and as the world holds them. A light shines along its local -Z axis
// unless it says otherwise; an area light faces down. Defaults are those of the language.
#pragma once

#include <cstdint>
#include <variant>

#include "base/vec.h"
#include "scene/ids.h"

namespace lray::scene {

/// How light of a point or spot light decreases with the distance d: L / (4 pi d^2), with d or
/// nothing in the place of d^2 for `linear` and `none`.
enum class Falloff : std::uint8_t { quadratic, linear, none };

struct PointLight {
    DVec3 position{0.0};
    Falloff falloff = Falloff::quadratic;
    double radius = 0.0;  // of the ball that casts soft shadows
    std::uint32_t samples = 1;
};

/// Full strength within the inner part of the cone, fading to 0 at its rim.
struct SpotLight {
    DVec3 position{0.0};
    DVec3 direction{0.0, 0.0, -1.0};         // unit, away from the light
    double angle = 0.698131700797731751354;  // of the full cone, radians: 40 degrees
    double softness = 0.2;                   // the share of the cone's half angle that fades
    Falloff falloff = Falloff::quadratic;
    double radius = 0.0;
    std::uint32_t samples = 1;
};

struct DirectionalLight {
    DVec3 direction{0.0, 0.0, -1.0};  // unit, the way the light goes
    double angle = 0.0;               // diameter of the source as seen, radians
    std::uint32_t samples = 1;
};

/// A parallelogram, corner + u edge_u + v edge_v, that shines to the side of edge_u x edge_v.
struct AreaLight {
    DVec3 corner{-0.5, 0.0, -0.5};
    DVec3 edge_u{1.0, 0.0, 0.0};
    DVec3 edge_v{0.0, 0.0, 1.0};
    std::uint32_t samples = 16;
};

/// Light from everywhere. Of a texture in uv, u runs around the Y axis, 0.5 in the direction -Z
/// and rising towards +X; v runs from straight down (0) to straight up (1).
struct EnvironmentLight {
    TextureId texture_id{};       // none: the colour alone
    DMat3 light_from_world{1.0};  // directions; the identity as authored
    std::uint32_t samples = 16;
};

using LightShape =
    std::variant<PointLight, SpotLight, DirectionalLight, AreaLight, EnvironmentLight>;

/// In the space of its node. `intensity`: of a point or spot light the L of its formula, of a
/// directional light its irradiance, of an area light its power in all, of an environment its
/// radiance.
struct Light {
    LightShape shape{};
    Color color{1.0f};
    double intensity = 500.0;
};

/// A light in one place of the graph. Space: world. A scale above it moves and stretches a light,
/// and leaves its intensity as it is. What is above does not make its light pass through things:
/// only its own `casts_shadow` does.
struct WorldLight {
    Light light{};
    NodeId node_id{};
    bool visible = true;  // itself, in the picture; it shines in any case
    bool casts_shadow = true;
};

}  // namespace lray::scene
