// Path tracing: of all ways that light takes, one at random for each sample.
// Source: Kajiya 1986, "The Rendering Equation"; Veach 1997, "Robust Monte Carlo Methods for Light
// Transport Simulation", ch. 9 (multiple importance sampling) and 10.4 (Russian roulette).
#pragma once

#include "shade/transport/wave.h"

namespace lray::shade {

/// Adds to the samples what surfaces give off and what a light, chosen at random, brings to them,
/// and to the queue one ray at most from each. Rays that meet a light by themselves are weighed
/// against those that were sent to it (balance heuristic).
void shade_paths(const WaveContext& context, Wave& wave);

/// Returns the weight of light that was met by one of two ways to choose its direction.
inline float balance(float pdf, float other_pdf) {
    return pdf / (pdf + other_pdf);
}

}  // namespace lray::shade
