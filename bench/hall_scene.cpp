// The hall: what spatial splits are for.
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/portable_math.h"
#include "base/random.h"
#include "bench/trace_scenes.h"

namespace lray::bench {

namespace {

// In metres: x along the hall, y up.
constexpr DVec3 kHall{40.0, 12.0, 20.0};
constexpr double kFirstRow = 5.0;  // z of the columns
constexpr double kSecondRow = 15.0;
constexpr double kColumnHeight = 6.0;
constexpr double kColumnRadius = 0.45;
constexpr double kArchRadius = 0.3;
constexpr int kColumnsPerRow = 8;
constexpr double kColumnStep = kHall.x / kColumnsPerRow;
constexpr int kCableCount = 290;
constexpr int kCableSegments = 4;
constexpr int kCableSides = 6;

std::uint32_t add_vertex(scene::World& world, DVec3 point) {
    world.vertices.emplace_back(point);
    return static_cast<std::uint32_t>(world.vertices.size() - 1);
}

void add_quad(scene::World& world, std::uint32_t a, std::uint32_t b, std::uint32_t c,
              std::uint32_t d) {
    world.triangles.push_back({{a, b, c}});
    world.triangles.push_back({{a, c, d}});
}

/// Adds a round tube along a path, its rings in the planes of a direction and of `across`.
void add_tube(scene::World& world, std::span<const DVec3> path, double radius, int side_count) {
    const auto at = [&](std::uint32_t first, std::size_t ring, int side) {
        return first + static_cast<std::uint32_t>(ring) * static_cast<std::uint32_t>(side_count) +
               static_cast<std::uint32_t>(side % side_count);
    };
    const auto first = static_cast<std::uint32_t>(world.vertices.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
        const DVec3 before = path[i > 0 ? i - 1 : 0];
        const DVec3 after = path[i + 1 < path.size() ? i + 1 : i];
        const DVec3 along = glm::normalize(after - before);
        // No path of this hall runs along all of these axes.
        const DVec3 up = std::fabs(along.z) < 0.9 ? DVec3{0.0, 0.0, 1.0} : DVec3{1.0, 0.0, 0.0};
        const DVec3 side = glm::normalize(cross(along, up));
        const DVec3 other = cross(along, side);
        for (int k = 0; k < side_count; ++k) {
            const DVec2 around = unit_circle_point(static_cast<double>(k) / side_count);
            add_vertex(world, path[i] + radius * (around.x * side + around.y * other));
        }
    }
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        for (int k = 0; k < side_count; ++k) {
            add_quad(world, at(first, i, k), at(first, i, k + 1), at(first, i + 1, k + 1),
                     at(first, i + 1, k));
        }
    }
}

void add_walls(scene::World& world) {
    std::array<std::uint32_t, 8> corners{};
    for (std::uint32_t i = 0; i < 8; ++i) {
        corners[i] = add_vertex(world, kHall * DVec3{i & 1u, i >> 1u & 1u, i >> 2u & 1u});
    }
    const auto add = [&](int a, int b, int c, int d) {
        const auto corner = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
        add_quad(world, corner(a), corner(b), corner(c), corner(d));
    };
    add(0, 1, 5, 4);
    add(2, 6, 7, 3);
    add(0, 4, 6, 2);
    add(1, 3, 7, 5);
    add(0, 2, 3, 1);
    add(4, 5, 7, 6);
}

void add_column(scene::World& world, double x, double z) {
    constexpr int kRings = 167;
    std::vector<DVec3> path;
    for (int i = 0; i <= kRings; ++i) path.push_back({x, kColumnHeight * i / kRings, z});
    add_tube(world, path, kColumnRadius, 64);
}

/// Adds half a ring from the top of one column to that of another.
void add_arch(scene::World& world, DVec3 begin, DVec3 end) {
    constexpr int kSegments = 88;
    const DVec3 middle = 0.5 * (begin + end);
    const DVec3 half = 0.5 * (begin - end);
    std::vector<DVec3> path;
    for (int i = 0; i <= kSegments; ++i) {
        const DVec2 turned = unit_circle_point(0.5 * i / kSegments);
        path.push_back(middle + turned.x * half + DVec3{0.0, turned.y * glm::length(half), 0.0});
    }
    add_tube(world, path, kArchRadius, 48);
}

void add_columns_and_arches(scene::World& world) {
    for (int i = 0; i < kColumnsPerRow; ++i) {
        const double x = (i + 0.5) * kColumnStep;
        for (const double z : {kFirstRow, kSecondRow}) {
            add_column(world, x, z);
            const DVec3 top{x, kColumnHeight, z};
            if (i > 0) add_arch(world, top - DVec3{kColumnStep, 0.0, 0.0}, top);
        }
        add_arch(world, {x, kColumnHeight, kFirstRow}, {x, kColumnHeight, kSecondRow});
    }
}

/// Adds cables that hang from one wall to the one opposite, along the hall or across it.
void add_cables(scene::World& world) {
    constexpr double kSag = 0.02;  // of the length
    for (int i = 0; i < kCableCount; ++i) {
        const auto number = [&](std::uint64_t k) {
            return KeyedRandom{}.with("cable").with(i).with_bits(k).number();
        };
        DVec3 begin = kHall * DVec3{number(0), number(1), number(2)};
        DVec3 end = kHall * DVec3{number(3), number(4), number(5)};
        const int axis = number(6) < 0.6 ? 0 : 2;
        begin[axis] = 0.0;
        end[axis] = kHall[axis];
        const double sag = kSag * glm::length(end - begin);
        std::vector<DVec3> path;
        for (int k = 0; k <= kCableSegments; ++k) {
            const double s = static_cast<double>(k) / kCableSegments;
            path.push_back(begin + s * (end - begin) - DVec3{0.0, 4.0 * sag * s * (1.0 - s), 0.0});
        }
        add_tube(world, path, 0.004 + 0.012 * number(7), kCableSides);
    }
}

}  // namespace

TraceScene make_hall() {
    TraceScene result;
    add_walls(result.world);
    add_columns_and_arches(result.world);
    add_cables(result.world);
    result.eye = {2.5f, 2.2f, 7.0f};
    result.target = {36.0f, 5.5f, 12.0f};
    result.view_width = 1.3;
    result.light = {20.0f, 11.5f, 9.0f};
    return result;
}

}  // namespace lray::bench
