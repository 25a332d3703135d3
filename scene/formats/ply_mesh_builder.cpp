#include "scene/formats/ply_mesh_builder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "image/srgb.h"

namespace lray::scene::ply {

namespace {

/// How many of the first values are finite.
std::size_t finite_count(std::span<const float> values) {
    constexpr std::uint32_t kExponent = 0x7f800000u;
    bool are_finite = true;
    for (const float value : values) {
        are_finite &= (std::bit_cast<std::uint32_t>(value) & kExponent) != kExponent;
    }
    if (are_finite) return values.size();
    const auto wrong = std::find_if(values.begin(), values.end(),
                                    [](float value) { return !std::isfinite(value); });
    return static_cast<std::size_t>(wrong - values.begin());
}

/// Returns the direction of a normal of any length; 0 if it has none.
Vec3 direction_of(DVec3 normal) {
    // Squares of floats are neither too large nor too small for a double.
    const double square = dot(normal, normal);
    if (!std::isfinite(square) || !(square > 0)) return Vec3(0.0f);
    const double length = std::sqrt(square);
    return Vec3(DVec3(normal.x / length, normal.y / length, normal.z / length));
}

float decode_byte(float code) {
    if (!(code > 0.0f)) return 0.0f;
    return image::srgb_decode_8(static_cast<std::uint8_t>(std::min(code, 255.0f) + 0.5f));
}

}  // namespace

void MeshBuilder::reserve_vertices(std::size_t count) {
    mesh_.positions.reserve(count);
    if (layout_.has_normals()) mesh_.normals.reserve(count);
    if (layout_.has_colors()) mesh_.colors.reserve(count);
    if (layout_.has_uvs()) mesh_.uvs.reserve(count);
}

std::size_t MeshBuilder::add_vertices(const VertexBlock& block) {
    std::size_t count = block.count;
    const auto keep_finite = [&](Slot slot) {
        count = finite_count(std::span(block[slot]).first(count));
    };
    keep_finite(Slot::x);
    keep_finite(Slot::y);
    keep_finite(Slot::z);
    if (layout_.has_uvs()) {
        keep_finite(Slot::u);
        keep_finite(Slot::v);
    }
    const std::size_t first = mesh_.positions.size();
    mesh_.positions.resize(first + count);
    Vec3* const positions = mesh_.positions.data() + first;
    for (std::size_t i = 0; i < count; ++i) {
        positions[i] = Vec3(block[Slot::x][i], block[Slot::y][i], block[Slot::z][i]);
    }
    if (layout_.has_normals()) add_normals(block, count);
    if (layout_.has_colors()) add_colors(block, count);
    if (layout_.has_uvs()) {
        mesh_.uvs.resize(first + count);
        Vec2* const uvs = mesh_.uvs.data() + first;
        for (std::size_t i = 0; i < count; ++i) {
            uvs[i] = Vec2(block[Slot::u][i], block[Slot::v][i]);
        }
    }
    return count;
}

void MeshBuilder::add_normals(const VertexBlock& block, std::size_t count) {
    const std::size_t first = mesh_.normals.size();
    mesh_.normals.resize(first + count);
    Vec3* const normals = mesh_.normals.data() + first;
    for (std::size_t i = 0; i < count; ++i) {
        normals[i] =
            direction_of(DVec3(block[Slot::nx][i], block[Slot::ny][i], block[Slot::nz][i]));
        has_zero_normals_ |= normals[i] == Vec3(0.0f);
    }
}

void MeshBuilder::add_colors(const VertexBlock& block, std::size_t count) {
    const std::size_t first = mesh_.colors.size();
    mesh_.colors.resize(first + count);
    Color* const colors = mesh_.colors.data() + first;
    const auto add = [&](auto decode) {
        for (std::size_t i = 0; i < count; ++i) {
            colors[i] = Color(decode(block[Slot::red][i]), decode(block[Slot::green][i]),
                              decode(block[Slot::blue][i]));
        }
    };
    if (layout_.color_scale == 255.0) {
        add(decode_byte);
    } else {
        add([&](float code) {
            return static_cast<float>(image::srgb_decode(code / layout_.color_scale));
        });
    }
}

std::span<IndexTriple> MeshBuilder::add_room(std::size_t count) {
    const std::size_t size = mesh_.triangles.size();
    mesh_.triangles.resize(size + count);
    return std::span(mesh_.triangles).subspan(size);
}

void MeshBuilder::add_face(std::span<const std::uint32_t> corners) {
    if (corners.size() == 3) {
        add_triangle({corners[0], corners[1], corners[2]});
        return;
    }
    polygon_.clear();
    for (const std::uint32_t corner : corners) polygon_.push_back(mesh_.positions[corner]);
    for (const auto [a, b, c] : triangulator_.triangulate(polygon_)) {
        add_triangle({corners[a], corners[b], corners[c]});
    }
}

void MeshBuilder::continue_strip(std::uint32_t corner) {
    const auto [a, b] = strip_end_;
    if (strip_size_ >= 2 && a != b && b != corner && corner != a) {
        add_triangle(strip_size_ % 2 == 0 ? IndexTriple{a, b, corner} : IndexTriple{b, a, corner});
    }
    strip_end_ = {b, corner};
    ++strip_size_;
}

std::optional<Mesh> MeshBuilder::finish() {
    if (mesh_.triangles.empty()) return {};
    if (layout_.has_uvs()) mesh_.uv_indices = mesh_.triangles;
    if (layout_.has_normals()) mesh_.normal_indices = mesh_.triangles;
    if (has_zero_normals_) {
        for (IndexTriple& triple : mesh_.normal_indices) {
            const bool has_zero = std::any_of(triple.begin(), triple.end(), [&](auto index) {
                return mesh_.normals[index] == Vec3(0.0f);
            });
            if (has_zero) triple = {Mesh::kNone, Mesh::kNone, Mesh::kNone};
        }
    }
    return std::move(mesh_);
}

}  // namespace lray::scene::ply
