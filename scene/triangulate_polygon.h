// Cuts polygons in space into triangles, whatever their shape.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"
#include "scene/blocker_tree.h"
#include "scene/mesh.h"

namespace lray::scene {

/// Triangulates one polygon after the other; it is an object so that its memory is used again.
class PolygonTriangulator {
 public:
    /// Returns triangles that together are the polygon, as numbers of its corners, with its
    /// orientation. Valid until the next call. Convex polygons, those without a plane and those
    /// that are too tangled become a fan from the first corner.
    /// Shape: 3 corners or more, finite; corner_count - 2 triangles.
    /// Source: ear clipping, Meisters 1975, "Polygons have ears", in the plane that Newell's
    /// method finds. An ear is tested against the reflex corners near it only, and a corner that
    /// is no ear is tested again only when the reason is gone: about n log n for usual shapes. Work
    /// beyond a bound linear in the corners ends in a fan.
    std::span<const IndexTriple> triangulate(std::span<const Vec3> corners);

 private:
    static constexpr std::uint32_t kNone = Mesh::kNone;

    void cut_quad(std::span<const Vec3> corners);
    bool project(std::span<const Vec3> corners);
    bool is_convex() const;
    void emit_fan(std::uint32_t corner_count);

    void clip_ears();
    void make_ring();
    void enqueue(std::uint32_t corner);
    void watch(std::uint32_t corner, std::uint32_t blocker);
    void stop_watching(std::uint32_t corner);
    void neighbour_changed(std::uint32_t corner);
    bool is_convex_corner(std::uint32_t corner) const;

    /// A corner of the polygon that is left while ears are cut off.
    struct Corner {
        DVec2 point{};
        std::uint32_t previous = 0, next = 0;
        // Corners that are no ears because this one lies in their triangle: a list.
        std::uint32_t first_watcher = kNone;
        // Neighbours in the list this one is in, and the blocker whose list it is.
        std::uint32_t previous_watcher = kNone, next_watcher = kNone, watched = kNone;
        bool is_queued = false;
        bool is_cut = false;
        bool is_blocker = false;  // reflex or flat, so that it can lie in an ear's triangle
    };

    std::vector<IndexTriple> triangles_{};
    std::vector<Corner> corners_{};

    // A ring buffer: every corner is queued at most once.
    std::vector<std::uint32_t> queue_{};
    std::size_t queue_begin_ = 0, queue_count_ = 0;

    std::vector<BlockerTree::Blocker> blockers_{};
    BlockerTree blocker_tree_{};
};

}  // namespace lray::scene
