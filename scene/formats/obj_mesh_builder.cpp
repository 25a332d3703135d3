#include "scene/formats/obj_mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assert.h"

namespace lray::scene::obj {

namespace {

constexpr std::uint32_t kNone = Mesh::kNone;
constexpr IndexTriple kNoTriple = {kNone, kNone, kNone};

}  // namespace

void MeshBuilder::reserve(const Counts& counts) {
    mesh_.positions.reserve(counts.positions);
    mesh_.uvs.reserve(counts.uvs);
    mesh_.normals.reserve(counts.normals);
    if (counts.corners > 2 * counts.faces) {
        mesh_.triangles.reserve(counts.corners - 2 * counts.faces);
    }
}

void MeshBuilder::add_normal(DVec3 direction) {
    const double size =
        std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    Vec3 normal(0.0f);
    if (size > 0) {
        // The largest component becomes 1: squares of tiny ones would vanish.
        const DVec3 scaled(direction.x / size, direction.y / size, direction.z / size);
        const double length = std::sqrt(dot(scaled, scaled));
        normal = Vec3(DVec3(scaled.x / length, scaled.y / length, scaled.z / length));
    } else {
        has_zero_normals_ = true;
    }
    mesh_.normals.push_back(normal);
}

void MeshBuilder::add_face(std::span<const Corner> corners) {
    bool has_uvs = true;
    bool has_normals = true;
    for (const Corner& corner : corners) {
        has_uvs = has_uvs && corner.uv != kNone;
        has_normals = has_normals && corner.normal != kNone;
    }
    const std::size_t triangle_count = mesh_.triangles.size();
    if (has_uvs && mesh_.uv_indices.empty()) {
        mesh_.uv_indices.reserve(mesh_.triangles.capacity());
        mesh_.uv_indices.resize(triangle_count, kNoTriple);
    }
    if (has_normals && mesh_.normal_indices.empty()) {
        mesh_.normal_indices.reserve(mesh_.triangles.capacity());
        mesh_.normal_indices.resize(triangle_count, kNoTriple);
    }

    const std::size_t corner_count = corners.size();
    if (corner_count == 3) {
        add_triangle(corners[0], corners[1], corners[2], has_uvs, has_normals);
        return;
    }
    const auto is_late = [&](const Corner& corner) {
        return corner.position >= mesh_.positions.size();
    };
    if (std::any_of(corners.begin(), corners.end(), is_late)) {
        late_polygons_.push_back({triangle_count, corner_count - 2});
        for (std::size_t i = 2; i < corner_count; ++i) {
            add_triangle(corners[0], corners[i - 1], corners[i], has_uvs, has_normals);
        }
        return;
    }
    polygon_.clear();
    for (const Corner& corner : corners) polygon_.push_back(mesh_.positions[corner.position]);
    for (const auto [a, b, c] : triangulator_.triangulate(polygon_)) {
        add_triangle(corners[a], corners[b], corners[c], has_uvs, has_normals);
    }
}

void MeshBuilder::add_triangle(const Corner& a, const Corner& b, const Corner& c, bool has_uvs,
                               bool has_normals) {
    mesh_.triangles.push_back({a.position, b.position, c.position});
    if (!mesh_.uv_indices.empty() || has_uvs) {
        mesh_.uv_indices.push_back(has_uvs ? IndexTriple{a.uv, b.uv, c.uv} : kNoTriple);
    }
    if (!mesh_.normal_indices.empty() || has_normals) {
        mesh_.normal_indices.push_back(has_normals ? IndexTriple{a.normal, b.normal, c.normal}
                                                   : kNoTriple);
    }
}

void MeshBuilder::begin_object(std::string name) {
    close_part(open_group_);
    begin_part(open_object_, std::move(name));
}

void MeshBuilder::begin_group(std::string name) {
    begin_part(open_group_, std::move(name));
}

void MeshBuilder::begin_part(std::size_t& open, std::string name) {
    if (open != kNoPart && mesh_.parts[open].name == name) return;
    close_part(open);
    open = mesh_.parts.size();
    mesh_.parts.push_back({std::move(name), static_cast<std::uint32_t>(mesh_.triangles.size()), 0});
}

/// Parts nest: one that turns out to be empty is the last.
void MeshBuilder::close_part(std::size_t& open) {
    if (open == kNoPart) return;
    MeshPart& part = mesh_.parts[open];
    const std::size_t count = mesh_.triangles.size() - part.first_triangle;
    part.triangle_count = static_cast<std::uint32_t>(count);
    if (count == 0) {
        LRAY_ASSERT(open + 1 == mesh_.parts.size());
        mesh_.parts.pop_back();
    }
    open = kNoPart;
}

std::optional<Mesh> MeshBuilder::finish() {
    if (mesh_.triangles.empty() || !are_indices_in_range()) return {};
    close_part(open_group_);
    close_part(open_object_);
    index_parts(mesh_);
    triangulate_late_polygons();
    if (has_zero_normals_) forget_zero_normals();
    return std::move(mesh_);
}

bool MeshBuilder::are_indices_in_range() const {
    const auto count_needed = [](const std::vector<IndexTriple>& triples) {
        std::uint32_t count = 0;
        for (const IndexTriple& triple : triples) {
            for (const std::uint32_t index : triple) count = std::max(count, index + 1);  // none: 0
        }
        return count;
    };
    return count_needed(mesh_.triangles) <= mesh_.positions.size() &&
           count_needed(mesh_.uv_indices) <= mesh_.uvs.size() &&
           count_needed(mesh_.normal_indices) <= mesh_.normals.size();
}

/// Cuts again, now by shape, what was laid down as fans.
void MeshBuilder::triangulate_late_polygons() {
    std::vector<IndexTriple> fan;
    for (const LatePolygon& late : late_polygons_) {
        const auto corner_of = [&](const IndexTriple* triangles, std::size_t corner) {
            return corner < 2 ? triangles[0][corner] : triangles[corner - 2][2];
        };
        const std::size_t corner_count = late.triangle_count + 2;
        polygon_.clear();
        for (std::size_t i = 0; i < corner_count; ++i) {
            const std::uint32_t index = corner_of(&mesh_.triangles[late.first_triangle], i);
            polygon_.push_back(mesh_.positions[index]);
        }
        const std::span<const IndexTriple> cut = triangulator_.triangulate(polygon_);
        for (auto* triples : {&mesh_.triangles, &mesh_.uv_indices, &mesh_.normal_indices}) {
            if (triples->empty()) continue;
            IndexTriple* const first = triples->data() + late.first_triangle;
            fan.assign(first, first + late.triangle_count);
            for (std::size_t i = 0; i < cut.size(); ++i) {
                for (std::size_t k = 0; k < 3; ++k) first[i][k] = corner_of(fan.data(), cut[i][k]);
            }
        }
    }
}

void MeshBuilder::forget_zero_normals() {
    for (IndexTriple& triple : mesh_.normal_indices) {
        const bool has_zero =
            triple[0] != kNone && std::any_of(triple.begin(), triple.end(), [&](auto index) {
                return mesh_.normals[index] == Vec3(0.0f);
            });
        if (has_zero) triple = kNoTriple;
    }
}

}  // namespace lray::scene::obj
