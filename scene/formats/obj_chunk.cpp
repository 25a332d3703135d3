#include "scene/formats/obj_chunk.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lray::scene::obj {

namespace {

constexpr std::uint32_t kNone = Mesh::kNone;
constexpr IndexTriple kNoTriple = {kNone, kNone, kNone};

}  // namespace

void ChunkBuilder::reserve(const Counts& counts) {
    chunk_.positions.reserve(counts.positions);
    chunk_.uvs.reserve(counts.uvs);
    chunk_.normals.reserve(counts.normals);
    if (counts.corners > 2 * counts.faces) {
        chunk_.triangles.reserve(counts.corners - 2 * counts.faces);
    }
}

void ChunkBuilder::set_color(Color color) {
    if (chunk_.colors.empty()) {
        chunk_.colors.reserve(chunk_.positions.capacity());
        chunk_.colors.resize(chunk_.positions.size(), kWhite);
    }
    chunk_.colors.back() = color;
}

void ChunkBuilder::add_normal(DVec3 direction) {
    const double size =
        std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    Vec3 normal(0.0f);
    if (size > 0) {
        // The largest component becomes 1: squares of tiny ones would vanish.
        const DVec3 scaled(direction.x / size, direction.y / size, direction.z / size);
        const double length = std::sqrt(dot(scaled, scaled));
        normal = Vec3(DVec3(scaled.x / length, scaled.y / length, scaled.z / length));
    } else {
        chunk_.has_zero_normals = true;
    }
    chunk_.normals.push_back(normal);
}

void ChunkBuilder::add_face(std::span<const Corner> corners) {
    if (pending_.are_any()) keep_changes();
    bool has_uvs = true;
    bool has_normals = true;
    for (const Corner& corner : corners) {
        has_uvs = has_uvs && corner.uv != kNone;
        has_normals = has_normals && corner.normal != kNone;
    }
    const std::size_t triangle_count = chunk_.triangles.size();
    if (has_uvs && chunk_.uv_indices.empty()) {
        chunk_.uv_indices.reserve(chunk_.triangles.capacity());
        chunk_.uv_indices.resize(triangle_count, kNoTriple);
    }
    if (has_normals && chunk_.normal_indices.empty()) {
        chunk_.normal_indices.reserve(chunk_.triangles.capacity());
        chunk_.normal_indices.resize(triangle_count, kNoTriple);
    }

    const std::size_t corner_count = corners.size();
    if (corner_count == 3) {
        add_triangle(corners[0], corners[1], corners[2], has_uvs, has_normals);
        return;
    }
    const bool are_here = std::all_of(corners.begin(), corners.end(),
                                      [&](const Corner& corner) { return is_here(corner); });
    if (!are_here) {
        chunk_.late_polygons.push_back({static_cast<std::uint32_t>(triangle_count),
                                        static_cast<std::uint32_t>(corner_count - 2)});
        for (std::size_t i = 2; i < corner_count; ++i) {
            add_triangle(corners[0], corners[i - 1], corners[i], has_uvs, has_normals);
        }
        return;
    }
    polygon_.clear();
    for (const Corner& corner : corners) {
        polygon_.push_back(chunk_.positions[corner.position - chunk_.before.positions]);
    }
    for (const auto [a, b, c] : triangulator_.triangulate(polygon_)) {
        add_triangle(corners[a], corners[b], corners[c], has_uvs, has_normals);
    }
}

void ChunkBuilder::add_triangle(const Corner& a, const Corner& b, const Corner& c, bool has_uvs,
                                bool has_normals) {
    chunk_.triangles.push_back({a.position, b.position, c.position});
    if (!chunk_.uv_indices.empty() || has_uvs) {
        chunk_.uv_indices.push_back(has_uvs ? IndexTriple{a.uv, b.uv, c.uv} : kNoTriple);
    }
    if (!chunk_.normal_indices.empty() || has_normals) {
        chunk_.normal_indices.push_back(has_normals ? IndexTriple{a.normal, b.normal, c.normal}
                                                    : kNoTriple);
    }
}

void ChunkBuilder::keep_changes() {
    const auto first_triangle = static_cast<std::uint32_t>(chunk_.triangles.size());
    pending_.take([&](StateKind kind, const char* statement) {
        chunk_.changes.push_back({statement, first_triangle, kind});
    });
}

Chunk ChunkBuilder::finish() {
    keep_changes();
    return std::move(chunk_);
}

}  // namespace lray::scene::obj
