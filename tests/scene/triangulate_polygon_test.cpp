// PolygonTriangulator: the triangles are the polygon, in any plane, in bounded time.
#include "scene/triangulate_polygon.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace lray::scene {
namespace {

constexpr double kPi = 3.14159265358979323846;

using Polygon = std::vector<Vec3>;

Polygon in_xy(const std::vector<DVec2>& points) {
    Polygon polygon;
    for (const DVec2 p : points) {
        polygon.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y), 0.0f);
    }
    return polygon;
}

double area_xy(const Vec3 a, const Vec3 b, const Vec3 c) {
    return ((double{b.x} - a.x) * (double{c.y} - a.y) - (double{b.y} - a.y) * (double{c.x} - a.x)) /
           2;
}

double area_xy(const Polygon& polygon) {
    double area = 0.0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        area += area_xy(polygon[0], polygon[i - 1], polygon[i]);
    }
    return area;
}

std::vector<IndexTriple> triangulate(const Polygon& polygon) {
    PolygonTriangulator triangulator;
    const std::span<const IndexTriple> triangles = triangulator.triangulate(polygon);
    return {triangles.begin(), triangles.end()};
}

/// Triangles that all turn left and sum up to a simple polygon's area do not overlap.
void expect_exact_cover(const Polygon& polygon) {
    const std::vector<IndexTriple> triangles = triangulate(polygon);
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    double sum = 0.0;
    for (const auto [a, b, c] : triangles) {
        const double area = area_xy(polygon[a], polygon[b], polygon[c]);
        EXPECT_GT(area, 0.0) << a << ' ' << b << ' ' << c;
        sum += area;
    }
    const double expected = area_xy(polygon);
    EXPECT_NEAR(sum, expected, 1e-9 * expected);
}

TEST(TriangulatePolygon, ConvexIsAFanFromTheFirstCorner) {
    const Polygon hexagon = in_xy({{2, 0}, {1, 1.7}, {-1, 1.7}, {-2, 0}, {-1, -1.7}, {1, -1.7}});
    const std::vector<IndexTriple> fan = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
    EXPECT_EQ(triangulate(hexagon), fan);
}

TEST(TriangulatePolygon, QuadIsCutAlongTheDiagonalInside) {
    // An arrowhead, its notch at each corner in turn.
    const std::vector<DVec2> arrow = {{0, 0}, {2, -1}, {1, 0}, {2, 1}};
    for (std::size_t shift = 0; shift < 4; ++shift) {
        std::vector<DVec2> points = arrow;
        std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(shift),
                    points.end());
        expect_exact_cover(in_xy(points));
    }
}

TEST(TriangulatePolygon, QuadWithACornerOnAnEdgeHasNoFlatTriangle) {
    expect_exact_cover(in_xy({{0, 0}, {1, 0}, {2, 0}, {0, 2}}));
    expect_exact_cover(in_xy({{0, 2}, {0, 0}, {1, 0}, {2, 0}}));
}

TEST(TriangulatePolygon, PolygonWithCornersOnEdgesHasNoFlatTriangle) {
    expect_exact_cover(in_xy({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}));
}

TEST(TriangulatePolygon, EveryTurnOfAnLShapeIsCovered) {
    std::vector<DVec2> points = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::rotate(points.begin(), points.begin() + 1, points.end());
        expect_exact_cover(in_xy(points));
    }
}

TEST(TriangulatePolygon, AnyPlaneAndOrientationKeepTheNormal) {
    const Polygon flat = in_xy({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}});
    const DVec3 x_axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 0}, {0.6, 0, 0.8}};
    const DVec3 y_axes[] = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (std::size_t k = 0; k < std::size(x_axes); ++k) {
        Polygon polygon;
        for (const Vec3 p : flat) {
            polygon.emplace_back(Vec3(x_axes[k] * double{p.x} + y_axes[k] * double{p.y}));
        }
        const DVec3 normal = cross(x_axes[k], y_axes[k]);
        double sum = 0.0;
        for (const auto [a, b, c] : triangulate(polygon)) {
            const DVec3 turn =
                cross(DVec3(polygon[b]) - DVec3(polygon[a]), DVec3(polygon[c]) - DVec3(polygon[a]));
            EXPECT_GT(dot(turn, normal), 0.0);
            sum += dot(turn, normal) / 2;
        }
        EXPECT_NEAR(sum, 5.0, 1e-5);
    }
}

TEST(TriangulatePolygon, SeamToAHoleIsCovered) {
    // A square with a square hole, joined by an edge that is walked both ways.
    expect_exact_cover(
        in_xy({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}));
}

TEST(TriangulatePolygon, RandomStarShapesAreCovered) {
    constexpr unsigned kSeed = 7;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> radius(0.1, 1.0);
    for (int round = 0; round < 300; ++round) {
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", round " << round);
        const int count = 5 + static_cast<int>(random() % 60);
        std::vector<DVec2> points;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * kPi * i / count;
            points.push_back(radius(random) * DVec2(std::cos(angle), std::sin(angle)));
        }
        expect_exact_cover(in_xy(points));
    }
}

TEST(TriangulatePolygon, ShapesWithoutAreaOrWithCrossingEdgesStillGiveAllTriangles) {
    PolygonTriangulator triangulator;
    const Polygon point(7, Vec3(1, 2, 3));
    EXPECT_EQ(triangulator.triangulate(point).size(), 5u);
    const Polygon line = in_xy({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1.5, 0}});
    EXPECT_EQ(triangulator.triangulate(line).size(), 3u);
    const Polygon bow = in_xy({{0, 0}, {2, 2}, {2, 0}, {0, 2}, {1, 5}});
    EXPECT_EQ(triangulator.triangulate(bow).size(), 3u);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    for (int round = 0; round < 200; ++round) {
        std::vector<DVec2> points(4 + random() % 40);
        for (DVec2& p : points) p = DVec2(anywhere(random), anywhere(random));
        const Polygon tangle = in_xy(points);
        const auto triangles = triangulator.triangulate(tangle);
        ASSERT_EQ(triangles.size(), points.size() - 2);
        for (const IndexTriple& triple : triangles) {
            for (const std::uint32_t corner : triple) ASSERT_LT(corner, points.size());
        }
    }
}

// Shapes with 100,000 corners: quadratic work would take a minute each.
class TriangulateLargePolygon : public testing::Test {
 protected:
    static constexpr int kCount = 100'000;

    static void expect_quick_cover(const std::vector<DVec2>& points) {
        const auto begin = std::chrono::steady_clock::now();
        expect_exact_cover(in_xy(points));
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
        EXPECT_LT(seconds.count(), 10.0);  // 0.1 when nothing disturbs or instruments
    }
};

TEST_F(TriangulateLargePolygon, Circle) {
    std::vector<DVec2> points;
    for (int i = 0; i < kCount; ++i) {
        const double angle = 2 * kPi * i / kCount;
        points.push_back(4096.0 * DVec2(std::cos(angle), std::sin(angle)));
    }
    PolygonTriangulator triangulator;
    EXPECT_EQ(triangulator.triangulate(in_xy(points)).size(), points.size() - 2);
}

TEST_F(TriangulateLargePolygon, Gear) {
    std::vector<DVec2> points;
    for (int i = 0; i < kCount; ++i) {
        const double angle = 2 * kPi * i / kCount;
        points.push_back((i % 4 < 2 ? 4096.0 : 4000.0) * DVec2(std::cos(angle), std::sin(angle)));
    }
    expect_quick_cover(points);
}

TEST_F(TriangulateLargePolygon, Comb) {
    std::vector<DVec2> points;
    for (int i = 0; i < kCount / 2; ++i) points.emplace_back(i, i % 2 == 0 ? 0.0 : 1000.0);
    for (int i = kCount / 2 - 1; i >= 0; --i) points.emplace_back(i, i % 2 == 0 ? 0.5 : 1000.5);
    std::reverse(points.begin(), points.end());
    if (area_xy(in_xy(points)) < 0) std::reverse(points.begin(), points.end());
    expect_quick_cover(points);
}

TEST_F(TriangulateLargePolygon, Spiral) {
    std::vector<DVec2> points;
    const auto at = [](int i, double offset) {
        const double angle = 200 * kPi * i / (kCount / 2);
        return (10.0 + angle + offset) * DVec2(std::cos(angle), std::sin(angle));
    };
    for (int i = 0; i < kCount / 2; ++i) points.push_back(at(i, 2.0));
    for (int i = kCount / 2 - 1; i >= 0; --i) points.push_back(at(i, 0.0));
    expect_quick_cover(points);
}

TEST_F(TriangulateLargePolygon, Spikes) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> radius(1e3, 1e6);
    std::vector<DVec2> points;
    for (int i = 0; i < kCount; ++i) {
        const double angle = 2 * kPi * i / kCount;
        points.push_back(radius(random) * DVec2(std::cos(angle), std::sin(angle)));
    }
    expect_quick_cover(points);
}

TEST_F(TriangulateLargePolygon, TangleEndsInTime) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    std::vector<DVec2> points(kCount);
    for (DVec2& p : points) p = DVec2(anywhere(random), anywhere(random));
    const Polygon tangle = in_xy(points);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(triangulate(tangle).size(), points.size() - 2);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(seconds.count(), 10.0);
}

}  // namespace
}  // namespace lray::scene
