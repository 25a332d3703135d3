#include "render/render.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <mutex>
#include <set>
#include <vector>

#include "render/sample_tracer.h"
#include "tests/render/pattern_accel.h"

namespace lray::render {
namespace {

class RenderTest : public testing::Test {
 protected:
    RenderTest() {
        options_.resolution = {101, 67};
        options_.shading.background = {0.25f, 0.5f, 1.0f};
        options_.thread_count = 1;
    }

    void use_random_samples(std::uint32_t count) {
        options_.samples = {0, count};
        options_.position = PixelPosition::random;
        options_.seed = 7;
    }

    static void expect_part_of(const image::Image& whole, const image::Image& part,
                               const PixelRect& crop) {
        ASSERT_EQ(part.width, crop.width());
        ASSERT_EQ(part.height, crop.height());
        for (std::uint32_t y = crop.y0; y < crop.y1; ++y) {
            for (std::uint32_t x = crop.x0; x < crop.x1; ++x) {
                ASSERT_EQ(part.at(x - crop.x0, y - crop.y0), whole.at(x, y)) << x << ", " << y;
            }
        }
    }

    RenderResult run(const ProgressFunction& on_progress = {}) const {
        return render(world_, accel_, camera_, options_, on_progress, cancel_);
    }

    scene::World world_ = pattern_world();
    PatternAccel accel_;
    scene::Camera camera_ = pattern_camera();
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

TEST_F(RenderTest, EverySamplerAndLensGivesTheSameBitsHoweverItIsSplit) {
    camera_.focus = 3.0;
    for (const SamplerKind sampler : {SamplerKind::sobol, SamplerKind::random}) {
        for (const double aperture : {0.0, 0.5}) {
            use_random_samples(5);
            options_.sampler = sampler;
            camera_.aperture = aperture;
            options_.thread_count = 1;
            options_.batch_size = 64;
            options_.crop.reset();
            const RenderResult single = run();
            for (const std::uint32_t thread_count : {2u, 7u}) {
                options_.thread_count = thread_count;
                options_.batch_size = 5 * thread_count;
                EXPECT_EQ(run().image.pixels, single.image.pixels) << thread_count;
            }
            options_.crop = PixelRect{31, 9, 77, 60};
            expect_part_of(single.image, run().image, *options_.crop);
        }
    }
}

TEST_F(RenderTest, SamplersAndLensesDiffer) {
    use_random_samples(4);
    const RenderResult sobol = run();
    options_.sampler = SamplerKind::random;
    const RenderResult random = run();
    EXPECT_NE(random.image.pixels, sobol.image.pixels);
    camera_.aperture = 0.5;
    EXPECT_NE(run().image.pixels, random.image.pixels);
    options_.position = PixelPosition::center;  // the middle of the lens too
    const RenderResult center = run();
    camera_.aperture = 0.0;
    EXPECT_EQ(run().image.pixels, center.image.pixels);
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
        EXPECT_EQ(part.primary.rays, 3 * crop.pixel_count());
        expect_part_of(whole.image, part.image, crop);
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

/// The samples of each pixel and its picture, by itself: what --noise promises.
TEST_F(RenderTest, NoiseGivesEachPixelThePowerOfTwoThatItNeeds) {
    constexpr std::uint32_t kMax = 512;
    use_random_samples(kMax);
    options_.limits.noise = 0.02;
    const RenderResult result = run();
    EXPECT_TRUE(result.is_complete);
    EXPECT_EQ(result.sample_count, result.primary.rays);
    const SampleTracer tracer(world_, accel_, camera_, options_, cancel_);
    const image::Display display({});
    std::uint64_t sample_count = 0;
    std::uint64_t converged = 0;
    std::set<std::uint32_t> seen;
    for (std::uint32_t y = 0; y < 67; ++y) {
        for (std::uint32_t x = 0; x < 101; ++x) {
            Film film(1, 1, Film::Keeps::squares);
            RayCounts counts;
            std::uint32_t done = 0;
            for (std::uint32_t next = kFirstNoiseCheck; next <= kMax; next *= 2) {
                const std::array<FilmPlace, 1> place{{{0, 0}}};
                tracer.add_samples({x, y, x + 1, y + 1}, place, {done, next}, film, counts,
                                   cancel_);
                done = next;
                const Color mean = film.resolve(0, 0);
                const Color error = film.standard_error(0, 0);
                bool is_quiet = true;
                for (int channel = 0; channel < 3; ++channel) {
                    is_quiet = is_quiet &&
                               display.displayed_error(static_cast<double>(mean[channel]),
                                                       static_cast<double>(error[channel])) <= 0.02;
                }
                if (!is_quiet) continue;
                if (done < kMax) ++converged;
                break;
            }
            sample_count += done;
            seen.insert(done);
            ASSERT_EQ(result.image.at(x, y), film.resolve(0, 0)) << x << ", " << y;
        }
    }
    EXPECT_EQ(result.sample_count, sample_count);
    EXPECT_EQ(result.converged_pixels, converged);
    EXPECT_GE(seen.size(), 3u) << "pixels must need different numbers, or nothing is compared";
}

TEST_F(RenderTest, NoiseDoesNotDependOnThreadsBatchesCropsOrTime) {
    use_random_samples(256);
    options_.limits.noise = 0.03;
    const RenderResult single = run();
    options_.thread_count = 7;
    options_.batch_size = 3;
    EXPECT_EQ(run().image.pixels, single.image.pixels);
    options_.limits.seconds = 1e9;  // whole passes over the picture, and time enough
    const RenderResult passes = run();
    EXPECT_EQ(passes.image.pixels, single.image.pixels);
    EXPECT_EQ(passes.sample_count, single.sample_count);
    EXPECT_EQ(passes.converged_pixels, single.converged_pixels);
    options_.crop = PixelRect{13, 7, 62, 45};
    expect_part_of(single.image, run().image, *options_.crop);
    options_.limits.seconds.reset();
    expect_part_of(single.image, run().image, *options_.crop);
}

TEST_F(RenderTest, BrighterExposureNeedsMoreSamples) {
    use_random_samples(256);
    options_.limits.noise = 0.02;
    options_.display.exposure = -3.0;
    const RenderResult dark = run();
    options_.display.exposure = 0.0;
    EXPECT_GT(run().sample_count, dark.sample_count);
}

TEST_F(RenderTest, TimeEndsOnWholePasses) {
    use_random_samples(Film::kMaxSamples);
    for (const double seconds : {1e-9, 0.2}) {
        options_.limits.seconds = seconds;
        options_.thread_count = 2;
        const RenderResult result = run();
        EXPECT_TRUE(result.is_complete);
        const std::uint64_t pixel_count = 101 * 67;
        ASSERT_EQ(result.sample_count % pixel_count, 0u);
        const auto passes = static_cast<std::uint32_t>(result.sample_count / pixel_count);
        EXPECT_GE(passes, 1u);
        if (seconds < 0.1) {
            EXPECT_EQ(passes, 1u);
        } else {
            EXPECT_GT(passes, 1u);
        }
        RenderOptions fixed = options_;
        fixed.limits = {};
        fixed.samples = {0, passes};
        EXPECT_EQ(render(world_, accel_, camera_, fixed, {}, cancel_).image.pixels,
                  result.image.pixels);
    }
}

TEST_F(RenderTest, AllSamplesEndARenderBeforeItsTime) {
    use_random_samples(3);
    const RenderResult fixed = run();
    options_.limits.seconds = 1e9;
    const RenderResult result = run();
    EXPECT_EQ(result.image.pixels, fixed.image.pixels);
    EXPECT_EQ(result.sample_count, 3u * 101u * 67u);
}

TEST_F(RenderTest, CancelledInAPassKeepsWhatThereIs) {
    options_.resolution = {8, 8};
    const RenderResult whole = run();
    options_.samples = {0, 16};
    options_.limits.seconds = 1e9;
    const CancellingAccel accel(cancel_, 64 * 5);
    const RenderResult result = render(world_, accel, camera_, options_, {}, cancel_);
    EXPECT_FALSE(result.is_complete);
    EXPECT_EQ(result.primary.rays, 64u * 5);
    EXPECT_EQ(result.image.pixels, whole.image.pixels);
}

TEST_F(RenderTest, ProgressOfLimitsTellsPixelsAndTime) {
    use_random_samples(128);
    options_.limits = {.seconds = 1e9, .noise = 0.05};
    std::vector<RenderProgress> told;
    run([&](const RenderProgress& progress) { told.push_back(progress); });
    ASSERT_FALSE(told.empty());
    for (const RenderProgress& progress : told) {
        EXPECT_EQ(progress.total_pixels, 101u * 67u);
        EXPECT_LE(progress.finished_pixels, progress.total_pixels);
        EXPECT_EQ(progress.limits.noise, 0.05);
        EXPECT_GE(progress.seconds, 0.0);
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
