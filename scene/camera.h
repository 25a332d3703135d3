// Cameras, the settings of a render and the animation. Defaults are those of the language.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "base/sampler.h"
#include "base/source.h"
#include "base/vec.h"
#include "image/tone_map.h"

namespace lray::scene {

/// `panorama`: all directions, u around the up axis and v from straight down to straight up, the
/// view in the middle of the picture (equirectangular).
enum class Projection : std::uint8_t { perspective, orthographic, panorama };

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
    double aperture = 0.0;                   // diameter of the lens; 0: all is sharp
    std::optional<double> focus{};           // distance of what is sharp; empty: that of look_at
    std::optional<Resolution> resolution{};  // overrides RenderSettings
    std::optional<std::uint32_t> samples{};  // likewise
    std::optional<Color> background{};       // likewise
    Span span{};
};

enum class Integrator : std::uint8_t { whitted, path };
using image::Gamma;
using image::ToneMap;
using lray::SamplerKind;

struct RenderSettings {
    Resolution resolution{};
    std::uint32_t samples = 1;    // rays per pixel
    std::uint32_t max_depth = 8;  // of reflections and refractions one after the other
    Color background{0.0f};
    Color ambient{0.0f};
    double exposure = 0.0;  // in stops: light times 2^exposure
    ToneMap tonemap = ToneMap::none;
    Gamma gamma = Gamma::srgb;
    std::uint64_t seed = 0;
    Integrator integrator = Integrator::whitted;
    SamplerKind sampler = SamplerKind::sobol;
    bool transparent_shadows = false;
};

/// Frame i of `frames` is at the time start + i / fps, in seconds.
struct Animation {
    std::uint32_t frames = 1;
    double fps = 24.0;
    double start = 0.0;
};

}  // namespace lray::scene
