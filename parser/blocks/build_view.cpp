#include "parser/blocks/build_view.h"

#include <fmt/format.h>

#include <cmath>

#include "base/angle.h"
#include "base/numerics.h"
#include "parser/blocks/schemas.h"

namespace lray::parser {

namespace {

using namespace schemas;

scene::Resolution resolution_of(DVec2 size) {
    return {static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y)};
}

}  // namespace

std::optional<scene::Camera> build_camera(const PropertyValues& values, std::string_view name,
                                          Span span, Diagnostics& diagnostics) {
    constexpr std::size_t kPosition = slot(kCamera, "position");
    constexpr std::size_t kLookAt = slot(kCamera, "look_at");
    constexpr std::size_t kUp = slot(kCamera, "up");
    constexpr std::size_t kFov = slot(kCamera, "fov");
    constexpr std::size_t kProjection = slot(kCamera, "projection");
    constexpr std::size_t kHeight = slot(kCamera, "height");
    constexpr std::size_t kResolution = slot(kCamera, "resolution");
    constexpr std::size_t kBackground = slot(kCamera, "background");
    scene::Camera camera;
    camera.name = std::string(name);
    camera.position = values.vec3(kPosition);
    camera.look_at = values.vec3(kLookAt);
    camera.up = values.vec3(kUp);
    camera.fov = radians(values.number(kFov));
    camera.height = values.number(kHeight);
    camera.span = span;
    if (values.string(kProjection, "perspective") == "orthographic") {
        camera.projection = scene::Projection::orthographic;
    }
    if (values.has(kResolution)) camera.resolution = resolution_of(values.vec2(kResolution));
    camera.background = values.optional_color(kBackground);

    const DVec3 forward = camera.look_at - camera.position;
    if (forward == DVec3{0.0}) {
        diagnostics.error(Code::E0311, span, "`position` and `look_at` are the same point");
        return std::nullopt;
    }
    // Parallel as far as doubles can tell: the cross product is its own rounding error.
    const double sine_bound = 2.0 * gamma<double>(3);
    const DVec3 f =
        forward / std::max({std::fabs(forward.x), std::fabs(forward.y), std::fabs(forward.z)});
    const DVec3 u = camera.up / std::max({std::fabs(camera.up.x), std::fabs(camera.up.y),
                                          std::fabs(camera.up.z)});
    if (glm::length(cross(f, u)) <= sine_bound * glm::length(f) * glm::length(u)) {
        diagnostics.error(Code::E0311, span, "the camera looks along its `up` direction")
            .with_help(values.has(kUp) ? "choose another `up`"
                                       : "to look straight down, add `up: [0, 0, -1]`");
        return std::nullopt;
    }
    return camera;
}

scene::RenderSettings build_render_settings(const PropertyValues& values) {
    constexpr std::size_t kResolution = slot(kRender, "resolution");
    constexpr std::size_t kBackground = slot(kRender, "background");
    return {resolution_of(values.vec2(kResolution)), values.color(kBackground)};
}

}  // namespace lray::parser
