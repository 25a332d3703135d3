#include "scene/formats/mtl_material.h"

#include <algorithm>

namespace lray::scene {

namespace {

/// Glass whose light is refracted.
bool is_glass(std::uint32_t model) {
    return model == 4 || model == 6 || model == 7 || model == 9;
}

bool is_mirror(std::uint32_t model) {
    return model == 3 || model == 5;
}

/// Of MTL; below, tools mean "none".
constexpr float kLeastIor = 0.001f;
constexpr float kMaxShininess = 10000.0f;
/// MTL does not say how high white is. This much of the width of a picture is a clear relief, and
/// the same at any scale of the mesh.
constexpr double kBumpHeight = 0.01;

}  // namespace

Material material_of(const MtlMaterial& mtl, const MtlTextures& ids,
                     std::span<const Texture> textures) {
    const auto or_texture = [&](Color color, TextureId id) {
        return id.is_none() ? Coefficient{color} : Coefficient{textures[id.index()].average, id};
    };
    Material material;
    const std::uint32_t model = mtl.model.value_or(2);
    // 0 and 1 have no highlight.
    const bool has_highlight = model >= 2 || !mtl.model;
    const Color specular = has_highlight ? mtl.specular.value_or(Color{0.0f}) : Color{0.0f};
    material.diffuse = or_texture(mtl.diffuse.value_or(Color{0.8f}), ids.diffuse_id);
    material.specular = or_texture(specular, has_highlight ? ids.specular_id : TextureId{});
    if (mtl.exponent) material.shininess = std::min(*mtl.exponent, kMaxShininess);
    material.emission = or_texture(mtl.emission.value_or(Color{0.0f}), ids.emission_id);
    if (is_mirror(model)) material.reflect = *material.specular;
    if (mtl.ior && *mtl.ior >= kLeastIor) material.ior = *mtl.ior;

    // `Tr` is 1 - d by the books, but some tools write it upside down, beside the right `d`.
    const float solid = mtl.dissolve ? *mtl.dissolve : 1.0f - mtl.transparency.value_or(0.0f);
    if (!ids.opacity_id.is_none()) {
        const Color average = textures[ids.opacity_id.index()].average;
        material.opacity = {(average.r + average.g + average.b) / 3.0f, ids.opacity_id};
    } else if (solid < 1.0f && is_glass(model)) {
        material.transmit = mtl.filter.value_or(Color{1.0f}) * (1.0f - solid);
        if (!material.diffuse.is_textured()) material.diffuse.constant *= solid;
    } else {
        material.opacity = solid;
    }
    material.normal_map_id = ids.normal_map_id;
    if (!ids.bump_id.is_none()) {
        material.bump_id = ids.bump_id;
        material.bump_height = kBumpHeight * mtl.bump_map->bump_multiplier;
        material.bump_unit = BumpUnit::uv;
    }
    return material;
}

Transform uv_from_picture(const MtlMap& map) {
    return Transform::translation({-map.offset.x, -map.offset.y, 0.0})
        .then(Transform::scaling({1.0 / map.scale.x, 1.0 / map.scale.y, 1.0}));
}

}  // namespace lray::scene
