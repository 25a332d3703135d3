// Whitted's recursive ray tracing: light straight from the lights, mirrors and clear things.
// Source: Whitted 1980, "An Improved Illumination Model for Shaded Display".
#pragma once

#include "shade/transport/wave.h"

namespace lray::shade {

/// Rays that carry less than this share of what they meet to their sample are not followed.
inline constexpr float kLeastWeight = 1.0f / 1024.0f;

/// Adds the light of surfaces to the samples, and what is mirrored and refracted to the queue.
void shade_whitted(const WaveContext& context, Wave& wave);

}  // namespace lray::shade
