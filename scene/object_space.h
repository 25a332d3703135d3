// The space of a shape before its own steps, kept for the objects whose look depends on it.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "scene/ids.h"

namespace lray::scene {

struct Scene;

/// The map from the space of a geometry to that of a shape in it, before the shape's own steps.
struct ObjectSpace {
    DMat3 linear{1.0};
    DVec3 offset{0.0};

    DVec3 point(DVec3 p) const { return linear * p + offset; }
};

/// The spaces of some of a geometry's objects. Takes nothing while there are none.
class ObjectSpaces {
 public:
    /// Shape: ids ascend.
    void add(ObjectId id, const ObjectSpace& space);

    /// Returns the object's space; null if it was not kept.
    const ObjectSpace* find(ObjectId id) const {
        if (id.index() >= index_of_.size()) return nullptr;
        const std::uint32_t index = index_of_[id.index()];
        return index == kNone ? nullptr : &spaces_[index];
    }

    void shrink_to_fit();

 private:
    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::vector<std::uint32_t> index_of_{};  // by object, up to the last one that has a space
    std::vector<ObjectSpace> spaces_{};
};

/// Whose spaces are kept: of what may show a texture or another look that depends on it, or of all
/// objects, as pictures of uv need them.
enum class KeptSpaces : std::uint8_t { where_textured, all };

/// Which materials make an object keep its space.
class ObjectSpaceRule {
 public:
    ObjectSpaceRule(const Scene& scene, KeptSpaces kept);

    /// Shape: an index into World::materials, or Object::kInherited.
    bool is_kept(std::uint32_t material) const {
        return material < is_kept_.size() ? is_kept_[material] : is_any_kept_;
    }

 private:
    std::vector<bool> is_kept_{};  // by material of the world
    bool is_any_kept_ = false;
};

}  // namespace lray::scene
