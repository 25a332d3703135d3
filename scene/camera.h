// Cameras and the settings of a render. Defaults are those of the language.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "base/source.h"
#include "base/vec.h"

namespace lray::scene {

enum class Projection : std::uint8_t { perspective, orthographic };

/// Width and height in pixels.
struct Resolution {
    std::uint32_t width = 800;
    std::uint32_t height = 600;
    friend bool operator==(Resolution, Resolution) = default;
};

/// World space. `position` and `look_at` differ, and `up` is not parallel to their difference.
struct Camera {
    std::string name{};
    DVec3 position{0.0, 0.0, 5.0};
    DVec3 look_at{0.0};
    DVec3 up{0.0, 1.0, 0.0};
    Projection projection = Projection::perspective;
    double fov = 0.785398163397448309616;    // vertical, radians: 45 degrees
    double height = 2.0;                     // of the orthographic view, world units
    std::optional<Resolution> resolution{};  // overrides RenderSettings
    std::optional<Color> background{};       // likewise
    Span span{};
};

struct RenderSettings {
    Resolution resolution{};
    Color background{0.0f};
};

}  // namespace lray::scene
