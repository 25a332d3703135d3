// Looks up fractal noise as colours.
#pragma once

#include "base/vec.h"
#include "scene/texture.h"
#include "shade/textures/color_stops.h"
#include "shade/textures/footprint.h"
#include "shade/textures/fractal_noise.h"

namespace lray::shade {

class Noise {
 public:
    explicit Noise(const scene::NoiseTexture& noise)
        : noise_({static_cast<int>(noise.octaves), noise.lacunarity, noise.gain}, noise.seed),
          stops_(noise.stops) {}

    /// Returns the colour at a point of the texture's space, averaged over the footprint.
    DVec3 color(const DVec3& p, const Footprint& footprint) const {
        const FractalNoise::Value value = noise_.at(p, footprint.width());
        return stops_.mean(0.5 + 0.5 * value.mean, 0.5 * value.spread);
    }

 private:
    FractalNoise noise_;
    ColorStops stops_;
};

}  // namespace lray::shade
