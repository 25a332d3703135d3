#include "scene/object_space.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/assert.h"
#include "scene/scene.h"

namespace lray::scene {

namespace {

/// A texture in world space is looked up without the shape's.
bool is_of_shape(TextureId id, std::span<const Texture> textures) {
    return !id.is_none() && textures[id.index()].space != TextureSpace::world &&
           textures[id.index()].space != TextureSpace::vertex_colors;
}

bool depends_on_shape(const Material& material, std::span<const Texture> textures) {
    const std::array ids{material.ambient.value_or(Coefficient{}).texture_id,
                         material.diffuse.texture_id,
                         material.specular.value_or(Coefficient{}).texture_id,
                         material.shininess.texture_id,
                         material.roughness.texture_id,
                         material.fresnel.texture_id,
                         material.reflect.texture_id,
                         material.transmit.texture_id,
                         material.absorption.texture_id,
                         material.emission.texture_id,
                         material.opacity.texture_id,
                         material.bump_id};
    // A normal map is relative to u and v, wherever it is looked up; so may heights be.
    if (!material.normal_map_id.is_none()) return true;
    if (!material.bump_id.is_none() && material.bump_unit == BumpUnit::uv) return true;
    // Its two roughnesses are along u and v.
    const Vec2 roughness = material.roughness.constant;
    if (material.model == ReflectionModel::ward && roughness.x != roughness.y) return true;
    return std::any_of(ids.begin(), ids.end(),
                       [&](TextureId id) { return is_of_shape(id, textures); });
}

}  // namespace

void ObjectSpaces::add(ObjectId id, const ObjectSpace& space) {
    LRAY_ASSERT(id.index() >= index_of_.size());
    index_of_.resize(id.index(), kNone);
    index_of_.push_back(static_cast<std::uint32_t>(spaces_.size()));
    spaces_.push_back(space);
}

void ObjectSpaces::shrink_to_fit() {
    index_of_.shrink_to_fit();
    spaces_.shrink_to_fit();
}

ObjectSpaceRule::ObjectSpaceRule(const Scene& scene, KeptSpaces kept) {
    if (kept == KeptSpaces::all) {
        is_any_kept_ = true;
        return;
    }
    // The first material of a world is the default.
    is_kept_.reserve(scene.materials.size() + 1);
    is_kept_.push_back(false);
    for (const Material& material : scene.materials) {
        const bool is_kept = depends_on_shape(material, scene.textures);
        is_kept_.push_back(is_kept);
        is_any_kept_ = is_any_kept_ || is_kept;
    }
}

}  // namespace lray::scene
