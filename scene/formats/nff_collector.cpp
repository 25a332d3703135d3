#include "scene/formats/nff_collector.h"

#include <algorithm>
#include <span>

#include "scene/placer.h"

namespace lray::scene::nff {

void Collector::set_fill(const NffSurface& surface) {
    if (surface == fill_) return;
    fill_ = surface;
    fill_index_.reset();
}

void Collector::add(const NffLight& light) {
    if (!has_room_for_node(light.span)) return;
    if (!take_bytes(sizeof(NffLight) + sizeof(Light), light.span)) return;
    scene_.lights.push_back(light);
}

void Collector::add(const SphereShape& sphere, Span span) {
    add(NodeKind::sphere, scene_.spheres, sphere, span);
}

void Collector::add(const CylinderShape& cone, Span span) {
    add(NodeKind::cylinder, scene_.cylinders, cone, span);
}

void Collector::add_polygon(const std::vector<DVec3>& corners, const std::vector<DVec3>& normals,
                            Span span) {
    if (corners.size() == 3) return add_triangle({0, 1, 2}, corners, normals, span);
    points_.clear();
    for (const DVec3& corner : corners) points_.emplace_back(corner);
    const std::span<const IndexTriple> triangles = triangulator_.triangulate(points_);
    // Corners on a line make triangles without area: nobody misses them, if others are left.
    bool has_area = false;
    for (const IndexTriple& t : triangles) {
        if (is_degenerate(points_[t[0]], points_[t[1]], points_[t[2]])) continue;
        add_triangle(t, corners, normals, span);
        has_area = true;
    }
    if (!has_area) add_triangle(triangles.front(), corners, normals, span);
}

void Collector::add_triangle(const IndexTriple& corners, const std::vector<DVec3>& points,
                             const std::vector<DVec3>& normals, Span span) {
    const auto& [a, b, c] = corners;
    TriangleShape shape{points[a], points[b], points[c]};
    if (!normals.empty()) {
        const std::array of_corners{normals[a], normals[b], normals[c]};
        const bool are_usable =
            std::all_of(of_corners.begin(), of_corners.end(),
                        [](const DVec3& normal) { return unit(normal).has_value(); });
        if (are_usable) {
            shape.attributes = static_cast<std::uint32_t>(scene_.triangle_attributes.size());
            scene_.triangle_attributes.push_back({of_corners, {}});
        }
    }
    add(NodeKind::triangle, scene_.triangles, shape, span);
}

template <class Shape>
void Collector::add(NodeKind kind, std::vector<Shape>& shapes, const Shape& shape, Span span) {
    if (!has_room_for_node(span)) return;
    const std::optional<std::uint32_t> surface = surface_index(span);
    if (!surface) return;
    scene_.shapes.push_back({kind, static_cast<std::uint32_t>(shapes.size()), *surface, span});
    shapes.push_back(shape);
}

std::optional<std::uint32_t> Collector::surface_index(Span span) {
    if (fill_index_) return fill_index_;
    const std::array key{fill_.color.x,  fill_.color.y, fill_.color.z,  fill_.diffuse,
                         fill_.specular, fill_.shine,   fill_.transmit, fill_.index};
    const auto [known, is_new] =
        surfaces_.try_emplace(key, static_cast<std::uint32_t>(scene_.surfaces.size()));
    if (is_new) {
        constexpr std::uint64_t kLinksOfMap = 4 * sizeof(void*);
        constexpr std::uint64_t kSize =
            sizeof(Material) + sizeof(NffSurface) + sizeof(*known) + kLinksOfMap;
        if (!take_bytes(kSize, span)) return std::nullopt;
        scene_.surfaces.push_back(fill_);
    }
    return fill_index_ = known->second;
}

bool Collector::has_room_for_node(Span span) {
    const std::uint64_t used = limits_.used_nodes + scene_.shapes.size() + scene_.lights.size();
    if (used < limits_.nodes || is_full_) return !is_full_;
    mistakes_.too_many_nodes(span, limits_.nodes);
    is_full_ = true;
    return false;
}

bool Collector::take_bytes(std::uint64_t size, Span span) {
    value_bytes_ += size;
    if (value_bytes_ <= limits_.value_bytes) return true;
    mistakes_.too_many_bytes(span, limits_.value_bytes);
    is_full_ = true;
    return false;
}

}  // namespace lray::scene::nff
