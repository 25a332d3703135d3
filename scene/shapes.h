// The shapes as they are authored: in their own object space, in double precision. Defaults are
// those of the language; the parser's schemas take them from here.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/vec.h"
#include "scene/ids.h"

namespace lray::scene {

struct SphereShape {
    DVec3 center{0.0};
    double radius = 1.0;
};

/// A parallelogram: corner + u edge_u + v edge_v, with u, v in [0, 1]; its normal is
/// edge_u x edge_v.
struct RectangleShape {
    DVec3 corner{-0.5, 0.0, 0.5};
    DVec3 edge_u{1.0, 0.0, 0.0};
    DVec3 edge_v{0.0, 0.0, -1.0};
};

struct TriangleAttributes {
    std::optional<std::array<DVec3, 3>> normals{};
    std::optional<std::array<DVec2, 3>> uvs{};
};

/// Counter-clockwise is the front.
struct TriangleShape {
    static constexpr std::uint32_t kNoAttributes = 0xffffffffu;

    DVec3 a{};
    DVec3 b{};
    DVec3 c{};
    std::uint32_t attributes = kNoAttributes;  // index into Scene::triangle_attributes
};

/// A cylinder, or with another radius at the `to` end a cone. At most one radius is 0.
struct CylinderShape {
    DVec3 from{0.0};
    DVec3 to{0.0, 1.0, 0.0};
    double radius = 0.5;
    double radius_to = 0.5;
    bool caps = true;
};

/// A circular disk, with a concentric hole.
struct DiskShape {
    DVec3 center{0.0};
    DVec3 normal{0.0, 1.0, 0.0};
    double radius = 1.0;
    double hole = 0.0;  // radius of the hole; less than `radius`
};

struct BoxShape {
    DVec3 min{-0.5};
    DVec3 max{0.5};
};

/// Infinite.
struct PlaneShape {
    DVec3 point{0.0};
    DVec3 normal{0.0, 1.0, 0.0};
};

/// Around the Y axis. With `tube` greater than `radius` the tube overlaps itself, and the shape is
/// its outside: an apple.
struct TorusShape {
    double radius = 1.0;  // from the centre to the middle of the tube
    double tube = 0.25;   // radius of the tube
};

}  // namespace lray::scene
