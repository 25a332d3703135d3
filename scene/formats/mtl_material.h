// What the materials of MTL files are in the reflection models of a scene.
#pragma once

#include <span>

#include "scene/formats/mtl_reader.h"
#include "scene/material.h"
#include "scene/texture.h"

namespace lray::scene {

/// The pictures of a material as textures; none where it has none, or it could not be read.
struct MtlTextures {
    TextureId diffuse_id{};
    TextureId specular_id{};
    TextureId emission_id{};
    TextureId opacity_id{};
    TextureId normal_map_id{};
    TextureId bump_id{};
};

/// Returns the material: Blinn and Phong's, as MTL defines it. A picture takes the place of the
/// number beside it. docs/formats.md has the table.
Material material_of(const MtlMaterial& mtl, const MtlTextures& ids,
                     std::span<const Texture> textures);

/// Returns where a picture lies in uv: the map from its own coordinates.
Transform uv_from_picture(const MtlMap& map);

}  // namespace lray::scene
