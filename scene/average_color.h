// The one colour that stands for a whole texture.
#pragma once

#include <span>

#include "base/vec.h"
#include "scene/texture.h"

namespace lray::scene {

/// Returns the mean linear colour of a pattern: of a picture that of its pixels, of a gradient its
/// integral, of two colours in turn the middle of them; of noise, marble and wood what they show in
/// the long run; of vertex colours white, as each mesh has its own (Geometry::mean_color()).
Color average_color(const TexturePattern& pattern, std::span<const Picture> pictures);

}  // namespace lray::scene
