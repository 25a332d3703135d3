// What an NFF file says, with its places: the Neutral File Format of Haines' Standard Procedural
// Databases. How it is read is nff_reader.h, what is made of it nff_nodes.h.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/source.h"
#include "base/vec.h"
#include "scene/camera.h"
#include "scene/scene.h"
#include "scene/shapes.h"

namespace lray::scene {

/// `v`. The angle, in degrees, is that of the smaller side of the picture, from edge to edge; the
/// vertical one without a resolution.
struct NffView {
    DVec3 from{0.0};
    DVec3 at{0.0};
    DVec3 up{0.0, 1.0, 0.0};
    double angle = 45.0;
    std::optional<Resolution> resolution{};
    Span span{};
};

/// `l`. Without a colour it is white, and shines as NFF's unnamed lights do: 1/sqrt(n) each.
struct NffLight {
    DVec3 position{0.0};
    std::optional<DVec3> color{};
    Span span{};
};

/// `f`: the matt colour is `diffuse` times `color`; highlight, mirror and refraction are white.
struct NffSurface {
    DVec3 color{1.0};
    double diffuse = 1.0;
    double specular = 0.0;
    double shine = 1.0;
    double transmit = 0.0;
    double index = 1.0;
    friend bool operator==(const NffSurface&, const NffSurface&) = default;
};

/// A shape, or one of the triangles that a polygon was cut into.
struct NffShape {
    NodeKind kind = NodeKind::sphere;  // sphere, cylinder or triangle
    std::uint32_t index = 0;           // into the array of its kind
    std::uint32_t surface = 0;         // into `surfaces`
    Span span{};                       // of the statement
};

/// Shape: the attributes of a triangle are an index into `triangle_attributes`.
struct NffScene {
    std::optional<NffView> view{};
    std::optional<DVec3> background{};
    std::vector<NffLight> lights{};
    std::vector<NffSurface> surfaces{};  // each different from the others, and used
    std::vector<NffShape> shapes{};      // in the order of the file
    std::vector<SphereShape> spheres{};
    std::vector<CylinderShape> cylinders{};  // `c`: open at both ends
    std::vector<TriangleShape> triangles{};
    std::vector<TriangleAttributes> triangle_attributes{};
};

}  // namespace lray::scene
