// Bounds hold every point of a primitive, and little else.
#include "scene/world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace lray::scene {
namespace {

/// Repeatable random numbers.
class Random {
 public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double uniform(double lo, double hi) {
        return lo + (hi - lo) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    DVec3 in_cube(double half_size) {
        const double x = uniform(-half_size, half_size);
        const double y = uniform(-half_size, half_size);
        return {x, y, uniform(-half_size, half_size)};
    }
    DVec3 direction() {
        while (true) {
            const DVec3 v = in_cube(1.0);
            const double length = glm::length(v);
            if (length > 0.1 && length <= 1.0) return v / length;
        }
    }

 private:
    std::mt19937_64 engine_;
};

AffineFrame random_frame(Random& random, double scale, double offset) {
    DMat3 linear{1.0};
    do {
        linear = {random.in_cube(scale), random.in_cube(scale), random.in_cube(scale)};
    } while (std::fabs(glm::determinant(linear)) < 0.05 * scale * scale * scale);
    return {Vec3{random.in_cube(offset)}, Mat3{glm::inverse(linear)}};
}

/// The frame as it is defined: by its float inverse, solved in long double.
DVec3 place(const AffineFrame& frame, DVec3 q) {
    using LMat3 = glm::mat<3, 3, long double>;
    using LVec3 = glm::vec<3, long double>;
    return DVec3{glm::inverse(LMat3{frame.object_from_world}) * LVec3{q} + LVec3{frame.origin}};
}

/// Expects the samples in the bounds, and the bounds to reach no further than the samples by more
/// than a share of the size. `samples` must touch all sides.
void expect_tight(const Bounds& bounds, const Bounds& exact, double tolerance) {
    for (int axis = 0; axis < 3; ++axis) {
        const double size =
            static_cast<double>(exact.max[axis]) - static_cast<double>(exact.min[axis]);
        const double ulps = 2.4e-7 * std::max(std::fabs(static_cast<double>(exact.max[axis])),
                                              std::fabs(static_cast<double>(exact.min[axis])));
        EXPECT_LE(bounds.min[axis], exact.min[axis]);
        EXPECT_GE(bounds.max[axis], exact.max[axis]);
        EXPECT_GE(bounds.min[axis], static_cast<double>(exact.min[axis]) - tolerance * size - ulps);
        EXPECT_LE(bounds.max[axis], static_cast<double>(exact.max[axis]) + tolerance * size + ulps);
    }
}

/// Rounded inward: bounds must contain the samples themselves, not the floats outside them.
void add_inward(Bounds& bounds, DVec3 p) {
    for (int axis = 0; axis < 3; ++axis) {
        bounds.min[axis] = std::min(bounds.min[axis], round_up(p[axis]));
        bounds.max[axis] = std::max(bounds.max[axis], round_down(p[axis]));
    }
}

struct Case {
    double scale;
    double offset;
};
constexpr Case kCases[] = {{1e-6, 0.0}, {1.0, 0.0}, {1.0, 1e4}, {1e6, 1e4}};

/// The points of the canonical shapes at which each world axis is extreme, besides random ones.
constexpr int kSteps = 2048;

TEST(PrimitiveBounds, OfAnEllipsoid) {
    Random random(101);
    for (const auto& [scale, offset] : kCases) {
        for (int i = 0; i < 20; ++i) {
            World world;
            world.ellipsoids.push_back({random_frame(random, scale, offset)});
            const AffineFrame& frame = world.ellipsoids[0].frame;
            Bounds exact;
            for (int j = 0; j < 5000; ++j) add_inward(exact, place(frame, random.direction()));
            // Extreme along axis e where q is parallel to W^T e.
            const DMat3 linear = glm::inverse(DMat3{frame.object_from_world});
            for (int axis = 0; axis < 3; ++axis) {
                const DVec3 row =
                    glm::normalize(DVec3{linear[0][axis], linear[1][axis], linear[2][axis]});
                add_inward(exact, place(frame, row));
                add_inward(exact, place(frame, -row));
            }
            expect_tight(primitive_bounds(world, {PrimitiveKind::ellipsoid, 0}), exact, 1e-5);
        }
    }
}

TEST(PrimitiveBounds, OfCylindersAndCones) {
    Random random(102);
    for (const auto& [scale, offset] : kCases) {
        for (const float top : {0.0f, 0.5f, 1.0f}) {
            World world;
            world.cylinders.push_back({random_frame(random, scale, offset), top, true});
            Bounds exact;
            for (int j = 0; j < kSteps; ++j) {
                const double a = 2.0 * std::numbers::pi * j / kSteps;
                const double y = random.uniform(0.0, 1.0);
                for (const double height : {0.0, 1.0, y}) {
                    const double r = 1.0 + (static_cast<double>(top) - 1.0) * height;
                    add_inward(exact, place(world.cylinders[0].frame,
                                            {r * std::cos(a), height, r * std::sin(a)}));
                }
            }
            expect_tight(primitive_bounds(world, {PrimitiveKind::cylinder, 0}), exact, 1e-5);
        }
    }
}

TEST(PrimitiveBounds, OfDisks) {
    Random random(103);
    for (const auto& [scale, offset] : kCases) {
        World world;
        world.disks.push_back({random_frame(random, scale, offset), 0.5f});
        Bounds exact;
        for (int j = 0; j < kSteps; ++j) {
            const double a = 2.0 * std::numbers::pi * j / kSteps;
            add_inward(exact, place(world.disks[0].frame, {std::cos(a), 0.0, std::sin(a)}));
        }
        expect_tight(primitive_bounds(world, {PrimitiveKind::disk, 0}), exact, 1e-5);
    }
}

TEST(PrimitiveBounds, OfBoxes) {
    Random random(104);
    for (const auto& [scale, offset] : kCases) {
        World world;
        world.boxes.push_back({random_frame(random, scale, offset)});
        Bounds exact;
        for (int corner = 0; corner < 8; ++corner) {
            add_inward(exact, place(world.boxes[0].frame, {corner & 1 ? 1 : -1, corner & 2 ? 1 : -1,
                                                           corner & 4 ? 1 : -1}));
        }
        expect_tight(primitive_bounds(world, {PrimitiveKind::box, 0}), exact, 1e-5);
    }
}

TEST(PrimitiveBounds, OfTori) {
    Random random(106);
    for (const auto& [scale, offset] : kCases) {
        for (const float tube : {0.01f, 0.25f, 0.5f, 0.75f}) {
            World world;
            world.tori.push_back({random_frame(random, scale, offset), tube});
            const Torus& torus = world.tori[0];
            const DMat3 linear = glm::inverse(DMat3{torus.frame.object_from_world});
            Bounds exact;
            const auto add = [&](double u, DVec3 out) {
                const DVec3 core{torus.radius() * std::cos(u), 0.0, torus.radius() * std::sin(u)};
                add_inward(exact, place(torus.frame, core + static_cast<double>(tube) * out));
            };
            for (int j = 0; j < 5000; ++j) {
                const double u = random.uniform(-4.0, 4.0);
                const double v = random.uniform(-4.0, 4.0);
                const double across = std::cos(v);
                // Of a tube that overlaps itself, the part that is outside.
                if (torus.radius() + static_cast<double>(tube) * across < 0.0) continue;
                add(u, {across * std::cos(u), std::sin(v), across * std::sin(u)});
            }
            // Extreme along axis e where the normal is parallel to W^T e.
            for (int axis = 0; axis < 3; ++axis) {
                const DVec3 row =
                    glm::normalize(DVec3{linear[0][axis], linear[1][axis], linear[2][axis]});
                add(std::atan2(row.z, row.x), row);
                add(std::atan2(-row.z, -row.x), -row);
            }
            expect_tight(primitive_bounds(world, {PrimitiveKind::torus, 0}), exact, 1e-5);
        }
    }
}

TEST(PrimitiveBounds, OfSpheres) {
    Random random(105);
    for (const auto& [scale, offset] : kCases) {
        World world;
        world.spheres.push_back({Vec3{random.in_cube(offset)}, static_cast<float>(scale)});
        const Sphere& sphere = world.spheres[0];
        Bounds exact;
        for (int axis = 0; axis < 3; ++axis) {
            for (const double side : {-1.0, 1.0}) {
                DVec3 p{sphere.center};
                p[axis] += side * static_cast<double>(sphere.radius);
                add_inward(exact, p);
            }
        }
        expect_tight(primitive_bounds(world, {PrimitiveKind::sphere, 0}), exact, 1e-5);
    }
}

TEST(PrimitiveBounds, OfTrianglesAndRectanglesAreExact) {
    World world;
    world.vertices = {{1, 2, 3}, {-4, 5, 6}, {7, -8, 0.5f}};
    world.triangles.push_back({{0, 1, 2}});
    const Bounds triangle = primitive_bounds(world, {PrimitiveKind::triangle, 0});
    EXPECT_EQ(triangle.min, (Vec3{-4, -8, 0.5f}));
    EXPECT_EQ(triangle.max, (Vec3{7, 5, 6}));
    world.rectangles.push_back({{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 2, 0}, Vec3{0, 2, 3}}});
    const Bounds rectangle = primitive_bounds(world, {PrimitiveKind::rectangle, 0});
    EXPECT_EQ(rectangle.min, (Vec3{0, 0, 0}));
    EXPECT_EQ(rectangle.max, (Vec3{1, 2, 3}));
}

TEST(FiniteBounds, LeaveOutPlanesAndMayBeEmpty) {
    World world;
    EXPECT_TRUE(finite_bounds(world).is_empty());
    world.planes.push_back({});
    EXPECT_TRUE(finite_bounds(world).is_empty());
    world.spheres.push_back({{0, 0, 0}, 1});
    world.boxes.push_back({{{5, 5, 5}, Mat3{1.0f}}});
    world.tori.push_back({{{-7, 0, 0}, Mat3{1.0f}}});
    const Bounds bounds = finite_bounds(world);
    EXPECT_TRUE(bounds.contains(primitive_bounds(world, {PrimitiveKind::sphere, 0})));
    EXPECT_TRUE(bounds.contains(primitive_bounds(world, {PrimitiveKind::box, 0})));
    EXPECT_TRUE(bounds.contains(primitive_bounds(world, {PrimitiveKind::torus, 0})));
    EXPECT_NEAR(bounds.min.x, -8.0f, 1e-5f);
    EXPECT_NEAR(bounds.max.x, 6.0f, 1e-5f);
    EXPECT_EQ(world.primitive_count(), 4u);
}

}  // namespace
}  // namespace lray::scene
