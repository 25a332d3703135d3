#include "scene/triangulate_polygon.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"

namespace lray::scene {

namespace {

DVec3 cross_of_edges(Vec3 origin, Vec3 a, Vec3 b) {
    return cross(DVec3(a) - DVec3(origin), DVec3(b) - DVec3(origin));
}

}  // namespace

std::span<const IndexTriple> PolygonTriangulator::triangulate(std::span<const Vec3> corners) {
    LRAY_DCHECK(corners.size() >= 3);
    const auto corner_count = static_cast<std::uint32_t>(corners.size());
    triangles_.clear();
    if (corner_count == 4) {
        cut_quad(corners);
    } else if (corner_count == 3 || !project(corners) || is_convex()) {
        emit_fan(corner_count);
    } else {
        clip_ears();
    }
    LRAY_DCHECK(triangles_.size() == corner_count - 2);
    return triangles_;
}

/// Of the two diagonals at least one is inside; the first is kept unless only the other is.
void PolygonTriangulator::cut_quad(std::span<const Vec3> corners) {
    const auto is_inside = [&](std::size_t from) {
        const Vec3 a = corners[from];
        const Vec3 c = corners[from + 2];
        const DVec3 first = cross_of_edges(a, corners[from + 1], c);
        const DVec3 second = cross_of_edges(a, c, corners[(from + 3) % 4]);
        return dot(first, second) > 0;
    };
    if (!is_inside(0) && is_inside(1)) {
        triangles_.push_back({1, 2, 3});
        triangles_.push_back({1, 3, 0});
    } else {
        emit_fan(4);
    }
}

void PolygonTriangulator::emit_fan(std::uint32_t corner_count) {
    for (std::uint32_t i = 2; i < corner_count; ++i) triangles_.push_back({0, i - 1, i});
}

/// Lays the polygon into the coordinate plane it is most parallel to, turning left; false if it
/// has no area.
bool PolygonTriangulator::project(std::span<const Vec3> corners) {
    // Newell's method, as in Tampieri 1992, "Newell's method for computing the plane equation of a
    // polygon", Graphics Gems III; about the first corner, against cancellation.
    const DVec3 origin(corners[0]);
    DVec3 normal(0.0);
    DVec3 last = DVec3(corners.back()) - origin;
    for (const Vec3 corner : corners) {
        const DVec3 here = DVec3(corner) - origin;
        normal += cross(last, here);
        last = here;
    }
    const DVec3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
    int axis = 0;
    if (size.y > size[axis]) axis = 1;
    if (size.z > size[axis]) axis = 2;
    if (!(size[axis] > 0)) return false;

    int x_axis = (axis + 1) % 3;
    int y_axis = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(x_axis, y_axis);
    corners_.assign(corners.size(), Corner{});
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners_[i].point = DVec2(corners[i][x_axis], corners[i][y_axis]);
    }
    return true;
}

/// True if every corner turns left, strictly, and they go round once.
bool PolygonTriangulator::is_convex() const {
    const std::size_t count = corners_.size();
    DVec2 a = corners_[count - 2].point;
    DVec2 b = corners_[count - 1].point;
    const auto points_up = [](DVec2 edge) { return edge.y > 0 || (edge.y == 0 && edge.x > 0); };
    bool was_up = points_up(b - a);
    int change_count = 0;
    for (const Corner& corner : corners_) {
        const DVec2 c = corner.point;
        if (!(orientation(a, b, c) > 0)) return false;
        const bool is_up = points_up(c - b);
        if (is_up != was_up) ++change_count;
        was_up = is_up;
        a = b;
        b = c;
    }
    return change_count == 2;
}

bool PolygonTriangulator::is_convex_corner(std::uint32_t corner) const {
    const Corner& here = corners_[corner];
    return orientation(corners_[here.previous].point, here.point, corners_[here.next].point) > 0;
}

void PolygonTriangulator::clip_ears() {
    make_ring();

    constexpr std::uint64_t kMaxWorkPerCorner = 1024;
    const std::uint64_t max_work = kMaxWorkPerCorner * corners_.size();
    std::size_t left_count = corners_.size();
    std::uint32_t start = 0;
    while (left_count > 3 && queue_count_ > 0 && blocker_tree_.work() < max_work) {
        const std::uint32_t tip = queue_[queue_begin_];
        queue_begin_ = queue_begin_ + 1 == queue_.size() ? 0 : queue_begin_ + 1;
        --queue_count_;
        corners_[tip].is_queued = false;
        if (corners_[tip].is_cut) continue;
        stop_watching(tip);
        if (!is_convex_corner(tip)) continue;  // queued again when a neighbour is cut off
        const std::uint32_t before = corners_[tip].previous;
        const std::uint32_t after = corners_[tip].next;
        const std::uint32_t blocker = blocker_tree_.find_in_triangle(
            corners_[before].point, corners_[tip].point, corners_[after].point);
        if (blocker != BlockerTree::kNone) {
            watch(tip, blocker);
            continue;
        }
        triangles_.push_back({before, tip, after});
        corners_[tip].is_cut = true;
        corners_[before].next = after;
        corners_[after].previous = before;
        --left_count;
        start = after;
        neighbour_changed(before);
        neighbour_changed(after);
    }

    // The last triangle; and what has no ears: corners on a line, crossing edges.
    std::uint32_t at = corners_[start].next;
    for (; left_count > 2; --left_count) {
        const std::uint32_t next = corners_[at].next;
        triangles_.push_back({start, at, next});
        at = next;
    }
}

void PolygonTriangulator::make_ring() {
    const auto count = static_cast<std::uint32_t>(corners_.size());
    queue_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        corners_[i].previous = i == 0 ? count - 1 : i - 1;
        corners_[i].next = i + 1 == count ? 0 : i + 1;
        corners_[i].is_queued = true;
        queue_[i] = i;
    }
    queue_begin_ = 0;
    queue_count_ = count;
    blockers_.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
        corners_[i].is_blocker = !is_convex_corner(i);
        if (corners_[i].is_blocker) blockers_.push_back({corners_[i].point, i});
    }
    blocker_tree_.build(blockers_, count);
}

void PolygonTriangulator::enqueue(std::uint32_t corner) {
    if (corners_[corner].is_queued || corners_[corner].is_cut) return;
    corners_[corner].is_queued = true;
    std::size_t end = queue_begin_ + queue_count_;
    if (end >= queue_.size()) end -= queue_.size();
    queue_[end] = corner;
    ++queue_count_;
}

void PolygonTriangulator::watch(std::uint32_t corner, std::uint32_t blocker) {
    Corner& here = corners_[corner];
    here.watched = blocker;
    here.previous_watcher = kNone;
    here.next_watcher = corners_[blocker].first_watcher;
    if (here.next_watcher != kNone) corners_[here.next_watcher].previous_watcher = corner;
    corners_[blocker].first_watcher = corner;
}

void PolygonTriangulator::stop_watching(std::uint32_t corner) {
    Corner& here = corners_[corner];
    if (here.watched == kNone) return;
    if (here.previous_watcher != kNone) {
        corners_[here.previous_watcher].next_watcher = here.next_watcher;
    } else {
        corners_[here.watched].first_watcher = here.next_watcher;
    }
    if (here.next_watcher != kNone) {
        corners_[here.next_watcher].previous_watcher = here.previous_watcher;
    }
    here.watched = kNone;
}

/// A reflex corner becomes convex as its neighbours are cut off, never the other way round.
void PolygonTriangulator::neighbour_changed(std::uint32_t corner) {
    enqueue(corner);
    if (!corners_[corner].is_blocker || !is_convex_corner(corner)) return;
    corners_[corner].is_blocker = false;
    blocker_tree_.remove(corner);
    while (corners_[corner].first_watcher != kNone) {
        const std::uint32_t watcher = corners_[corner].first_watcher;
        stop_watching(watcher);
        enqueue(watcher);
    }
}

}  // namespace lray::scene
