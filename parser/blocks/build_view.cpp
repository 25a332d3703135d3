#include "parser/blocks/build_view.h"

#include <fmt/format.h>

#include <cmath>

#include "base/angle.h"
#include "parser/blocks/schemas.h"
#include "scene/camera_direction.h"

namespace lray::parser {

namespace {

using namespace schemas;

static_assert(kProjections[static_cast<std::size_t>(scene::Projection::orthographic)] ==
              "orthographic");
static_assert(kProjections[static_cast<std::size_t>(scene::Projection::panorama)] == "panorama");
static_assert(kToneMaps[static_cast<std::size_t>(scene::ToneMap::reinhard)] == "reinhard");
static_assert(kToneMaps[static_cast<std::size_t>(scene::ToneMap::aces)] == "aces");
static_assert(kGammas[static_cast<std::size_t>(scene::Gamma::linear)] == "linear");
static_assert(kIntegrators[static_cast<std::size_t>(scene::Integrator::path)] == "path");
static_assert(kSamplers[static_cast<std::size_t>(scene::SamplerKind::random)] == "random");

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
    constexpr std::size_t kSamples = slot(kCamera, "samples");
    constexpr std::size_t kBackground = slot(kCamera, "background");
    scene::Camera camera;
    camera.name = std::string(name);
    camera.position = values.vec3(kPosition);
    camera.look_at = values.vec3(kLookAt);
    camera.up = values.vec3(kUp);
    camera.fov = radians(values.number(kFov));
    camera.height = values.number(kHeight);
    camera.span = span;
    camera.projection = values.option<scene::Projection>(kProjection);
    camera.aperture = values.number(slot(kCamera, "aperture"));
    if (values.has(kResolution)) camera.resolution = resolution_of(values.vec2(kResolution));
    if (values.has(kSamples)) camera.samples = values.integer(kSamples);
    camera.background = values.optional_color(kBackground);

    const DVec3 forward = camera.look_at - camera.position;
    if (forward == DVec3{0.0}) {
        diagnostics.error(Code::E0311, span, "`position` and `look_at` are the same point");
        return std::nullopt;
    }
    if (scene::is_along_up(forward, camera.up)) {
        diagnostics.error(Code::E0311, span, "the camera looks along its `up` direction")
            .with_help(values.has(kUp) ? "choose another `up`"
                                       : "to look straight down, add `up: [0, 0, -1]`");
        return std::nullopt;
    }
    constexpr std::size_t kFocus = slot(kCamera, "focus");
    if (values[kFocus].is(ValueKind::number)) {
        camera.focus = values.number(kFocus);
    } else if (values.has(kFocus)) {  // how far the plane through the point is
        const double distance =
            dot(values.vec3(kFocus) - camera.position, forward / glm::length(forward));
        if (!(distance > 0.0)) {
            diagnostics.error(Code::E0304, span, "`focus` must be in front of the camera");
            return std::nullopt;
        }
        camera.focus = distance;
    }
    return camera;
}

scene::RenderSettings build_render_settings(const PropertyValues& values) {
    scene::RenderSettings settings;
    settings.resolution = resolution_of(values.vec2(slot(kRender, "resolution")));
    settings.samples = values.integer(slot(kRender, "samples"));
    settings.max_depth = values.integer(slot(kRender, "max_depth"));
    settings.background = values.color(slot(kRender, "background"));
    settings.ambient = values.color(slot(kRender, "ambient"));
    settings.exposure = values.number(slot(kRender, "exposure"));
    settings.tonemap = values.option<scene::ToneMap>(slot(kRender, "tonemap"));
    settings.gamma = values.option<scene::Gamma>(slot(kRender, "gamma"));
    settings.seed = static_cast<std::uint64_t>(values.number(slot(kRender, "seed")));
    settings.integrator = values.option<scene::Integrator>(slot(kRender, "integrator"));
    settings.sampler = values.option<scene::SamplerKind>(slot(kRender, "sampler"));
    settings.transparent_shadows = values.boolean(slot(kRender, "transparent_shadows"));
    return settings;
}

}  // namespace lray::parser
