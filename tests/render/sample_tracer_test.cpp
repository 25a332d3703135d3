#include "render/sample_tracer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <vector>

#include "base/angle.h"
#include "bvh/accel.h"

namespace lray::render {
namespace {

using scene::PrimitiveKind;

/// White spheres and planes on black, seen from straight above without perspective: world x and z
/// are the picture's.
class SampleTracerTest : public testing::Test {
 protected:
    SampleTracerTest() {
        world_.materials.emplace_back();
        world_.materials.back().diffuse = Color{1.0f};
        world_.objects.emplace_back();
        camera_.projection = scene::Projection::orthographic;
        camera_.position = {0.0, 10.0, 0.0};
        camera_.look_at = {0.0, 0.0, 0.0};
        camera_.up = {0.0, 0.0, -1.0};
        options_.position = PixelPosition::random;
    }

    void add_sphere(Vec3 center, float radius) {
        world_.spheres.push_back({center, radius});
        world_.object_ids[static_cast<std::size_t>(PrimitiveKind::sphere)].emplace_back(
            std::size_t{0});
    }

    /// A strip between x = low and x = high that is longer than the picture.
    void add_strip(float low, float high) {
        world_.rectangles.push_back({{Vec3{low, 0.0f, 9.0f}, Vec3{high, 0.0f, 9.0f},
                                      Vec3{high, 0.0f, -9.0f}, Vec3{low, 0.0f, -9.0f}}});
        world_.object_ids[static_cast<std::size_t>(PrimitiveKind::rectangle)].emplace_back(
            std::size_t{0});
    }

    static std::vector<FilmPlace> all_of(const PixelRect& part) {
        std::vector<FilmPlace> places;
        for (std::uint32_t y = 0; y < part.height(); ++y) {
            for (std::uint32_t x = 0; x < part.width(); ++x) places.push_back({x, y});
        }
        return places;
    }

    Film traced(const PixelRect& part, const std::vector<SampleRange>& ranges) const {
        const auto accel = bvh::build(world_, {.kind = bvh::AccelKind::none});
        const std::atomic<bool> cancel{false};
        const SampleTracer tracer(world_, *accel, camera_, options_, cancel);
        Film film(part.width(), part.height());
        RayCounts counts;
        for (const SampleRange range : ranges) {
            EXPECT_EQ(tracer.add_samples(part, all_of(part), range, film, counts, cancel),
                      part.pixel_count() * range.count());
        }
        return film;
    }

    scene::World world_;
    scene::Camera camera_;
    RenderOptions options_;
};

TEST_F(SampleTracerTest, RangesAddUpToTheWholeInAnyOrder) {
    add_sphere({0.2f, 0.0f, 0.1f}, 0.8f);
    options_.resolution = {21, 13};
    const PixelRect part{2, 1, 20, 12};
    const Film whole = traced(part, {{0, 40}});
    const Film pieces = traced(part, {{33, 40}, {0, 1}, {12, 33}, {1, 12}});
    std::size_t mixed = 0;
    for (std::uint32_t y = 0; y < part.height(); ++y) {
        for (std::uint32_t x = 0; x < part.width(); ++x) {
            ASSERT_EQ(whole.resolve(x, y), pieces.resolve(x, y)) << x << ", " << y;
            const float value = whole.resolve(x, y).r;
            if (value > 0.0f && value < 1.0f) ++mixed;
        }
    }
    EXPECT_GT(mixed, 10u) << "the edge must pass through pixels, or nothing is compared";
}

// A pixel of which a share is covered: the mean of n random samples has the standard deviation
// sqrt(share (1 - share) / n).
TEST_F(SampleTracerTest, MeanOfAPartlyCoveredPixelConvergesToItsCoverage) {
    options_.resolution = {1, 1};
    camera_.height = 1.0;  // the pixel is [-0.5, 0.5] each way
    for (const double share : {0.5, 0.25, 0.9}) {
        world_.rectangles.clear();
        world_.object_ids[static_cast<std::size_t>(PrimitiveKind::rectangle)].clear();
        add_strip(-5.0f, static_cast<float>(share - 0.5));
        for (const std::uint32_t count : {64u, 1024u, 16384u}) {
            const Film film = traced({0, 0, 1, 1}, {{0, count}});
            const double deviation = std::sqrt(share * (1.0 - share) / count);
            EXPECT_NEAR(static_cast<double>(film.resolve(0, 0).r), share, 5.0 * deviation)
                << share << " by " << count;
        }
    }
}

TEST_F(SampleTracerTest, DiskInAPictureHasItsArea) {
    options_.resolution = {32, 32};
    camera_.height = 2.0;
    add_sphere({0.0f, 0.0f, 0.0f}, 0.75f);
    const Film film = traced({0, 0, 32, 32}, {{0, 64}});
    double mean = 0.0;
    for (std::uint32_t y = 0; y < 32; ++y) {
        for (std::uint32_t x = 0; x < 32; ++x) {
            mean += static_cast<double>(film.resolve(x, y).r) / 1024.0;
        }
    }
    const double area = std::acos(-1.0) * 0.75 * 0.75 / 4.0;  // of the picture's 2 x 2
    // Only the some 75 pixels on the rim vary, each by at most 1/2 for one sample.
    EXPECT_NEAR(mean, area, 5.0 * std::sqrt(75.0 * 0.25 / 64.0) / 1024.0);
}

TEST_F(SampleTracerTest, CostIsThatOfEachRayAlone) {
    options_.resolution = {4, 4};
    options_.shading.shader = shade::Shader::cost;
    add_sphere({0.0f, 0.0f, 0.0f}, 1.0f);
    add_sphere({5.0f, 0.0f, 0.0f}, 1.0f);
    const Film film = traced({0, 0, 4, 4}, {{0, 1}});
    for (std::uint32_t y = 0; y < 4; ++y) {
        for (std::uint32_t x = 0; x < 4; ++x) {
            // Two tests are half way between the colours of 1 and of 4.
            const Color color = film.resolve(x, y);
            EXPECT_NEAR(color.b, 0.35f, 1e-6f);
            EXPECT_NEAR(color.r, 0.0f, 1e-6f);
        }
    }
}

TEST_F(SampleTracerTest, CancelledTracesNothing) {
    options_.resolution = {4, 4};
    const auto accel = bvh::build(world_, {.kind = bvh::AccelKind::none});
    const std::atomic<bool> cancel{true};
    const SampleTracer tracer(world_, *accel, camera_, options_, cancel);
    Film film(4, 4);
    RayCounts counts;
    const PixelRect part{0, 0, 4, 4};
    EXPECT_EQ(tracer.add_samples(part, all_of(part), {0, 3}, film, counts, cancel), 0u);
    EXPECT_EQ(counts.primary.rays, 0u);
}

}  // namespace
}  // namespace lray::render
