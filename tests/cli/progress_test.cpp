#include "cli/progress.h"

#include <gtest/gtest.h>

namespace lray::cli {
namespace {

TEST(Progress, BarShowsShareAndTimeLeftAndIsErased) {
    Progress progress(ProgressStyle::bar);
    EXPECT_EQ(progress.update({10, 100}, 0.4), "") << "a short render shows no bar";
    EXPECT_EQ(progress.finish(), "");
    EXPECT_EQ(progress.update({25, 100}, 1.0),
              "\r\x1b[K[##########..............................]  25 %  0:03 left");
    EXPECT_EQ(progress.update({100, 100}, 4.0),
              "\r\x1b[K[########################################] 100 %  0:00 left");
    EXPECT_EQ(progress.finish(), "\r\x1b[K");
}

TEST(Progress, BarBeforeTheFirstPixelDoesNotGuess) {
    Progress progress(ProgressStyle::bar);
    EXPECT_EQ(progress.update({0, 100}, 1.0),
              "\r\x1b[K[........................................]   0 %  ? left");
}

TEST(Progress, BarIsNotFullBeforeTheEnd) {
    Progress progress(ProgressStyle::bar);
    const std::string text = progress.update({999'999, 1'000'000}, 10.0);
    EXPECT_NE(text.find(" 99 %"), std::string::npos) << text;
}

TEST(Progress, LinesComeEachTenPercentOnceTheRenderLasts) {
    Progress progress(ProgressStyle::lines);
    EXPECT_EQ(progress.update({30, 100}, 1.9), "");
    EXPECT_EQ(progress.update({45, 100}, 4.5), "45 %, 0:06 left\n");
    EXPECT_EQ(progress.update({49, 100}, 5.0), "");
    EXPECT_EQ(progress.update({50, 100}, 5.0), "50 %, 0:05 left\n");
    EXPECT_EQ(progress.finish(), "");
}

TEST(Progress, LinesComeEachThirtySecondsWhenItIsSlow) {
    Progress progress(ProgressStyle::lines);
    EXPECT_EQ(progress.update({1, 1000}, 29.0), "");
    EXPECT_EQ(progress.update({1, 1000}, 30.0), "0 %, 8:19:30 left\n");
    EXPECT_EQ(progress.update({2, 1000}, 59.0), "");
    EXPECT_EQ(progress.update({2, 1000}, 60.0), "0 %, 8:19:00 left\n");
}

TEST(Progress, SilentSaysNothing) {
    Progress progress(ProgressStyle::silent);
    EXPECT_EQ(progress.update({50, 100}, 1000.0), "");
    EXPECT_EQ(progress.finish(), "");
}

TEST(Progress, LabelStandsBeforeBarAndLines) {
    Progress bar(ProgressStyle::bar, "frame 3 of 8");
    EXPECT_EQ(bar.begin(), "\r\x1b[Kframe 3 of 8");
    EXPECT_TRUE(bar.update({25, 100}, 1.0).starts_with("\r\x1b[Kframe 3 of 8 [####"));
    EXPECT_EQ(bar.finish(), "\r\x1b[K");
    Progress lines(ProgressStyle::lines, "frame 3 of 8");
    EXPECT_EQ(lines.begin(), "frame 3 of 8\n");
    EXPECT_EQ(lines.update({50, 100}, 5.0), "frame 3 of 8: 50 %, 0:05 left\n");
    EXPECT_EQ(Progress(ProgressStyle::silent, "frame 3 of 8").begin(), "");
    EXPECT_EQ(Progress(ProgressStyle::lines).begin(), "");
}

TEST(Progress, BuildingIsToldWhenItTakesAWhile) {
    Progress bar(ProgressStyle::bar);
    EXPECT_EQ(bar.building(99'999), "");
    EXPECT_EQ(bar.finish(), "");
    EXPECT_EQ(bar.building(100'000), "\r\x1b[Kbuilding the hierarchy of 100000 primitives");
    EXPECT_EQ(bar.finish(), "\r\x1b[K");
    Progress lines(ProgressStyle::lines, "frame 3 of 8");
    EXPECT_EQ(lines.building(200'000),
              "frame 3 of 8: building the hierarchy of 200000 primitives\n");
    EXPECT_EQ(lines.finish(), "");
    EXPECT_EQ(Progress(ProgressStyle::silent).building(200'000), "");
}

TEST(FormatDuration, SecondsMinutesHours) {
    EXPECT_EQ(format_duration(0.0), "0:00");
    EXPECT_EQ(format_duration(6.2), "0:07");
    EXPECT_EQ(format_duration(59.5), "1:00");
    EXPECT_EQ(format_duration(754.0), "12:34");
    EXPECT_EQ(format_duration(3723.0), "1:02:03");
    EXPECT_EQ(format_duration(1e300), "277777:46:40");
    EXPECT_EQ(format_duration(-1.0), "0:00");
}

TEST(Progress, ALimitOfTimeTellsTheTimeAndTheSamples) {
    Progress progress(ProgressStyle::lines);
    const render::RenderProgress done{.done_samples = 4000,
                                      .total_samples = 32'768'000,
                                      .total_pixels = 1000,
                                      .seconds = 5.0,
                                      .limits = {.seconds = 20.0}};
    EXPECT_EQ(progress.update(done, 5.0), "25 %, 0:15 left, 4.0 samples a pixel\n");
}

TEST(Progress, AllSamplesMayComeBeforeTheTime) {
    Progress progress(ProgressStyle::lines);
    const render::RenderProgress done{.done_samples = 5000,
                                      .total_samples = 10'000,
                                      .total_pixels = 1000,
                                      .seconds = 5.0,
                                      .limits = {.seconds = 3600.0}};
    EXPECT_EQ(progress.update(done, 5.0), "50 %, 0:05 left, 5.0 samples a pixel\n");
}

TEST(Progress, ALimitOfNoiseTellsThePixelsThatAreDone) {
    Progress progress(ProgressStyle::bar);
    const render::RenderProgress done{.done_samples = 64'000,
                                      .total_samples = 32'768'000,
                                      .finished_pixels = 500,
                                      .total_pixels = 1000,
                                      .seconds = 4.0,
                                      .limits = {.noise = 0.01}};
    EXPECT_EQ(progress.update(done, 4.0),
              "\r\x1b[K[####################....................]  50 %  0:04 left, 64.0 samples a "
              "pixel, 50 % of the pixels done");
}

}  // namespace
}  // namespace lray::cli
