#include "scene/warn_enclosed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/each_primitive.h"
#include "scene/inside.h"
#include "scene/object_path.h"

namespace lray::scene {

namespace {

/// Tests of a point against a primitive: keeps the time small beside that of flattening.
constexpr std::size_t kMaxTests = 2'000'000;
constexpr std::size_t kMinPoints = 2;
constexpr std::size_t kMaxPoints = 64;
constexpr std::size_t kMaxEnclosures = 8;

struct Point {
    DVec3 position{};
    const Camera* camera = nullptr;  // null: a light
    NodeId light_id{};
};

struct Enclosure {
    PrimitiveId id{};
    Bounds bounds{};
    Point point{};
    bool has_camera = false;
    bool has_light = false;
    bool has_content = false;

    bool is_room() const { return has_content || (has_camera && has_light); }
};

std::optional<DVec3> position_of(const WorldLight& light) {
    if (!light.casts_shadow) return std::nullopt;
    if (const auto* point = std::get_if<PointLight>(&light.light.shape)) return point->position;
    if (const auto* spot = std::get_if<SpotLight>(&light.light.shape)) return spot->position;
    return std::nullopt;
}

/// The first camera, the first light, and then as many as there are tests for.
std::vector<Point> points_of(const Scene& scene, const World& world, std::size_t closed_count) {
    const std::size_t most =
        std::clamp(kMaxTests / std::max<std::size_t>(closed_count, 1), kMinPoints, kMaxPoints);
    std::vector<Point> points;
    for (const Camera& camera : scene.cameras) {
        if (points.size() >= most / 2) break;
        if (camera.projection == Projection::orthographic) continue;  // it looks from a whole plane
        points.push_back({camera.position, &camera, {}});
    }
    for (const WorldLight& light : world.lights) {
        if (points.size() >= most) break;
        if (const auto position = position_of(light)) {
            points.push_back({*position, nullptr, light.node_id});
        }
    }
    return points;
}

bool is_opaque(const Material& material) {
    return material.two_sided && material.transmit == Coefficient{Color{0.0f}} &&
           material.opacity == ScalarCoefficient{1.0f};
}

/// A sky around the camera, or a picture of one.
bool is_backdrop(const Material& material) {
    return material.diffuse.is_textured() || material.emission != Coefficient{Color{0.0f}};
}

bool shuts_in(const World& world, const Object& object, const Point& point) {
    const Material& material = world.materials[object.material];
    if (!object.visible || !is_opaque(material)) return false;
    return point.camera != nullptr ? !is_backdrop(material) : object.casts_shadow;
}

/// False for most points outside: all canonical shapes are within [-1, 1]^3. Rounding is far below
/// the margin of is_inside().
bool may_contain(const AffineFrame& frame, Vec3 point) {
    const Vec3 offset = point - frame.origin;
    for (int row = 0; row < 3; ++row) {
        const float q = frame.object_from_world[0][row] * offset.x +
                        frame.object_from_world[1][row] * offset.y +
                        frame.object_from_world[2][row] * offset.z;
        if (std::fabs(q) > 1.0f) return false;
    }
    return true;
}

bool may_contain(const Sphere& sphere, Vec3 point) {
    return std::fabs(point.x - sphere.center.x) <= sphere.radius &&
           std::fabs(point.y - sphere.center.y) <= sphere.radius &&
           std::fabs(point.z - sphere.center.z) <= sphere.radius;
}

template <class Primitive>
bool may_contain(const Primitive& primitive, Vec3 point) {
    return may_contain(primitive.frame, point);
}

/// Adds those of one kind, until there are kMaxEnclosures.
template <class Primitive>
void add_enclosures(const World& world, PrimitiveKind kind,
                    const std::vector<Primitive>& primitives, const std::vector<Point>& points,
                    std::vector<Enclosure>& enclosures) {
    for (const Point& point : points) {
        const Vec3 position{point.position};
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            if (!may_contain(primitives[i], position)) continue;
            const PrimitiveId id(kind, i);
            if (!is_inside(world, id, point.position)) continue;
            if (!shuts_in(world, world.object(world.object_of(id)), point)) continue;
            if (enclosures.size() == kMaxEnclosures) return;
            enclosures.push_back({id, primitive_bounds(world, id), point});
        }
    }
}

std::vector<Enclosure> find_enclosures(const World& world, const std::vector<Point>& points) {
    std::vector<Enclosure> enclosures;
    add_enclosures(world, PrimitiveKind::sphere, world.spheres, points, enclosures);
    add_enclosures(world, PrimitiveKind::ellipsoid, world.ellipsoids, points, enclosures);
    add_enclosures(world, PrimitiveKind::cylinder, world.cylinders, points, enclosures);
    add_enclosures(world, PrimitiveKind::box, world.boxes, points, enclosures);
    add_enclosures(world, PrimitiveKind::torus, world.tori, points, enclosures);
    return enclosures;
}

/// The bounds at half their size, about their centre.
struct InnerHalf {
    DVec3 center{};
    DVec3 reach{};

    explicit InnerHalf(const Bounds& bounds)
        : center(0.5 * (DVec3{bounds.min} + DVec3{bounds.max})),
          reach(0.25 * (DVec3{bounds.max} - DVec3{bounds.min})) {}
};

bool meets(const Plane& plane, const InnerHalf& inner) {
    const DVec3 normal{plane.normal};
    const double distance = dot(normal, inner.center - DVec3{plane.point});
    const double reach = std::fabs(normal.x) * inner.reach.x + std::fabs(normal.y) * inner.reach.y +
                         std::fabs(normal.z) * inner.reach.z;
    return std::fabs(distance) <= reach;
}

bool has_inside(const World& world, PrimitiveId id) {
    const PrimitiveKind kind = id.kind();
    if (kind == PrimitiveKind::cylinder) return world.cylinders[id.index()].caps;
    return kind == PrimitiveKind::sphere || kind == PrimitiveKind::ellipsoid ||
           kind == PrimitiveKind::box || kind == PrimitiveKind::torus;
}

/// True if the middle of the primitive is inside of the enclosure, or its bounds reach into the
/// inner half. What only touches it from outside is no content, nor is what is around both.
bool is_content(const World& world, PrimitiveId id, const Enclosure& enclosure) {
    const InnerHalf inner(enclosure.bounds);
    if (id.kind() == PrimitiveKind::plane) return meets(world.planes[id.index()], inner);
    const Bounds bounds = primitive_bounds(world, id);
    if (has_inside(world, id) && bounds.contains(enclosure.bounds)) return false;
    const DVec3 middle = 0.5 * (DVec3{bounds.min} + DVec3{bounds.max});
    if (is_inside(world, enclosure.id, middle)) return true;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = inner.center[axis] - inner.reach[axis];
        const double high = inner.center[axis] + inner.reach[axis];
        const bool is_apart = static_cast<double>(bounds.max[axis]) < low ||
                              static_cast<double>(bounds.min[axis]) > high;
        if (is_apart) return false;
    }
    return true;
}

void find_contents(const World& world, const std::vector<Point>& points,
                   std::vector<Enclosure>& enclosures) {
    for (Enclosure& enclosure : enclosures) {
        for (const Point& point : points) {
            if (!is_inside(world, enclosure.id, point.position)) continue;
            (point.camera != nullptr ? enclosure.has_camera : enclosure.has_light) = true;
        }
    }
    each_primitive(world, [&](PrimitiveId id, const Object& object) {
        bool is_open = false;
        for (Enclosure& enclosure : enclosures) {
            if (enclosure.is_room()) continue;
            enclosure.has_content =
                object.visible && id != enclosure.id && is_content(world, id, enclosure);
            is_open = true;
        }
        return is_open;
    });
}

}  // namespace

void warn_enclosed(const Scene& scene, const World& world, Diagnostics& diagnostics) {
    const std::size_t closed_count = world.spheres.size() + world.ellipsoids.size() +
                                     world.cylinders.size() + world.boxes.size() +
                                     world.tori.size();
    const std::vector<Point> points = points_of(scene, world, closed_count);
    std::vector<Enclosure> enclosures = find_enclosures(world, points);
    find_contents(world, points, enclosures);
    for (const Enclosure& enclosure : enclosures) {
        if (enclosure.is_room()) continue;
        const ObjectId object_id = world.object_of(enclosure.id);
        const Node& shape = scene.node(world.object(object_id).node_id);
        const std::string title = title_of(scene, shape);
        if (const Camera* const camera = enclosure.point.camera) {
            const std::string name =
                camera->name.empty() ? std::string{} : fmt::format(" `{}`", camera->name);
            Diagnostic& warning = diagnostics.warning(
                Code::W1203, camera->span,
                fmt::format("the camera{} is inside a {}, and sees nothing else", name, title));
            add_place(warning, scene, world, object_id, "it is inside of this");
        } else {
            const Node& light = scene.node(enclosure.point.light_id);
            Diagnostic& warning = diagnostics.warning(
                Code::W1204, light.span,
                fmt::format("this light is inside an opaque {}, which keeps it in", title));
            add_place(warning, scene, world, object_id, "it is inside of this");
            warning.with_help(
                fmt::format("`casts_shadow: false` in the {} lets it out", name_of(shape.kind)));
        }
    }
}

}  // namespace lray::scene
