#include "scene/placer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "base/assert.h"

namespace lray::scene {

namespace {

DVec3 absolute(DVec3 v) {
    return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)};
}

double length(DVec3 v) {
    return std::sqrt(dot(v, v));
}

/// Returns the rotation that turns +Y onto the unit vector n by the shortest arc; for -Y, half a
/// turn about X.
DMat3 rotation_to(DVec3 n) {
    const double across = n.x * n.x + n.z * n.z;
    if (across == 0.0 && n.y < 0.0) {
        return {DVec3{1.0, 0.0, 0.0}, DVec3{0.0, -1.0, 0.0}, DVec3{0.0, 0.0, -1.0}};
    }
    // Rodrigues' formula with the axis Y x n; 1 + n.y without cancellation near -Y.
    const double k = n.y < 0.0 ? (1.0 - n.y) / across : 1.0 / (1.0 + n.y);
    return {DVec3{n.y + n.z * n.z * k, -n.x, -n.x * n.z * k}, n,
            DVec3{-n.x * n.z * k, -n.z, n.y + n.x * n.x * k}};
}

}  // namespace

double reach(DVec3 v) {
    const DVec3 a = absolute(v);
    if (std::isnan(a.x) || std::isnan(a.y) || std::isnan(a.z)) {
        return std::numeric_limits<double>::infinity();
    }
    return std::max(a.x, std::max(a.y, a.z));
}

std::optional<DVec3> unit(DVec3 v) {
    // By the largest component first: no square over- or underflows.
    const double largest = reach(v);
    if (!(largest > 0.0 && std::isfinite(largest))) return std::nullopt;
    const DVec3 scaled = v / largest;
    return scaled / length(scaled);
}

bool is_degenerate(Vec3 a, Vec3 b, Vec3 c) {
    return cross(DVec3{b} - DVec3{a}, DVec3{c} - DVec3{a}) == DVec3{0.0};
}

void Placer::place(NodeId node_id, const Placement& placement) {
    const Node& node = scene_.node(node_id);
    if (node.kind == NodeKind::mesh) return place_mesh(node_id, placement);
    if (!begin_object(node_id, placement)) return;
    switch (node.kind) {
        case NodeKind::sphere:
            return place_sphere(node, placement);
        case NodeKind::rectangle:
            return place_rectangle(node, placement);
        case NodeKind::triangle:
            return place_triangle(node, placement);
        case NodeKind::cylinder:
            return place_cylinder(node, placement);
        case NodeKind::disk:
            return place_disk(node, placement);
        case NodeKind::box:
            return place_box(node, placement);
        case NodeKind::plane:
            return place_plane(node, placement);
        case NodeKind::torus:
            return place_torus(node, placement);
        case NodeKind::mesh:
        case NodeKind::group:
        case NodeKind::instance:
        case NodeKind::light:
            break;
    }
    LRAY_ASSERT(false);
}

void Placer::add_object(NodeId node_id, const Placement& placement) {
    object_id_ = ObjectId{geometry_.objects.size()};
    geometry_.objects.push_back(
        {node_id, placement.material, placement.visible, placement.casts_shadow, false});
}

bool Placer::begin_object(NodeId node_id, const Placement& placement) {
    add_object(node_id, placement);
    return !space_rule_.is_kept(placement.material) ||
           keep_space(scene_.node(node_id), placement.world_from_object);
}

bool Placer::keep_space(const Node& node, const Transform& world_from_object) {
    const auto inverse = world_from_object.inverse();
    if (!inverse) {
        refuse(Code::E0310, node,
               fmt::format("the transform of this {} cannot be inverted", name_of(node.kind)));
        return false;
    }
    geometry_.object_spaces.add(object_id_, {inverse->linear(), inverse->offset()});
    return true;
}

void Placer::finish() {
    constexpr IndexTriple kAbsent{Mesh::kNone, Mesh::kNone, Mesh::kNone};
    const std::size_t count = geometry_.triangles.size();
    if (!geometry_.triangle_normals.empty()) geometry_.triangle_normals.resize(count, kAbsent);
    if (!geometry_.triangle_uvs.empty()) geometry_.triangle_uvs.resize(count, kAbsent);
    if (!geometry_.colors.empty()) geometry_.colors.resize(geometry_.vertices.size(), Color{1.0f});
}

void Placer::place_sphere(const Node& node, const Placement& placement) {
    const SphereShape& shape = scene_.spheres[node.index];
    const Transform& transform = placement.world_from_object;
    const DVec3 center = transform.point(shape.center);
    if (!transform.is_similarity()) {
        const auto frame = make_frame(node, transform.linear() * shape.radius, center);
        if (!frame) return;
        geometry_.ellipsoids.push_back({*frame});
        add_object_id(PrimitiveKind::ellipsoid);
        return;
    }
    const double radius = shape.radius * transform.similarity_scale();
    if (!are_placeable(node, std::array{center + radius, center - radius})) return;
    if (!(radius >= kMinSize)) {
        refuse(Code::E0304, node,
               fmt::format("the radius of this sphere is {} in the world; the least is {}", radius,
                           kMinSize));
        return;
    }
    geometry_.spheres.push_back({Vec3{center}, static_cast<float>(radius)});
    add_object_id(PrimitiveKind::sphere);
}

void Placer::place_cylinder(const Node& node, const Placement& placement) {
    const CylinderShape& shape = scene_.cylinders[node.index];
    const Transform& transform = placement.world_from_object;
    // The wider end is at the bottom of the frame.
    const bool is_turned = shape.radius_to > shape.radius;
    const DVec3 bottom = is_turned ? shape.to : shape.from;
    const DVec3 axis = shape.to - shape.from;
    const double radius = is_turned ? shape.radius_to : shape.radius;
    const double top_radius = is_turned ? shape.radius : shape.radius_to;
    const auto direction = unit(axis);
    // No length or no radius makes a frame that is refused.
    const DMat3 turn = direction ? rotation_to(*direction) : DMat3{0.0};
    DMat3 linear_object{radius * turn[0], axis, radius * turn[2]};
    if (is_turned) {  // half a turn about its x axis
        linear_object[1] = -linear_object[1];
        linear_object[2] = -linear_object[2];
    }
    const auto frame =
        make_frame(node, transform.linear() * linear_object, transform.point(bottom));
    if (!frame) return;
    geometry_.cylinders.push_back(
        {*frame, static_cast<float>(top_radius / radius), shape.caps, is_turned});
    add_object_id(PrimitiveKind::cylinder);
}

void Placer::place_disk(const Node& node, const Placement& placement) {
    const DiskShape& shape = scene_.disks[node.index];
    const Transform& transform = placement.world_from_object;
    const auto normal_object = unit(shape.normal);
    const DMat3 turn = normal_object ? rotation_to(*normal_object) : DMat3{0.0};
    DMat3 linear = transform.linear() * (turn * shape.radius);
    // A disk has no thickness: its y axis may as well be at right angles, and as long as it is
    // wide.
    const auto normal = unit(transform.normal(shape.normal));
    linear[1] = normal ? *normal * std::max(length(linear[0]), length(linear[2])) : DVec3{0.0};
    const auto frame = make_frame(node, linear, transform.point(shape.center));
    if (!frame) return;
    geometry_.disks.push_back({*frame, static_cast<float>(shape.hole / shape.radius)});
    add_object_id(PrimitiveKind::disk);
}

void Placer::place_box(const Node& node, const Placement& placement) {
    const BoxShape& shape = scene_.boxes[node.index];
    const Transform& transform = placement.world_from_object;
    const DVec3 half = (shape.max - shape.min) * 0.5;
    const DMat3 linear{transform.linear()[0] * half.x, transform.linear()[1] * half.y,
                       transform.linear()[2] * half.z};
    const auto frame = make_frame(node, linear, transform.point((shape.min + shape.max) * 0.5));
    if (!frame) return;
    geometry_.boxes.push_back({*frame});
    add_object_id(PrimitiveKind::box);
}

void Placer::place_plane(const Node& node, const Placement& placement) {
    const PlaneShape& shape = scene_.planes[node.index];
    const DVec3 point = placement.world_from_object.point(shape.point);
    if (!are_placeable(node, std::array{point})) return;
    const auto normal = unit(placement.world_from_object.normal(shape.normal));
    if (!normal) {
        refuse(Code::E0310, node, "the transform leaves this plane no normal");
        return;
    }
    const auto inverse = placement.world_from_object.inverse();
    const auto normal_object = unit(shape.normal);
    Plane plane{Vec3{point}, Vec3{*normal}, Vec3{0.0f}, Vec3{0.0f}};
    if (inverse && normal_object) {
        const DMat3 turn = rotation_to(*normal_object);
        const DVec3 u = turn[0] * inverse->linear();  // the transpose times the vector
        const DVec3 v = -turn[2] * inverse->linear();
        // Of a plane shrunk beyond what a float holds nothing is left to see.
        constexpr double kMost = static_cast<double>(std::numeric_limits<float>::max());
        if (reach(u) <= kMost && reach(v) <= kMost) {
            plane.gradient_u = Vec3{u};
            plane.gradient_v = Vec3{v};
        }
    }
    geometry_.planes.push_back(plane);
    add_object_id(PrimitiveKind::plane);
}

void Placer::place_torus(const Node& node, const Placement& placement) {
    const TorusShape& shape = scene_.tori[node.index];
    const Transform& transform = placement.world_from_object;
    const double outer_radius = shape.radius + shape.tube;
    const auto frame = make_frame(node, transform.linear() * outer_radius, transform.offset());
    if (!frame) return;
    const double tube = shape.tube / outer_radius;
    double steepest = 0.0;
    for (int column = 0; column < 3; ++column) {
        steepest = std::max(steepest, reach(DVec3{frame->object_from_world[column]}));
    }
    if (!(tube / steepest >= kMinSize)) {
        refuse(Code::E0304, node,
               fmt::format("the tube of this torus is {} thin in the world; the least is {}",
                           tube / steepest, kMinSize));
        return;
    }
    geometry_.tori.push_back({*frame, static_cast<float>(tube)});
    add_object_id(PrimitiveKind::torus);
}

std::optional<AffineFrame> Placer::make_frame(const Node& node, const DMat3& linear, DVec3 offset) {
    const DVec3 extent = absolute(linear[0]) + absolute(linear[1]) + absolute(linear[2]);
    if (!are_placeable(node, std::array{offset + extent, offset - extent})) return std::nullopt;
    return invert(node, linear, offset);
}

std::optional<AffineFrame> Placer::invert(const Node& node, const DMat3& linear, DVec3 offset) {
    const auto inverse = Transform::affine(linear, DVec3{0.0}).inverse();
    if (!inverse) {
        refuse(Code::E0310, node,
               fmt::format("the transform flattens this {} and cannot be inverted",
                           name_of(node.kind)));
        return std::nullopt;
    }
    double steepest = 0.0;
    for (int column = 0; column < 3; ++column) {
        steepest = std::max(steepest, reach(inverse->linear()[column]));
    }
    if (!(steepest <= 1.0 / kMinSize)) {
        refuse(Code::E0304, node,
               fmt::format("this {} is {} thin in the world; the least is {}", name_of(node.kind),
                           1.0 / steepest, kMinSize));
        return std::nullopt;
    }
    AffineFrame frame{Vec3{offset}, Mat3{inverse->linear()}};
    // In float the inverse must still undo the map: a very flat and skewed one rounds to a shape of
    // another size. A hundredth of the size would be seen.
    constexpr double kMaxDistortion = 0.01;
    const DMat3 product = DMat3{frame.object_from_world} * linear;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            const double distortion = std::fabs(product[column][row] - (row == column ? 1.0 : 0.0));
            if (distortion <= kMaxDistortion) continue;
            refuse(Code::E0310, node,
                   fmt::format("the transform flattens this {} too much to be inverted",
                               name_of(node.kind)));
            return std::nullopt;
        }
    }
    return frame;
}

bool Placer::are_placeable(const Node& node, std::span<const DVec3> points) {
    double furthest = 0.0;
    for (const DVec3 point : points) furthest = std::max(furthest, reach(point));
    if (furthest <= kMaxCoordinate) return true;
    refuse(Code::E0304, node,
           fmt::format("this {} reaches to {:.3g} in the world; coordinates end at {:.3g}",
                       name_of(node.kind), furthest, kMaxCoordinate));
    return false;
}

void Placer::refuse(Code code, const Node& node, std::string message) {
    ++refused_count_;
    diagnostics_.error(code, node.span, std::move(message));
}

void Placer::warn_no_area(const Node& node) {
    diagnostics_.warning(Code::W1201, node.span,
                         fmt::format("this {} has no area", name_of(node.kind)));
}

}  // namespace lray::scene
