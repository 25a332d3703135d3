#include "scene/node_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "scene/content_map.h"
#include "scene/placer.h"

namespace lray::scene {

namespace {

/// How far something reaches along a direction d: the least and the greatest d . p of its points.
/// A box is the extent along three axes. An affine map p -> A p + b turns the extent along d into
/// that along transpose(A) d, moved by d . b, so every shape is measured in its own space.
struct Extent {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -std::numeric_limits<double>::infinity();

    bool is_empty() const { return !(least <= greatest); }

    void add(double x) {
        least = std::min(least, x);
        greatest = std::max(greatest, x);
    }
    void add(const Extent& other) {
        least = std::min(least, other.least);
        greatest = std::max(greatest, other.greatest);
    }
};

/// How far a ball or disk reaches to both sides of its centre.
Extent around(double center, double reach) {
    return {center - reach, center + reach};
}

double length(DVec3 v) {
    // By the largest component first: no square over- or underflows.
    const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    if (!(largest > 0.0)) return 0.0;
    const DVec3 scaled = v / largest;
    return largest * std::sqrt(dot(scaled, scaled));
}

/// Of a circle: the part of the direction that lies in its plane counts.
Extent circle(DVec3 center, DVec3 unit_axis, double radius, DVec3 direction) {
    return around(dot(direction, center), radius * length(cross(direction, unit_axis)));
}

Extent points(std::span<const DVec3> corners, DVec3 direction) {
    Extent extent;
    for (const DVec3 corner : corners) extent.add(dot(direction, corner));
    return extent;
}

Extent cylinder(const CylinderShape& shape, DVec3 direction) {
    // Ends at the same point make a disk without an axis; flatten() refuses it.
    const DVec3 axis = unit(shape.to - shape.from).value_or(DVec3{0.0});
    Extent extent = circle(shape.from, axis, shape.radius, direction);
    extent.add(circle(shape.to, axis, shape.radius_to, direction));
    return extent;
}

Extent box(const BoxShape& shape, DVec3 direction) {
    Extent extent{0.0, 0.0};
    for (int axis = 0; axis < 3; ++axis) {
        const double a = direction[axis] * shape.min[axis];
        const double b = direction[axis] * shape.max[axis];
        extent.least += std::min(a, b);
        extent.greatest += std::max(a, b);
    }
    return extent;
}

Extent mesh(const Mesh& mesh, std::span<const TriangleRange> ranges, bool z_is_up,
            DVec3 direction) {
    // Z up: (x, y, z) stands for (x, z, -y).
    const DVec3 d = z_is_up ? DVec3{direction.x, -direction.z, direction.y} : direction;
    Extent extent;
    for (const TriangleRange range : ranges) {
        for (std::size_t i = range.first; i < range.first + range.count; ++i) {
            for (const std::uint32_t vertex : mesh.triangles[i]) {
                extent.add(dot(d, DVec3{mesh.positions[vertex]}));
            }
        }
    }
    return extent;
}

/// A direction along an axis is that axis times a factor: everything along it is measured once.
struct Axis {
    int index = 0;
    double factor = 1.0;
};

std::optional<Axis> axis_of(DVec3 direction) {
    std::optional<Axis> axis;
    for (int i = 0; i < 3; ++i) {
        if (direction[i] == 0.0) continue;
        if (axis) return std::nullopt;
        axis = Axis{i, direction[i]};
    }
    return axis;
}

class Measurer {
 public:
    Measurer(const Scene& scene, std::uint64_t max_work) : scene_(scene), max_work_(max_work) {}

    NodeBounds measure(NodeId id) {
        NodeBounds bounds;
        for (int axis = 0; axis < 3 && !stopped_; ++axis) {
            DVec3 direction{0.0};
            direction[axis] = 1.0;
            const Extent extent = extent_of(id, direction);
            bounds.min[axis] = extent.least;
            bounds.max[axis] = extent.greatest;
            if (extent.is_empty()) break;
            bounds.outcome = NodeBounds::Outcome::box;
        }
        if (stopped_) bounds.outcome = *stopped_;
        bounds.work = work_;
        return bounds;
    }

 private:
    /// A group or instance whose children are being measured.
    struct Step {
        NodeId id{};
        DVec3 direction{};    // in the node's own space
        double factor = 1.0;  // what the direction was divided by
        double offset = 0.0;  // of the node's origin, along the direction above
        std::size_t next_child = 0;
        Extent extent{};
    };

    /// The stack is its own: how deep groups nest is up to the scene.
    Extent extent_of(NodeId id, DVec3 direction) {
        std::vector<Step> stack;
        Extent result;
        const auto deliver = [&](const Extent& extent) {
            (stack.empty() ? result : stack.back().extent).add(extent);
        };
        if (const auto extent = enter(id, direction, stack)) deliver(*extent);
        while (!stack.empty() && !stopped_) {
            Step& step = stack.back();
            const auto children = children_of(scene_, scene_.node(step.id));
            if (step.next_child < children.size()) {
                const NodeId child = children[step.next_child++];
                const DVec3 down = step.direction;  // entering moves the stack
                if (const auto extent = enter(child, down, stack)) deliver(*extent);
                continue;
            }
            const Step done = step;
            stack.pop_back();
            keep(done.id, done.direction, done.extent);
            deliver(placed(done.extent, done.factor, done.offset));
        }
        return result;
    }

    /// Returns the extent of a node along a direction above its transform; empty when its children
    /// come first, or nothing more is measured.
    std::optional<Extent> enter(NodeId id, DVec3 direction, std::vector<Step>& stack) {
        if (!take_work(1)) return std::nullopt;
        const Node& node = scene_.node(id);
        Step step{id, direction, 1.0, 0.0, 0, {}};
        if (!node.transform_id.is_none()) {
            const Transform& transform = scene_.transforms[node.transform_id.index()];
            step.direction = direction * transform.linear();  // transpose(linear) * direction
            step.offset = dot(direction, transform.offset());
        }
        if (const auto axis = axis_of(step.direction)) {
            step.direction = DVec3{0.0};
            step.direction[axis->index] = 1.0;
            step.factor = axis->factor;
            const auto known = known_.find({id.value, axis->index});
            if (known != known_.end()) return placed(known->second, step.factor, step.offset);
        }
        if (node.kind == NodeKind::group || node.kind == NodeKind::instance) {
            stack.push_back(step);
            return std::nullopt;
        }
        const Extent extent = shape_extent(node, step.direction);
        if (node.kind == NodeKind::mesh) keep(id, step.direction, extent);
        return placed(extent, step.factor, step.offset);
    }

    Extent shape_extent(const Node& node, DVec3 direction) {
        switch (node.kind) {
            case NodeKind::sphere: {
                const SphereShape& shape = scene_.spheres[node.index];
                return around(dot(direction, shape.center), shape.radius * length(direction));
            }
            case NodeKind::rectangle: {
                const auto& [corner, edge_u, edge_v] = scene_.rectangles[node.index];
                return points(
                    std::array{corner, corner + edge_u, corner + edge_v, corner + edge_u + edge_v},
                    direction);
            }
            case NodeKind::triangle: {
                const TriangleShape& shape = scene_.triangles[node.index];
                return points(std::array{shape.a, shape.b, shape.c}, direction);
            }
            case NodeKind::cylinder:
                return cylinder(scene_.cylinders[node.index], direction);
            case NodeKind::disk: {
                const DiskShape& shape = scene_.disks[node.index];
                const DVec3 axis = unit(shape.normal).value_or(DVec3{0.0});
                return circle(shape.center, axis, shape.radius, direction);
            }
            case NodeKind::box:
                return box(scene_.boxes[node.index], direction);
            case NodeKind::plane:
                stopped_ = NodeBounds::Outcome::infinite;
                return {};
            case NodeKind::torus: {
                const auto& [radius, tube] = scene_.tori[node.index];
                const DVec3 axis{0.0, 1.0, 0.0};
                return around(0.0,
                              radius * length(cross(direction, axis)) + tube * length(direction));
            }
            case NodeKind::mesh:
                return mesh_extent(scene_.mesh_uses[node.index], direction);
            case NodeKind::light:
                return {};
            case NodeKind::group:
            case NodeKind::instance:
                break;
        }
        LRAY_ASSERT(false);
    }

    Extent mesh_extent(const MeshUse& use, DVec3 direction) {
        const std::vector<TriangleRange> ranges = triangles_of(scene_, use);
        std::uint64_t work = ranges.size();
        constexpr std::uint64_t kTrianglesPerUnit = 4;
        for (const TriangleRange range : ranges) work += range.count / kTrianglesPerUnit;
        if (!take_work(work)) return {};
        return mesh(scene_.meshes[use.mesh_id.index()], ranges, use.z_is_up, direction);
    }

    /// Returns the extent in the space above.
    Extent placed(const Extent& extent, double factor, double offset) {
        if (extent.is_empty()) return {};
        const double a = extent.least * factor + offset;
        const double b = extent.greatest * factor + offset;
        if (!std::isfinite(a) || !std::isfinite(b)) stopped_ = NodeBounds::Outcome::infinite;
        return {std::min(a, b), std::max(a, b)};
    }

    void keep(NodeId id, DVec3 direction, const Extent& extent) {
        if (const auto axis = axis_of(direction))
            known_.emplace(Key{id.value, axis->index}, extent);
    }

    bool take_work(std::uint64_t work) {
        if (work_ + work > max_work_) stopped_ = NodeBounds::Outcome::too_large;
        work_ = std::min(work_ + work, max_work_);
        return !stopped_;
    }

    using Key = std::pair<std::uint32_t, int>;  // a node and an axis of its own space
    struct Hash {
        std::size_t operator()(const Key& key) const {
            return std::size_t{key.first} * 3 + static_cast<std::size_t>(key.second);
        }
    };

    const Scene& scene_;
    std::uint64_t max_work_ = 0;
    std::uint64_t work_ = 0;
    std::optional<NodeBounds::Outcome> stopped_{};
    std::unordered_map<Key, Extent, Hash> known_{};
};

}  // namespace

NodeBounds node_bounds(const Scene& scene, NodeId id, std::uint64_t max_work) {
    return Measurer(scene, max_work).measure(id);
}

}  // namespace lray::scene
