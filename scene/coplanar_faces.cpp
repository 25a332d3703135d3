#include "scene/coplanar_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "base/numerics.h"
#include "scene/each_primitive.h"
#include "scene/inside.h"
#include "scene/same_look.h"

namespace lray::scene {

namespace {

constexpr std::size_t kMaxCompared = 1'000;  // of boxes, and of rectangles
constexpr std::size_t kMaxTests = 20'000;
constexpr std::size_t kMaxPairs = 16;

/// Faces that only share an edge overlap by rounding alone.
constexpr double kMinOverlap = 1e-3;

/// A rectangle along the axes that faces up or down the axis `axis`.
struct Face {
    int axis = 0;
    bool faces_up = false;
    double height = 0.0;
    double error = 0.0;  // of the height
    DVec3 min{};
    DVec3 max{};
    PrimitiveId id{};
};

void add_rectangle(const Rectangle& rectangle, PrimitiveId id, std::vector<Face>& faces) {
    Bounds bounds;
    for (const Vec3 corner : rectangle.corners) bounds.add(corner);
    int flat_count = 0;
    int axis = 0;
    for (int i = 0; i < 3; ++i) {
        if (bounds.min[i] != bounds.max[i]) continue;
        ++flat_count;
        axis = i;
    }
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    bool is_along_axes = flat_count == 1;
    for (const Vec3 corner : rectangle.corners) {
        is_along_axes = is_along_axes &&
                        (corner[u] == bounds.min[u] || corner[u] == bounds.max[u]) &&
                        (corner[v] == bounds.min[v] || corner[v] == bounds.max[v]);
    }
    if (!is_along_axes) return;
    const DVec3 min{bounds.min};
    for (const bool faces_up : {false, true}) {
        faces.push_back({axis, faces_up, min[axis],
                         static_cast<double>(gamma<float>(2)) * std::fabs(min[axis]), min,
                         DVec3{bounds.max}, id});
    }
}

void add_box(const Box& box, PrimitiveId id, std::vector<Face>& faces) {
    DVec3 half{};
    for (int row = 0; row < 3; ++row) {
        int entry_count = 0;
        for (int column = 0; column < 3; ++column) {
            const double entry = static_cast<double>(box.frame.object_from_world[column][row]);
            if (entry == 0.0) continue;
            ++entry_count;
            half[column] = 1.0 / std::fabs(entry);
        }
        if (entry_count != 1) return;  // turned
    }
    if (half.x == 0.0 || half.y == 0.0 || half.z == 0.0) return;
    const DVec3 center{box.frame.origin};
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool faces_up : {false, true}) {
            const double height = center[axis] + (faces_up ? half[axis] : -half[axis]);
            // The centre and the inverse of the size are rounded to float.
            const double error =
                static_cast<double>(gamma<float>(2)) * (std::fabs(center[axis]) + half[axis]);
            faces.push_back({axis, faces_up, height, error, center - half, center + half, id});
        }
    }
}

bool has_camera_before(const Scene& scene, const Face& face) {
    return std::any_of(scene.cameras.begin(), scene.cameras.end(), [&](const Camera& camera) {
        const double height = camera.position[face.axis] - face.height;
        return face.faces_up ? height > 0.0 : height < 0.0;
    });
}

/// Returns the middle of the overlap.
std::optional<DVec3> overlap_of(const Face& a, const Face& b) {
    if (std::fabs(a.height - b.height) > a.error + b.error) return std::nullopt;
    DVec3 middle{};
    for (const int axis : {(a.axis + 1) % 3, (a.axis + 2) % 3}) {
        const double low = std::max(a.min[axis], b.min[axis]);
        const double high = std::min(a.max[axis], b.max[axis]);
        const double size = std::min(a.max[axis] - a.min[axis], b.max[axis] - b.min[axis]);
        if (!(high - low > kMinOverlap * size)) return std::nullopt;
        middle[axis] = 0.5 * (low + high);
    }
    middle[a.axis] = a.height;
    return middle;
}

/// True if the point is inside of a primitive, or may be inside of what an instance places.
bool may_be_inside(const World& world, PrimitiveId id, DVec3 point) {
    if (id.kind() != PrimitiveKind::instance) return is_inside(world, id, point);
    const Bounds& bounds = world.instances[id.index()].bounds;
    return bounds.contains({Vec3{point}, Vec3{point}});
}

/// True if something closed lies on the face there, thin or thick.
bool is_covered(const World& world, const Face& face, DVec3 middle) {
    const double size =
        std::max({face.max.x - face.min.x, face.max.y - face.min.y, face.max.z - face.min.z});
    bool is_found = false;
    each_primitive(world, [&](PrimitiveId id, const Object& object) {
        for (const double rise : {0.001, 0.01, 0.1}) {
            DVec3 above = middle;
            above[face.axis] += face.faces_up ? rise * size : -rise * size;
            is_found = is_found || (object.visible && may_be_inside(world, id, above));
        }
        return !is_found;
    });
    return is_found;
}

}  // namespace

std::vector<PrimitivePair> coplanar_faces(const Scene& scene, const World& world) {
    std::vector<Face> faces;
    for (std::size_t i = 0; i < std::min(world.rectangles.size(), kMaxCompared); ++i) {
        add_rectangle(world.rectangles[i], {PrimitiveKind::rectangle, i}, faces);
    }
    for (std::size_t i = 0; i < std::min(world.boxes.size(), kMaxCompared); ++i) {
        add_box(world.boxes[i], {PrimitiveKind::box, i}, faces);
    }
    std::erase_if(faces, [&](const Face& face) { return !has_camera_before(scene, face); });
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
        return std::tie(a.axis, a.faces_up, a.height, a.id) <
               std::tie(b.axis, b.faces_up, b.height, b.id);
    });
    std::vector<PrimitivePair> pairs;
    std::size_t test_count = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Face& face = faces[i];
        for (std::size_t j = i + 1; j < faces.size(); ++j) {
            const Face& other = faces[j];
            const bool is_far = other.axis != face.axis || other.faces_up != face.faces_up ||
                                other.height - face.height > face.error + other.error;
            if (is_far) break;
            if (++test_count > kMaxTests || pairs.size() == kMaxPairs) return pairs;
            const auto middle = overlap_of(face, other);
            if (!middle || face.id == other.id) continue;
            if (!shows_a_difference(world, face.id, other.id)) continue;
            if (is_covered(world, face, *middle)) continue;
            pairs.push_back({std::min(face.id, other.id), std::max(face.id, other.id)});
        }
    }
    return pairs;
}

}  // namespace lray::scene
