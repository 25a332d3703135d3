// Points in the plane that become fewer, and the question whether one lies in a triangle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"

namespace lray::scene {

/// Returns twice the signed area: positive if a, b, c turn left.
inline double orientation(DVec2 a, DVec2 b, DVec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The corners of a polygon that can keep others from being ears: a balanced k-d tree with the
/// bounds of what is in each node.
class BlockerTree {
 public:
    static constexpr std::uint32_t kNone = 0xffffffffu;

    struct Blocker {
        DVec2 point{};
        std::uint32_t corner = 0;
    };

    /// Forgets what it held and takes these.
    /// Shape: corners are less than `corner_count`, each once.
    void build(std::span<const Blocker> blockers, std::size_t corner_count);

    /// Returns the corner of a blocker in the triangle or on its border; kNone if there is none.
    /// Blockers in the place of one of the triangle's corners do not count: they are the other
    /// side of a seam to a hole.
    /// Shape: a, b, c turn left.
    std::uint32_t find_in_triangle(DVec2 a, DVec2 b, DVec2 c);

    /// Shape: the corner is one that was given and is still held.
    void remove(std::uint32_t corner);

    /// Nodes and blockers that have been looked at since `build`.
    std::uint64_t work() const { return work_; }

 private:
    struct Node {
        DVec2 low{};
        DVec2 high{};
        std::uint32_t begin = 0;
        std::uint32_t left = 0;      // blockers that are left below
        std::uint32_t parent = 0;    // of the root: itself
        std::uint32_t children = 0;  // the first of two neighbours; 0: a leaf
    };

    void build_node(std::uint32_t index, std::uint32_t parent, std::uint32_t begin,
                    std::uint32_t end);

    std::vector<Node> nodes_{};
    std::vector<Blocker> blockers_{};      // those of a leaf: first the ones that are left
    std::vector<std::uint32_t> leaves_{};  // by corner
    std::uint64_t work_ = 0;
};

}  // namespace lray::scene
