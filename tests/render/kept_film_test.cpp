// Renders that are interrupted anywhere and go on from their film.
#include "render/kept_film.h"

#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <vector>

#include "render/render.h"
#include "tests/render/pattern_accel.h"
#include "tests/support/random.h"

namespace lray::render {
namespace {

/// Sets `cancel` after so many rays.
class EndingAccel : public PatternAccel {
 public:
    bvh::Hit nearest_hit(const Ray& ray, Interval interval,
                         bvh::TraceCounts& counts) const override {
        if (rays_left_.fetch_sub(1) == 1) cancel_ = true;
        return PatternAccel::nearest_hit(ray, interval, counts);
    }

    void end_after(std::int64_t ray_count) {
        rays_left_ = ray_count;
        cancel_ = false;
    }
    const std::atomic<bool>& cancel() const { return cancel_; }

 private:
    mutable std::atomic<std::int64_t> rays_left_{0};
    mutable std::atomic<bool> cancel_{false};
};

class KeptFilmTest : public testing::Test {
 protected:
    KeptFilmTest() {
        options_.resolution = {37, 29};
        options_.samples = {0, 20};
        options_.position = PixelPosition::random;
        options_.shading.background = {0.25f, 0.5f, 1.0f};
        options_.thread_count = 2;
    }

    PixelRect area() const {
        const auto [width, height] = options_.resolution;
        return options_.crop.value_or(PixelRect{0, 0, width, height});
    }

    Film empty_film() const {
        return Film(area().width(), area().height(), film_keeps(options_.limits.noise));
    }

    RenderResult whole() {
        accel_.end_after(0);
        return render(world_, accel_, camera_, options_, {}, accel_.cancel());
    }

    /// Renders until so many rays were traced, then goes on from the film; and so on to the end.
    RenderResult in_pieces(std::int64_t rays_each, int& piece_count) {
        Film film = empty_film();
        for (piece_count = 1;; ++piece_count) {
            KeptFilm kept(std::move(film), area(), {}, std::chrono::seconds(1));
            accel_.end_after(rays_each);
            RenderResult result =
                render(world_, accel_, camera_, options_, {}, accel_.cancel(), &kept);
            if (result.is_complete) return result;
            EXPECT_FALSE(result.has_all_samples);
            film = kept.film();
        }
    }

    void expect_same_in_pieces(std::int64_t rays_each, int least_pieces) {
        const RenderResult expected = whole();
        int piece_count = 0;
        const RenderResult result = in_pieces(rays_each, piece_count);
        EXPECT_EQ(result.image.pixels, expected.image.pixels);
        EXPECT_TRUE(result.has_all_samples);
        EXPECT_GE(piece_count, least_pieces) << "nothing was interrupted";
    }

    scene::World world_ = pattern_world();
    EndingAccel accel_;
    scene::Camera camera_ = pattern_camera();
    RenderOptions options_;
};

TEST_F(KeptFilmTest, InterruptedAnywhereGivesTheSameBits) {
    for (const std::int64_t rays : {1500, 5000, 11'111}) expect_same_in_pieces(rays, 2);
}

TEST_F(KeptFilmTest, OfACropAndARangeOfSamples) {
    options_.crop = PixelRect{5, 3, 36, 28};
    options_.samples = {7, 24};
    expect_same_in_pieces(3000, 3);
}

TEST_F(KeptFilmTest, PixelsThatEndByTheirNoiseStayEnded) {
    options_.limits.noise = 0.02;
    options_.samples = {0, 300};
    const RenderResult expected = whole();
    ASSERT_GT(expected.converged_pixels, 50u);
    ASSERT_LT(expected.converged_pixels, 1000u);
    expect_same_in_pieces(20'000, 3);
}

TEST_F(KeptFilmTest, WithALimitOfTimePassesGoOn) {
    options_.limits.seconds = 1e6;
    expect_same_in_pieces(4000, 3);
}

TEST_F(KeptFilmTest, TimeThatEndsItLeavesSamplesToDo) {
    options_.limits.seconds = 1e-9;
    KeptFilm kept(empty_film(), area(), {}, std::chrono::seconds(1));
    accel_.end_after(0);
    const RenderResult first =
        render(world_, accel_, camera_, options_, {}, accel_.cancel(), &kept);
    EXPECT_TRUE(first.is_complete);
    EXPECT_FALSE(first.has_all_samples);
    EXPECT_EQ(kept.film().pixel(36, 28).sample_count, 1u);
    render(world_, accel_, camera_, options_, {}, accel_.cancel(), &kept);
    EXPECT_EQ(kept.film().pixel(36, 28).sample_count, 2u);
}

TEST_F(KeptFilmTest, MoreSamplesThanBeforeAreAdded) {
    KeptFilm kept(empty_film(), area(), {}, std::chrono::seconds(1));
    accel_.end_after(0);
    options_.samples = {0, 5};
    render(world_, accel_, camera_, options_, {}, accel_.cancel(), &kept);
    options_.samples = {0, 20};
    const RenderResult result =
        render(world_, accel_, camera_, options_, {}, accel_.cancel(), &kept);
    EXPECT_EQ(result.sample_count, 15u * 37u * 29u) << "what is there is not rendered again";
    EXPECT_EQ(result.image.pixels, whole().image.pixels);
}

TEST_F(KeptFilmTest, WhatIsSavedOnTheWayIsWhole) {
    std::vector<Film> saved;
    KeptFilm kept(
        empty_film(), area(), [&](const Film& film) { saved.push_back(film); },
        std::chrono::duration<double>(0.0));
    accel_.end_after(0);
    render(world_, accel_, camera_, options_, {}, accel_.cancel(), &kept);
    ASSERT_GT(saved.size(), 20u);
    const RenderResult expected = whole();
    for (std::size_t i = 0; i < saved.size(); i += 17) {
        KeptFilm again(saved[i], area(), {}, std::chrono::seconds(1));
        const RenderResult result =
            render(world_, accel_, camera_, options_, {}, accel_.cancel(), &again);
        ASSERT_EQ(result.image.pixels, expected.image.pixels) << i;
    }
}

TEST_F(KeptFilmTest, ProgressBeginsWithWhatIsThere) {
    KeptFilm kept(empty_film(), area(), {}, std::chrono::seconds(1));
    accel_.end_after(0);
    options_.samples = {0, 10};
    render(world_, accel_, camera_, options_, {}, accel_.cancel(), &kept);
    options_.samples = {0, 20};
    std::optional<RenderProgress> first;
    render(
        world_, accel_, camera_, options_,
        [&](const RenderProgress& progress) { first = first.value_or(progress); }, accel_.cancel(),
        &kept);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->kept_samples, 10u * 37u * 29u);
    EXPECT_GE(first->done_samples, first->kept_samples);
}

}  // namespace
}  // namespace lray::render
