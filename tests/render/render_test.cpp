#include "render/render.h"

#include <gtest/gtest.h>

#include <cmath>
#include <mutex>
#include <set>
#include <vector>

#include "base/angle.h"

namespace lray::render {
namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;

/// A pattern over all directions, so that every pixel's colour tells where its ray went.
class PatternAccel : public bvh::Accel {
 public:
    static constexpr int kStripes = 37;

    bvh::Hit nearest_hit(const Ray& ray, Interval, bvh::TraceCounts& counts) const override {
        ++counts.rays;
        counts.primitive_tests += 3;
        const float cell = std::floor(ray.dir.x * 91.0f) + 5.0f * std::floor(ray.dir.y * 53.0f);
        const int stripe = static_cast<int>(std::fabs(cell)) % (kStripes + 1);
        if (stripe == kStripes) return {};  // a miss: the background
        return {1.0f, 0.0f, 0.0f,
                PrimitiveId(PrimitiveKind::sphere, static_cast<std::size_t>(stripe))};
    }
    bool any_hit(const Ray& ray, Interval interval, bvh::TraceCounts& counts) const override {
        return !nearest_hit(ray, interval, counts).is_none();
    }

    bvh::AccelStats stats() const override { return {}; }
};

class RenderTest : public testing::Test {
 protected:
    RenderTest() {
        auto& object_ids = world_.object_ids[static_cast<std::size_t>(PrimitiveKind::sphere)];
        for (std::size_t i = 0; i < PatternAccel::kStripes; ++i) {
            object_ids.emplace_back(i);
            world_.objects.emplace_back();
            world_.objects.back().material = static_cast<std::uint32_t>(i);
            world_.materials.emplace_back();
            world_.materials.back().diffuse = Color{0.1f * static_cast<float>(i), 0.7f, 0.01f};
        }
        options_.resolution = {101, 67};
        options_.shading.background = {0.25f, 0.5f, 1.0f};
        options_.thread_count = 1;
        camera_.fov = radians(80.0);
    }

    void use_random_samples(std::uint32_t count) {
        options_.samples = {0, count};
        options_.position = PixelPosition::random;
        options_.seed = 7;
    }

    RenderResult run(const ProgressFunction& on_progress = {}) const {
        return render(world_, accel_, camera_, options_, on_progress, cancel_);
    }

    scene::World world_;
    PatternAccel accel_;
    scene::Camera camera_;
    RenderOptions options_;
    std::atomic<bool> cancel_{false};
};

TEST_F(RenderTest, EveryPixelIsTracedOnce) {
    const RenderResult result = run();
    EXPECT_TRUE(result.is_complete);
    EXPECT_EQ(result.image.width, 101u);
    EXPECT_EQ(result.image.height, 67u);
    EXPECT_EQ(result.primary.rays, 101u * 67u);
    EXPECT_EQ(result.primary.primitive_tests, 3u * 101u * 67u);
    EXPECT_EQ(result.samples.nan, 0u);
    std::set<float> reds;
    for (const Color& pixel : result.image.pixels) reds.insert(pixel.r);
    EXPECT_GT(reds.size(), 30u) << "the pattern must show, or the other tests compare nothing";
    EXPECT_TRUE(reds.contains(0.25f)) << "the background must show";
}

TEST_F(RenderTest, ThreadsGiveTheSameBits) {
    use_random_samples(3);
    const RenderResult single = run();
    for (const std::uint32_t thread_count : {2u, 3u, 8u, 0u}) {
        options_.thread_count = thread_count;
        const RenderResult result = run();
        EXPECT_EQ(result.image.pixels, single.image.pixels) << thread_count;
        EXPECT_EQ(result.primary.rays, single.primary.rays);
        EXPECT_EQ(result.primary.primitive_tests, single.primary.primitive_tests);
        if (thread_count != 0) {
            EXPECT_EQ(result.thread_count, thread_count);
        }
    }
}

TEST_F(RenderTest, BatchesOfAnySizeGiveTheSameBits) {
    use_random_samples(2);
    const RenderResult single = run();
    for (const std::uint32_t batch_size : {1u, 3u, 63u, 1000u}) {
        options_.batch_size = batch_size;
        EXPECT_EQ(run().image.pixels, single.image.pixels) << batch_size;
    }
}

TEST_F(RenderTest, CropIsTheSamePixelsOfTheWhole) {
    use_random_samples(3);
    const RenderResult whole = run();
    for (const PixelRect& crop : {PixelRect{0, 0, 101, 67}, PixelRect{0, 0, 1, 1},
                                  PixelRect{100, 66, 101, 67}, PixelRect{13, 7, 62, 45}}) {
        options_.crop = crop;
        options_.thread_count = 2;
        const RenderResult part = run();
        EXPECT_TRUE(part.is_complete);
        ASSERT_EQ(part.image.width, crop.width());
        ASSERT_EQ(part.image.height, crop.height());
        EXPECT_EQ(part.primary.rays, 3 * crop.pixel_count());
        for (std::uint32_t y = crop.y0; y < crop.y1; ++y) {
            for (std::uint32_t x = crop.x0; x < crop.x1; ++x) {
                ASSERT_EQ(part.image.at(x - crop.x0, y - crop.y0), whole.image.at(x, y));
            }
        }
    }
}

TEST_F(RenderTest, CancelledBeforeItBeginsIsBlackAndIncomplete) {
    cancel_ = true;
    const RenderResult result = run();
    EXPECT_FALSE(result.is_complete);
    EXPECT_EQ(result.primary.rays, 0u);
    for (const Color& pixel : result.image.pixels) ASSERT_EQ(pixel, Color(0.0f));
}

/// Cancels the render from within, at the given ray.
class CancellingAccel : public PatternAccel {
 public:
    CancellingAccel(std::atomic<bool>& cancel, std::uint64_t at) : cancel_(cancel), at_(at) {}

    bvh::Hit nearest_hit(const Ray& ray, Interval interval,
                         bvh::TraceCounts& counts) const override {
        if (++ray_count_ == at_) cancel_ = true;
        return PatternAccel::nearest_hit(ray, interval, counts);
    }

 private:
    std::atomic<bool>& cancel_;
    std::uint64_t at_ = 0;
    mutable std::atomic<std::uint64_t> ray_count_{0};
};

TEST_F(RenderTest, CancelledMidwayStopsAfterThatBatchAndKeepsWhatIsDone) {
    const RenderResult whole = run();
    for (const std::uint32_t batch_size : {1u, 64u}) {
        options_.batch_size = batch_size;
        cancel_ = false;
        const CancellingAccel accel(cancel_, 1000);
        const RenderResult result = render(world_, accel, camera_, options_, {}, cancel_);
        EXPECT_FALSE(result.is_complete);
        EXPECT_GE(result.primary.rays, 1000u);
        EXPECT_LT(result.primary.rays, 1000u + batch_size);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < whole.image.pixels.size(); ++i) {
            if (result.image.pixels[i] == Color(0.0f)) continue;
            ASSERT_EQ(result.image.pixels[i], whole.image.pixels[i]);
            ++kept;
        }
        EXPECT_EQ(kept, result.primary.rays);  // no colour of the pattern is black
    }
}

TEST_F(RenderTest, CancelledMidwayAPixelIsTheMeanOfTheSamplesItHas) {
    options_.resolution = {8, 8};  // one block
    const RenderResult whole = run();
    options_.samples = {0, 16};
    const CancellingAccel accel(cancel_, 64 * 5);
    const RenderResult result = render(world_, accel, camera_, options_, {}, cancel_);
    EXPECT_FALSE(result.is_complete);
    EXPECT_EQ(result.primary.rays, 64u * 5);
    EXPECT_EQ(result.image.pixels, whole.image.pixels);  // all samples are at the centre
}

TEST_F(RenderTest, EverySampleIsTracedOnce) {
    use_random_samples(5);
    const RenderResult result = run();
    EXPECT_TRUE(result.is_complete);
    EXPECT_EQ(result.primary.rays, 5u * 101u * 67u);
    options_.samples = {3, 5};
    EXPECT_EQ(run().primary.rays, 2u * 101u * 67u);
}

TEST_F(RenderTest, AnotherSeedIsAnotherPicture) {
    use_random_samples(2);
    const RenderResult first = run();
    EXPECT_EQ(run().image.pixels, first.image.pixels);
    options_.seed = 8;
    EXPECT_NE(run().image.pixels, first.image.pixels);
}

TEST_F(RenderTest, PixelIsTheMeanOfItsSamples) {
    use_random_samples(4);
    const RenderResult all = run();
    std::vector<Color> sums(all.image.pixels.size(), Color{0.0f});
    for (std::uint32_t sample = 0; sample < 4; ++sample) {
        options_.samples = {sample, sample + 1};
        const RenderResult single = run();
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += single.image.pixels[i];
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            ASSERT_NEAR(all.image.pixels[i][channel], sums[i][channel] / 4.0f, 1e-6f) << i;
        }
    }
}

TEST_F(RenderTest, ProgressIsToldAndOneAtATime) {
    options_.thread_count = 2;
    options_.samples = {0, 3};
    std::mutex mutex;
    std::vector<RenderProgress> told;
    bool overlapped = false;
    const RenderResult result = run([&](const RenderProgress& progress) {
        const std::unique_lock lock(mutex, std::try_to_lock);
        if (!lock.owns_lock()) {
            overlapped = true;
            return;
        }
        told.push_back(progress);
    });
    EXPECT_TRUE(result.is_complete);
    EXPECT_FALSE(overlapped);
    ASSERT_FALSE(told.empty());
    std::uint64_t last = 0;
    for (const RenderProgress& progress : told) {
        EXPECT_EQ(progress.total_samples, 3u * 101u * 67u);
        EXPECT_LE(progress.done_samples, progress.total_samples);
        EXPECT_GE(progress.done_samples, last);
        last = progress.done_samples;
    }
}

TEST_F(RenderTest, NoSamplesOrTooManyAreOurBug) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    options_.samples = {3, 3};
    EXPECT_EXIT(run(), testing::ExitedWithCode(70), "internal error");
    options_.samples = {0, Film::kMaxSamples + 1};
    EXPECT_EXIT(run(), testing::ExitedWithCode(70), "internal error");
}

TEST_F(RenderTest, CropOutsideIsOurBug) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    options_.crop = PixelRect{0, 0, 102, 67};
    EXPECT_EXIT(run(), testing::ExitedWithCode(70), "internal error");
    options_.crop = PixelRect{5, 5, 5, 6};
    EXPECT_EXIT(run(), testing::ExitedWithCode(70), "internal error");
}

}  // namespace
}  // namespace lray::render
