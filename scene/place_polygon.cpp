// Placing rectangles and triangles as they are authored.
#include <array>

#include "scene/placer.h"

namespace lray::scene {

void Placer::place_rectangle(const Node& node, const Placement& placement) {
    const RectangleShape& shape = scene_.rectangles[node.index];
    const Transform& transform = placement.world_from_object;
    const std::array corners{transform.point(shape.corner),
                             transform.point(shape.corner + shape.edge_u),
                             transform.point(shape.corner + shape.edge_u + shape.edge_v),
                             transform.point(shape.corner + shape.edge_v)};
    if (!are_placeable(node, corners)) return;
    const Rectangle rectangle{
        {Vec3{corners[0]}, Vec3{corners[1]}, Vec3{corners[2]}, Vec3{corners[3]}},
        placement.is_mirrored};
    const auto& [p00, p10, p11, p01] = rectangle.corners;
    if (is_degenerate(p00, p10, p11) && is_degenerate(p00, p11, p01)) return warn_no_area(node);
    geometry_.rectangles.push_back(rectangle);
    add_object_id(PrimitiveKind::rectangle);
}

void Placer::place_triangle(const Node& node, const Placement& placement) {
    const TriangleShape& shape = scene_.triangles[node.index];
    const Transform& transform = placement.world_from_object;
    std::array corners{transform.point(shape.a), transform.point(shape.b),
                       transform.point(shape.c)};
    if (!are_placeable(node, corners)) return;
    const std::array order = placement.is_mirrored ? std::array<std::size_t, 3>{0, 2, 1}
                                                   : std::array<std::size_t, 3>{0, 1, 2};
    const auto base = static_cast<std::uint32_t>(geometry_.vertices.size());
    const Vec3 a{corners[order[0]]};
    const Vec3 b{corners[order[1]]};
    const Vec3 c{corners[order[2]]};
    if (is_degenerate(a, b, c)) return warn_no_area(node);
    geometry_.vertices.insert(geometry_.vertices.end(), {a, b, c});
    geometry_.triangles.push_back({{base, base + 1, base + 2}});
    add_object_id(PrimitiveKind::triangle);
    if (shape.attributes == TriangleShape::kNoAttributes) return;

    const TriangleAttributes& attributes = scene_.triangle_attributes[shape.attributes];
    if (attributes.normals) {
        std::array<Vec3, 3> normals{};
        bool are_usable = true;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto normal = unit(transform.normal((*attributes.normals)[order[i]]));
            are_usable = are_usable && normal.has_value();
            if (normal) normals[i] = Vec3{*normal};
        }
        if (are_usable) {
            const auto first = static_cast<std::uint32_t>(geometry_.normals.size());
            geometry_.normals.insert(geometry_.normals.end(), normals.begin(), normals.end());
            set_triangle_normals({first, first + 1, first + 2});
        }
    }
    if (attributes.uvs) {
        const auto first = static_cast<std::uint32_t>(geometry_.uvs.size());
        for (const std::size_t i : order) geometry_.uvs.push_back(Vec2{(*attributes.uvs)[i]});
        set_triangle_uvs({first, first + 1, first + 2});
    }
}

void Placer::set_triangle_normals(const IndexTriple& triple) {
    constexpr IndexTriple kAbsent{Mesh::kNone, Mesh::kNone, Mesh::kNone};
    geometry_.triangle_normals.resize(geometry_.triangles.size() - 1, kAbsent);
    geometry_.triangle_normals.push_back(triple);
}

void Placer::set_triangle_uvs(const IndexTriple& triple) {
    constexpr IndexTriple kAbsent{Mesh::kNone, Mesh::kNone, Mesh::kNone};
    geometry_.triangle_uvs.resize(geometry_.triangles.size() - 1, kAbsent);
    geometry_.triangle_uvs.push_back(triple);
}

}  // namespace lray::scene
