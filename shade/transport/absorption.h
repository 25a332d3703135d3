// What a medium takes of light that runs through it.
#pragma once

#include <cmath>

#include "base/vec.h"

namespace lray::shade {

/// Returns the share that is left of light after a length inside, by what is absorbed per metre.
/// Shape: all of the absorption 0 or greater. A channel without any keeps all, however long.
/// Source: Beer-Lambert.
inline Color transmittance(Color absorption, float length) {
    Color result{1.0f};
    for (int channel = 0; channel < 3; ++channel) {
        if (absorption[channel] > 0.0f) result[channel] = std::exp(-absorption[channel] * length);
    }
    return result;
}

}  // namespace lray::shade
