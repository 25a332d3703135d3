// What of a PLY file makes the mesh: which of its elements and properties mean what.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/formats/ply_header.h"
#include "scene/formats/ply_mistakes.h"

namespace lray::scene::ply {

/// The numbers of a vertex that are used.
enum class Slot : std::uint8_t { x, y, z, nx, ny, nz, red, green, blue, u, v };
inline constexpr std::size_t kSlotCount = 11;

/// An element whose rows have each a list of vertices.
struct IndexLists {
    std::size_t element = 0;
    std::size_t property = 0;
    bool are_strips = false;  // else each is a polygon
};

struct Layout {
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    std::size_t vertex_element = 0;
    std::array<std::size_t, kSlotCount> properties{};  // of the vertex by Slot, or kNone
    double color_scale = 1.0;                          // what stands for full brightness
    std::vector<IndexLists> index_lists{};             // not empty

    bool has(Slot slot) const { return properties[static_cast<std::size_t>(slot)] != kNone; }
    bool has_normals() const { return has(Slot::nx); }
    bool has_colors() const { return has(Slot::red); }
    bool has_uvs() const { return has(Slot::u); }
};

/// Returns what the elements mean by their names. Normals, colours and texture coordinates count
/// only where all their numbers are there.
/// Errors: empty when a mistake was told: no positions, E0704 no faces.
std::optional<Layout> find_layout(const Header& header, Mistakes& mistakes);

}  // namespace lray::scene::ply
