// The textures of a world, ready to be looked up.
#pragma once

#include <cstddef>

#include "base/vec.h"
#include "scene/world.h"
#include "shade/textures/texture_point.h"

namespace lray::shade {

/// Const calls are thread-safe. The world must outlive it.
class TextureSet {
 public:
    /// Works out the smaller copies of pictures (mip maps) on all cores of the task arena it is
    /// called in.
    explicit TextureSet(const scene::World& world);

    /// Returns the linear colour of a texture there.
    Color color(scene::TextureId id, const TexturePoint& point) const;

    /// Returns the mean of its red, green and blue.
    float number(scene::TextureId id, const TexturePoint& point) const;

 private:
    const scene::World& world_;
};

}  // namespace lray::shade
