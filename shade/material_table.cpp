#include "shade/material_table.h"

namespace lray::shade {

namespace {

using scene::Coefficient;
using scene::Material;
using scene::ScalarCoefficient;

/// What `specular` is if it is not said.
Coefficient specular_of(const Material& material) {
    if (material.specular) return *material.specular;
    const bool is_microfacet = material.model == scene::ReflectionModel::cook_torrance ||
                               material.model == scene::ReflectionModel::ward;
    return Coefficient{Color{is_microfacet ? 1.0f : 0.2f}};
}

/// Builds a material in a point; `look_up` says what a coefficient is there.
template <class LookUp>
MaterialPoint point_of(const Material& material, LookUp look_up) {
    MaterialPoint point;
    point.model = material.model;
    point.two_sided = material.two_sided;
    point.ior = material.ior;
    point.diffuse = look_up(material.diffuse);
    point.ambient = material.ambient ? look_up(*material.ambient) : point.diffuse;
    point.specular = look_up(specular_of(material));
    point.shininess = look_up(material.shininess);
    point.roughness = look_up(material.roughness);
    point.fresnel = look_up(material.fresnel);
    point.reflect = look_up(material.reflect);
    point.transmit = look_up(material.transmit);
    point.absorption = look_up(material.absorption);
    point.emission = look_up(material.emission);
    point.opacity = look_up(material.opacity);
    return point;
}

bool looks_textures_up(const Material& material) {
    bool is_found = false;
    point_of(material, [&](const auto& coefficient) {
        is_found = is_found || coefficient.is_textured();
        return coefficient.constant;
    });
    return is_found;
}

bool has_direction(const Material& material) {
    return material.model == scene::ReflectionModel::ward &&
           (material.roughness.is_textured() ||
            material.roughness.constant.x != material.roughness.constant.y);
}

/// The texture's value in the type of the coefficient.
struct TextureReader {
    const TextureSet& textures;
    const TexturePoint& point;

    Color operator()(const Coefficient& coefficient) const {
        if (!coefficient.is_textured()) return coefficient.constant;
        return textures.color(coefficient.texture_id, point);
    }
    float operator()(const ScalarCoefficient& coefficient) const {
        if (!coefficient.is_textured()) return coefficient.constant;
        return textures.number(coefficient.texture_id, point);
    }
    Vec2 operator()(const scene::PlanarCoefficient& coefficient) const {
        if (!coefficient.is_textured()) return coefficient.constant;
        return Vec2{textures.number(coefficient.texture_id, point)};
    }
};

}  // namespace

MaterialTable::MaterialTable(const scene::World& world, const TextureSet& textures)
    : textures_(textures) {
    materials_.reserve(world.materials.size());
    for (const Material& material : world.materials) {
        Entry entry;
        entry.authored = &material;
        entry.average =
            point_of(material, [](const auto& coefficient) { return coefficient.constant; });
        entry.is_textured = looks_textures_up(material);
        entry.needs_detail = entry.is_textured || has_direction(material) ||
                             !material.bump_id.is_none() || !material.normal_map_id.is_none();
        materials_.push_back(entry);
        has_textures_ = has_textures_ || entry.is_textured || !material.bump_id.is_none() ||
                        !material.normal_map_id.is_none();
        has_transmission_ = has_transmission_ || material.transmit.is_textured() ||
                            material.transmit.constant != Color{0.0f};
        has_cut_outs_ =
            has_cut_outs_ || material.opacity.is_textured() || material.opacity.constant < 1.0f;
    }
}

MaterialPoint MaterialTable::at(std::uint32_t material, const TexturePoint& point) const {
    return point_of(*materials_[material].authored, TextureReader{textures_, point});
}

}  // namespace lray::shade
