// The textures of a world, ready to be looked up.
#pragma once

#include <cstddef>
#include <memory>
#include <variant>
#include <vector>

#include "base/vec.h"
#include "scene/world.h"
#include "shade/textures/checker.h"
#include "shade/textures/gradient.h"
#include "shade/textures/image_lookup.h"
#include "shade/textures/marble.h"
#include "shade/textures/mip_chain.h"
#include "shade/textures/noise.h"
#include "shade/textures/ramp.h"
#include "shade/textures/stripes.h"
#include "shade/textures/texture_point.h"
#include "shade/textures/vertex_colors.h"
#include "shade/textures/wood.h"

namespace lray::shade {

/// Const calls are thread-safe. The world must outlive it.
class TextureSet {
 public:
    /// Works out the smaller copies of pictures (mip maps) on all cores of the task arena it is
    /// called in.
    explicit TextureSet(const scene::World& world);

    /// Returns the linear colour of a texture there. A point that is not finite, or so far away
    /// that its squares are not, shows the average colour.
    Color color(scene::TextureId id, const TexturePoint& point) const;

    /// Returns the mean of its red, green and blue.
    float number(scene::TextureId id, const TexturePoint& point) const;

 private:
    // Patterns hand colours on as three doubles, and take points by reference: of three floats in
    // two registers, and of copies of structs just written, gcc makes loads that wait for stores,
    // which cost more than looking up a checker.
    using Pattern = std::variant<ImageLookup, Checker, Stripes, Gradient, Ramp, Noise, Marble, Wood,
                                 LightLookup, VertexColors>;

    struct Entry {
        Pattern pattern;
        scene::TextureSpace space = scene::TextureSpace::object;
        DMat3 linear{1.0};  // texture_from_space
        DVec3 offset{0.0};
        DVec3 stretch{1.0};  // along each axis of the texture, of a ball in its space
        Color average{0.0f};
    };

    Entry entry_of(const scene::Texture& texture, const scene::World& world);
    Pattern lookup_of(const scene::ImageTexture& image, const scene::World& world);

    std::vector<Entry> entries_;                     // by TextureId
    std::vector<std::unique_ptr<MipChain>> chains_;  // two by PictureId: of data, of sRGB; or none
    std::vector<std::unique_ptr<LightMipChain>> light_chains_;  // by PictureId, or none
};

}  // namespace lray::shade
