// Makes three scenes of Haines' Standard Procedural Databases at any size, as NFF.
// Source: Haines 1987, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11); numbers as
// version 3 of the databases writes them.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/output_file.h"
#include "base/vec.h"
#include "bench/text_writer.h"

namespace {

using namespace lray;
using bench::TextWriter;

constexpr double kPi = std::numbers::pi;
constexpr int kMaxSize = 40;

constexpr std::string_view kUsage =
    "usage: make_spd balls|rings|tetra SIZE OUT.nff\n"
    "  balls  (9^(SIZE+1) - 1) / 8 spheres on a square: 4 is customary, 6 is large\n"
    "  rings  5 SIZE (SIZE+1) (2 SIZE+1) spheres and as many cylinders: 7, 35\n"
    "  tetra  4^SIZE triangles: 6, 10\n";

void print_point(TextWriter& out, std::string_view head, DVec3 p, std::string_view end = "\n") {
    out.print("{}{:g} {:g} {:g}{}", head, p.x, p.y, p.z, end);
}

void print_view(TextWriter& out, DVec3 from, DVec3 at, DVec3 up, double hither) {
    out.print("b 0.078 0.361 0.753\nv\n");
    print_point(out, "from ", from);
    print_point(out, "at ", at);
    print_point(out, "up ", up);
    out.print("angle 45\nhither {:g}\nresolution 512 512\n", hither);
}

/// Returns v turned about a unit axis, counter-clockwise (Rodrigues).
DVec3 turned(DVec3 v, DVec3 axis, double angle) {
    return v * std::cos(angle) + cross(axis, v) * std::sin(angle) +
           axis * (dot(axis, v) * (1.0 - std::cos(angle)));
}

constexpr DVec3 kXAxis{1.0, 0.0, 0.0};
constexpr DVec3 kZAxis{0.0, 0.0, 1.0};

/// Where nine smaller balls sit on one that faces +Z: three sets of three about it.
std::array<DVec3, 9> ball_directions() {
    const double d = std::sqrt(0.5);
    const DVec3 tilt_axis{d, -d, 0.0};
    const double tilt = std::asin(2.0 / std::sqrt(6.0));
    const std::array<DVec3, 3> first{DVec3{d, d, 0.0}, DVec3{d, 0.0, -d}, DVec3{0.0, d, -d}};
    std::array<DVec3, 9> directions{};
    for (std::size_t set = 0; set < 3; ++set) {
        for (std::size_t i = 0; i < 3; ++i) {
            directions[3 * set + i] = turned(turned(first[i], tilt_axis, tilt), kZAxis,
                                             static_cast<double>(set) * 2.0 * kPi / 3.0);
        }
    }
    return directions;
}

/// Less is noise: the ball faces along Z, and is turned about Y.
constexpr double kLeastSine = 1e-6;

void print_ball(TextWriter& out, const std::array<DVec3, 9>& directions, int depth, DVec3 center,
                double radius, DVec3 facing) {
    print_point(out, "s ", center, " ");
    out.print("{:g}\n", radius);
    if (depth == 0) return;
    const DVec3 axis = cross(kZAxis, facing);
    const double sine = glm::length(axis);
    const double angle = std::acos(glm::clamp(facing.z, -1.0, 1.0));
    const DVec3 about = sine > kLeastSine ? axis / sine : DVec3{0.0, 1.0, 0.0};
    for (const DVec3& direction : directions) {
        const DVec3 child = turned(direction, about, angle);
        print_ball(out, directions, depth - 1, center + child * (radius * (4.0 / 3.0)),
                   radius / 3.0, child);
    }
}

void print_balls(int size, TextWriter& out) {
    print_view(out, {2.1, 1.3, 1.7}, {0.0, 0.0, 0.0}, kZAxis, 0.01);
    out.print("l 4 3 2\nl 1 -4 4\nl -3 1 5\n");
    out.print("f 1 0.75 0.33 0.8 0 100000 0 1\n");
    out.print("p 4\n12 12 -0.5\n-12 12 -0.5\n-12 -12 -0.5\n12 -12 -0.5\n");
    out.print("f 1 0.9 0.7 0.5 0.5 3.0827 0 1\n");
    print_ball(out, ball_directions(), size, {0.0, 0.0, 0.0}, 0.5, kZAxis);
}

/// The middles of a dodecahedron's 30 edges, as six rings of five: one about Z, and that one turned
/// by the angle between neighbouring faces to each of its five sides.
std::array<DVec3, 30> ring_points(double tube) {
    const double radius = 1.0 / (1.0 + tube);
    const double tilt = 2.0 * std::acos(std::cos(kPi / 3.0) / std::sin(kPi / 5.0));
    std::array<DVec3, 30> points{};
    for (std::size_t i = 0; i < 5; ++i) {
        const double around = static_cast<double>(i) * 2.0 * kPi / 5.0;
        points[i] = {radius * std::cos(around), radius * std::sin(around), 0.0};
        for (std::size_t ring = 1; ring < 6; ++ring) {
            const double turn = kPi * (2.0 * static_cast<double>(ring) - 1.0) / 5.0;
            points[5 * ring + i] = turned(turned(points[i], kXAxis, tilt), kZAxis, turn);
        }
    }
    return points;
}

void print_ring_object(TextWriter& out, const std::array<DVec3, 30>& points, DVec3 offset,
                       double tube) {
    constexpr std::array<std::string_view, 6> kColors{"1 0 0", "0 1 0", "0 0 1",
                                                      "0 1 1", "1 0 1", "1 1 0"};
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i % 5 == 0) out.print("f {} 0.5 0.2 3.0827 0 0\n", kColors[i / 5]);
        const std::size_t previous = i % 5 == 0 ? i + 4 : i - 1;
        const DVec3 here = points[i] + offset;
        print_point(out, "c ", here, " ");
        print_point(out, fmt::format("{:g} ", tube), points[previous] + offset, " ");
        out.print("{:g}\n", tube);
        print_point(out, "s ", here, " ");
        out.print("{:g}\n", tube);
    }
}

void print_rings(int size, TextWriter& out) {
    constexpr double kTube = 0.07412;
    const double layer = 1.0 / std::sin(kPi / 8.0);  // from one layer of the pyramid to the next
    const DVec3 from{-1.0, -layer, 0.5};
    print_view(out, from, from + DVec3{0.0, 1.0, 0.0}, kZAxis, 1.0);
    for (const DVec3& light :
         {DVec3{3.0, -layer, 3.0}, DVec3{-4.0, -layer, 1.0}, DVec3{2.0, -layer, -4.0}}) {
        print_point(out, "l ", light);
    }
    // A wall behind, a hundredth larger than what the camera sees.
    const double wall = layer * (size + 1);
    const double half = 1.01 * (wall - from.y) * std::tan(kPi / 8.0);
    out.print("f 1 1 1 1 0 100000 0 0\np 4\n");
    for (const DVec2& side : {DVec2{1, 1}, DVec2{-1, 1}, DVec2{-1, -1}, DVec2{1, -1}}) {
        print_point(out, "", {side.x * half + from.x, wall, side.y * half + from.z});
    }
    const std::array<DVec3, 30> points = ring_points(kTube);
    for (int depth = 0; depth < size; ++depth) {
        for (int z = -depth; z <= depth; z += 2) {
            for (int x = -depth; x <= depth; x += 2) {
                print_ring_object(out, points, {x, layer * (depth + 1), z}, kTube);
            }
        }
    }
}

/// The corners of a cube that are a tetrahedron's: those whose signs multiply to 1.
constexpr std::array<DVec3, 4> kTetraCorners{DVec3{-1, -1, 1}, DVec3{-1, 1, -1}, DVec3{1, -1, -1},
                                             DVec3{1, 1, 1}};

void print_tetrahedra(TextWriter& out, int depth, DVec3 center, double half) {
    if (depth > 1) {
        for (const DVec3& corner : kTetraCorners) {
            print_tetrahedra(out, depth - 1, center + corner * (half / 2.0), half / 2.0);
        }
        return;
    }
    constexpr int kFaces[4][3] = {{0, 1, 2}, {3, 2, 1}, {2, 3, 0}, {1, 0, 3}};
    for (const auto& face : kFaces) {
        out.print("p 3\n");
        for (const int corner : face) {
            print_point(out, "", center + kTetraCorners[static_cast<std::size_t>(corner)] * half);
        }
    }
}

void print_tetra(int size, TextWriter& out) {
    print_view(out, {1.022846, -3.177154, -2.174512}, {-0.004103, -0.004103, 0.216539},
               {-0.816497, -0.816497, 0.816497}, 1.0);
    out.print("l 2 -18 -5\nf 1 0.2 0.2 1 0 100000 0 0\n");
    print_tetrahedra(out, size, {0.0, 0.0, 0.0}, 1.0);
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view name = argc == 4 ? argv[1] : "";
    char* end = nullptr;
    const long size = argc == 4 ? std::strtol(argv[2], &end, 10) : 0;
    const auto print = name == "balls"   ? print_balls
                       : name == "rings" ? print_rings
                       : name == "tetra" ? print_tetra
                                         : nullptr;
    // Forty layers of rings are 1.3 million objects; of the others size is the exponent.
    const long largest = name == "rings" ? kMaxSize : 12;
    if (print == nullptr || size < 1 || size > largest || *end != '\0') {
        fmt::print(stderr, "{}", kUsage);
        return 2;
    }
    std::string error;
    std::optional<OutputFile> file = OutputFile::open(argv[3], error);
    if (!file) {
        fmt::print(stderr, "{}: {}\n", argv[3], error);
        return 4;
    }
    TextWriter out(*file);
    print(static_cast<int>(size), out);
    if (!out.finish()) {
        fmt::print(stderr, "{}: {}\n", argv[3], file->error());
        return 4;
    }
    return 0;
}
