#include "parser/blocks/build_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numerics.h"
#include "parser/blocks/schemas.h"

namespace lray::parser {

namespace {

using namespace schemas;

/// The rotation that turns +Y onto a unit normal by the shortest arc; onto -Y it is half a turn
/// about X.
DMat3 frame_of(DVec3 normal) {
    // Rodrigues' formula for the axis Y x n = (n.z, 0, -n.x), whose length is never divided by:
    // 1 / (1 + n.y), which cancels for n.y < 0, is there written by n.x^2 + n.z^2 = 1 - n.y^2.
    const double sine_squared = normal.x * normal.x + normal.z * normal.z;
    if (normal.y < 0.0 && sine_squared == 0.0) {
        return DMat3{DVec3{1, 0, 0}, DVec3{0, -1, 0}, DVec3{0, 0, -1}};
    }
    const double k = normal.y < 0.0 ? (1.0 - normal.y) / sine_squared : 1.0 / (1.0 + normal.y);
    return DMat3{DVec3{1.0 - normal.x * normal.x * k, -normal.x, -normal.x * normal.z * k}, normal,
                 DVec3{-normal.x * normal.z * k, -normal.z, 1.0 - normal.z * normal.z * k}};
}

template <class T>
std::uint32_t add(std::vector<T>& shapes, T shape) {
    shapes.push_back(std::move(shape));
    return static_cast<std::uint32_t>(shapes.size() - 1);
}

scene::SphereShape sphere_shape(const PropertyValues& values) {
    constexpr std::size_t kCenter = slot(kSphere, "center");
    constexpr std::size_t kRadius = slot(kSphere, "radius");
    return {values.vec3(kCenter), values.number(kRadius)};
}

scene::RectangleShape rectangle_shape(const PropertyValues& values, Span span,
                                      Diagnostics& diagnostics) {
    constexpr std::size_t kCenter = slot(kRectangle, "center");
    constexpr std::size_t kSize = slot(kRectangle, "size");
    constexpr std::size_t kNormal = slot(kRectangle, "normal");
    constexpr std::size_t kCorner = slot(kRectangle, "corner");
    constexpr std::size_t kEdgeU = slot(kRectangle, "edge_u");
    constexpr std::size_t kEdgeV = slot(kRectangle, "edge_v");
    if (values.has(kCorner)) {
        const scene::RectangleShape shape{values.vec3(kCorner), values.vec3(kEdgeU),
                                          values.vec3(kEdgeV)};
        if (are_parallel(shape.edge_u, shape.edge_v)) {
            diagnostics.warning(Code::W1201, span,
                                "this rectangle has no area: its edges are parallel");
        }
        return shape;
    }
    return facing_rectangle(values.vec3(kCenter), values.vec2(kSize), values.vec3(kNormal));
}

std::optional<scene::TriangleShape> triangle_shape(const PropertyValues& values, Span span,
                                                   scene::Scene& scene, Diagnostics& diagnostics) {
    constexpr std::size_t kA = slot(kTriangle, "a");
    constexpr std::size_t kB = slot(kTriangle, "b");
    constexpr std::size_t kC = slot(kTriangle, "c");
    constexpr std::size_t kNormals = slot(kTriangle, "normals");
    constexpr std::size_t kUvs = slot(kTriangle, "uvs");
    scene::TriangleShape shape{values.vec3(kA), values.vec3(kB), values.vec3(kC)};
    if (are_parallel(shape.b - shape.a, shape.c - shape.a)) {
        diagnostics.warning(Code::W1201, span,
                            "this triangle has no area: the three points are on a line");
    }
    for (const std::size_t property : {kNormals, kUvs}) {
        if (values.has(property) && values[property].count != 3) {
            diagnostics.error(Code::E0303, span,
                              fmt::format("`{}` needs 3 rows, one for each corner; this has {}",
                                          kTriangle[property].name, values[property].count));
            return std::nullopt;
        }
    }
    if (values.has(kNormals) || values.has(kUvs)) {
        scene::TriangleAttributes attributes;
        if (values.has(kNormals)) {
            const double* n = values[kNormals].numbers;
            attributes.normals = {DVec3{n[0], n[1], n[2]}, DVec3{n[3], n[4], n[5]},
                                  DVec3{n[6], n[7], n[8]}};
        }
        if (values.has(kUvs)) {
            const double* uv = values[kUvs].numbers;
            attributes.uvs = {DVec2{uv[0], uv[1]}, DVec2{uv[2], uv[3]}, DVec2{uv[4], uv[5]}};
        }
        shape.attributes = add(scene.triangle_attributes, attributes);
    }
    return shape;
}

std::optional<scene::CylinderShape> cylinder_shape(const PropertyValues& values, Span span,
                                                   Diagnostics& diagnostics) {
    constexpr std::size_t kFrom = slot(kCylinder, "from");
    constexpr std::size_t kTo = slot(kCylinder, "to");
    constexpr std::size_t kRadius = slot(kCylinder, "radius");
    constexpr std::size_t kRadiusTo = slot(kCylinder, "radius_to");
    constexpr std::size_t kCaps = slot(kCylinder, "caps");
    scene::CylinderShape shape;
    shape.from = values.vec3(kFrom);
    shape.to = values.vec3(kTo);
    shape.radius = values.number(kRadius);
    shape.radius_to = values.has(kRadiusTo) ? values.number(kRadiusTo) : shape.radius;
    shape.caps = values.boolean(kCaps);
    if (shape.from == shape.to) {
        diagnostics.error(Code::E0411, span, "`from` and `to` are the same point");
        return std::nullopt;
    }
    if (shape.radius == 0.0 && shape.radius_to == 0.0) {
        diagnostics
            .error(Code::E0304, span,
                   values.has(kRadiusTo) ? "`radius` and `radius_to` are both 0"
                                         : "`radius` must be greater than 0, this is 0")
            .with_help("one of them may be 0: the tip of a cone");
        return std::nullopt;
    }
    return shape;
}

std::optional<scene::DiskShape> disk_shape(const PropertyValues& values, Span span,
                                           Diagnostics& diagnostics) {
    constexpr std::size_t kCenter = slot(kDisk, "center");
    constexpr std::size_t kNormal = slot(kDisk, "normal");
    constexpr std::size_t kRadius = slot(kDisk, "radius");
    constexpr std::size_t kHole = slot(kDisk, "hole");
    const scene::DiskShape shape{values.vec3(kCenter), unit(values.vec3(kNormal)),
                                 values.number(kRadius), values.number(kHole)};
    if (shape.hole >= shape.radius) {
        diagnostics.error(Code::E0304, span,
                          fmt::format("`hole` must be less than `radius` {}, this is {}",
                                      format_number(shape.radius), format_number(shape.hole)));
        return std::nullopt;
    }
    return shape;
}

std::optional<scene::BoxShape> box_shape(const PropertyValues& values, Span span,
                                         Diagnostics& diagnostics) {
    constexpr std::size_t kCenter = slot(kBox, "center");
    constexpr std::size_t kSize = slot(kBox, "size");
    constexpr std::size_t kMin = slot(kBox, "min");
    constexpr std::size_t kMax = slot(kBox, "max");
    if (!values.has(kMin)) {
        const DVec3 half = 0.5 * values.vec3(kSize);
        return scene::BoxShape{values.vec3(kCenter) - half, values.vec3(kCenter) + half};
    }
    const scene::BoxShape shape{values.vec3(kMin), values.vec3(kMax)};
    for (int axis = 0; axis < 3; ++axis) {
        if (shape.min[axis] < shape.max[axis]) continue;
        diagnostics
            .error(Code::E0304, span,
                   fmt::format("`min` must be less than `max`, but their {} are {} and {}",
                               std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1),
                               format_number(shape.min[axis]), format_number(shape.max[axis])))
            .with_help("for a flat shape use rectangle");
        return std::nullopt;
    }
    return shape;
}

template <class T>
std::optional<ShapeRef> place(scene::NodeKind kind, std::vector<T>& shapes,
                              std::optional<T> shape) {
    if (!shape) return std::nullopt;
    return ShapeRef{kind, add(shapes, *shape)};
}

}  // namespace

DVec3 unit(DVec3 direction) {
    // What was made unit once stays as it is, to the bit: 9 roundings in its square, 3 here.
    if (std::fabs(dot(direction, direction) - 1.0) <= gamma<double>(12)) return direction;
    const double largest =
        std::max({std::fabs(direction.x), std::fabs(direction.y), std::fabs(direction.z)});
    return glm::normalize(direction / largest);
}

// Their cross product is not larger than its own rounding error, gamma(3) |u| |v| per component.
bool are_parallel(DVec3 u, DVec3 v) {
    return glm::length(cross(u, v)) <= 2.0 * gamma<double>(3) * glm::length(u) * glm::length(v);
}

scene::RectangleShape facing_rectangle(DVec3 center, DVec2 size, DVec3 normal) {
    const DMat3 frame = frame_of(unit(normal));
    scene::RectangleShape shape;
    shape.edge_u = frame[0] * size.x;
    shape.edge_v = -frame[2] * size.y;
    shape.corner = center - 0.5 * shape.edge_u - 0.5 * shape.edge_v;
    return shape;
}

std::optional<ShapeRef> build_shape(const BlockSchema& schema, const PropertyValues& values,
                                    Span span, scene::Scene& scene, Diagnostics& diagnostics) {
    using scene::NodeKind;
    switch (schema.kind) {
        case BlockKind::sphere:
            return ShapeRef{NodeKind::sphere, add(scene.spheres, sphere_shape(values))};
        case BlockKind::rectangle:
            return ShapeRef{NodeKind::rectangle,
                            add(scene.rectangles, rectangle_shape(values, span, diagnostics))};
        case BlockKind::triangle:
            return place(NodeKind::triangle, scene.triangles,
                         triangle_shape(values, span, scene, diagnostics));
        case BlockKind::cylinder:
            return place(NodeKind::cylinder, scene.cylinders,
                         cylinder_shape(values, span, diagnostics));
        case BlockKind::disk:
            return place(NodeKind::disk, scene.disks, disk_shape(values, span, diagnostics));
        case BlockKind::box:
            return place(NodeKind::box, scene.boxes, box_shape(values, span, diagnostics));
        case BlockKind::plane: {
            constexpr std::size_t kPoint = slot(kPlane, "point");
            constexpr std::size_t kNormal = slot(kPlane, "normal");
            return ShapeRef{NodeKind::plane,
                            add(scene.planes, {values.vec3(kPoint), unit(values.vec3(kNormal))})};
        }
        case BlockKind::torus: {
            constexpr std::size_t kRadius = slot(kTorus, "radius");
            constexpr std::size_t kTube = slot(kTorus, "tube");
            return ShapeRef{NodeKind::torus,
                            add(scene.tori, {values.number(kRadius), values.number(kTube)})};
        }
        case BlockKind::group:
        case BlockKind::mesh:
        case BlockKind::heightfield:
        case BlockKind::terrain:
        case BlockKind::material:
        case BlockKind::camera:
        case BlockKind::render:
        case BlockKind::info:
        case BlockKind::image:
        case BlockKind::checker:
        case BlockKind::stripes:
        case BlockKind::gradient:
        case BlockKind::ramp:
        case BlockKind::noise_texture:
        case BlockKind::marble:
        case BlockKind::wood:
        case BlockKind::vertex_colors:
        case BlockKind::point_light:
        case BlockKind::spot_light:
        case BlockKind::directional_light:
        case BlockKind::area_light:
        case BlockKind::environment:
        case BlockKind::animation:
        case BlockKind::record:
        case BlockKind::component:
            break;
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::parser
