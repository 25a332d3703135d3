// Materials: the coefficients of the reflection models, each a constant or a texture. Defaults are
// those of the language.
#pragma once

#include <cstdint>
#include <optional>

#include "base/vec.h"
#include "scene/ids.h"

namespace lray::scene {

enum class ReflectionModel : std::uint8_t { lambert, phong, blinn_phong, cook_torrance, ward };

/// A value of a material that a texture may take the place of.
template <class T>
struct CoefficientOf {
    T constant{};            // of a texture its average: what flat painting shows
    TextureId texture_id{};  // none: constant

    constexpr CoefficientOf() = default;
    constexpr CoefficientOf(T value, TextureId texture = {})
        : constant(value), texture_id(texture) {}

    constexpr bool is_textured() const { return !texture_id.is_none(); }
    friend constexpr bool operator==(const CoefficientOf& a, const CoefficientOf& b) {
        return a.constant == b.constant && a.texture_id == b.texture_id;
    }
};

using Coefficient = CoefficientOf<Color>;
/// Of a texture the mean of red, green and blue.
using ScalarCoefficient = CoefficientOf<float>;
/// Likewise, for both numbers.
using PlanarCoefficient = CoefficientOf<Vec2>;

enum class BumpUnit : std::uint8_t {
    metre,  // of the world
    uv,     // the side of the square that u and v from 0 to 1 cover on the surface
};

struct Material {
    ReflectionModel model = ReflectionModel::blinn_phong;
    std::optional<Coefficient> ambient{};  // empty: as diffuse
    Coefficient diffuse{Color{0.8f}};
    std::optional<Coefficient> specular{};  // empty: 0.2; 1 for cook_torrance and ward
    ScalarCoefficient shininess{32.0f};
    PlanarCoefficient roughness{Vec2{0.3f}};  // along u and v; the same unless ward is given two
    Coefficient fresnel{Color{0.04f}};
    Coefficient reflect{Color{0.0f}};
    Coefficient transmit{Color{0.0f}};
    float ior = 1.5f;
    Coefficient absorption{Color{0.0f}};  // per metre
    Coefficient emission{Color{0.0f}};
    ScalarCoefficient opacity{1.0f};
    TextureId bump_id{};       // height along the normal; none: smooth
    double bump_height = 1.0;  // of 1 in that texture, in units of
    BumpUnit bump_unit = BumpUnit::metre;
    TextureId normal_map_id{};  // tangent-space normals coded as 0 to 1; none: the shape's own
    bool two_sided = true;
};

}  // namespace lray::scene
