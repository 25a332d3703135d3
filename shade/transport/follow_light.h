// The light that comes along rays from the camera, by the integrator that the settings name.
#pragma once

#include <atomic>
#include <span>

#include "base/sampler.h"
#include "bvh/hit.h"
#include "shade/settings.h"
#include "shade/transport/lit_world.h"
#include "shade/transport/media.h"
#include "shade/transport/sample_sum.h"
#include "shade/transport/transport_ray.h"
#include "shade/transport/wave.h"

namespace lray::shade {

/// Camera rays that are followed together, one for each sample, and what they hit.
/// Shape: all of the same length, at most kMaxWaveSize.
struct CameraWave {
    std::span<const Ray> rays{};
    std::span<const RayCone> cones{};
    std::span<const PixelSample> samples{};
    std::span<const bvh::Hit> hits{};
};

/// Works out the light that comes along each ray, into a color for each sample. The result of one
/// does not depend on the others. `camera_media` is what the camera is inside of (media_at()).
/// Errors: false once `cancel` is set: then the colours mean nothing.
bool follow_light(const LitWorld& lit, const Settings& settings, const Media& camera_media,
                  const CameraWave& camera, std::span<Color> colors, LightCounts& counts,
                  const std::atomic<bool>& cancel);

}  // namespace lray::shade
