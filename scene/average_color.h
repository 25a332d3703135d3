// The one colour that stands for a whole texture.
#pragma once

#include <span>

#include "base/vec.h"
#include "scene/texture.h"

namespace lray::scene {

/// Returns the mean linear colour of a pattern: of a picture that of its pixels, of a gradient its
/// integral, of two colours in turn or mixed by noise the middle of them.
Color average_color(const TexturePattern& pattern, std::span<const Picture> pictures);

}  // namespace lray::scene
