// Materials: the coefficients of the reflection models. Textures take the place of constants
// elsewhere. Defaults are those of the language.
#pragma once

#include <cstdint>
#include <optional>

#include "base/vec.h"

namespace lray::scene {

enum class ReflectionModel : std::uint8_t { lambert, phong, blinn_phong, cook_torrance, ward };

struct Material {
    ReflectionModel model = ReflectionModel::blinn_phong;
    std::optional<Color> ambient{};  // empty: as diffuse
    Color diffuse{0.8f};
    std::optional<Color> specular{};  // empty: 0.2; 1 for cook_torrance and ward
    float shininess = 32.0f;
    Vec2 roughness{0.3f};  // along u and v; the same unless ward is given two
    Color fresnel{0.04f};
    Color reflect{0.0f};
    Color transmit{0.0f};
    float ior = 1.5f;
    Color absorption{0.0f};  // per metre
    Color emission{0.0f};
    float opacity = 1.0f;
    bool two_sided = true;
};

}  // namespace lray::scene
