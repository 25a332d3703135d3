// Property values to cameras and render settings.
#pragma once

#include <optional>
#include <string_view>

#include "base/diagnostics.h"
#include "parser/blocks/property_values.h"
#include "scene/camera.h"

namespace lray::parser {

/// Returns the camera that the properties describe.
/// Errors: empty when it cannot look anywhere (E0311), reported at the block.
std::optional<scene::Camera> build_camera(const PropertyValues& values, std::string_view name,
                                          Span span, Diagnostics& diagnostics);

scene::RenderSettings build_render_settings(const PropertyValues& values);

}  // namespace lray::parser
