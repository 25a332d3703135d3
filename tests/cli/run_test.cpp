#include "cli/run.h"

#include <gtest/gtest.h>

#include "bvh/simd/walk.h"
#include "cli/stats.h"
#include "tests/support/json.h"

namespace lray::cli {
namespace {

TEST(PartialPath, KeepsDirectoryAndExtension) {
    EXPECT_EQ(partial_path("image.png"), "image.partial.png");
    EXPECT_EQ(partial_path("a.b/image.ppm"), "a.b/image.partial.ppm");
    EXPECT_EQ(partial_path("a.b/image"), "a.b/image.partial");
}

TEST(Notes, BruteForceThatWillBeSlowIsAnnounced) {
    const auto notes = [](std::size_t sphere_count, bool quiet,
                          bvh::AccelKind accel = bvh::AccelKind::none) {
        scene::World world;
        world.spheres.resize(sphere_count);
        View view;
        view.render_options.resolution = {1000, 100};
        view.render_options.samples = {6, 16};
        Options options;
        options.quiet = quiet;
        options.accel = accel;
        testing::internal::CaptureStderr();
        print_notes(view, world, options);
        return testing::internal::GetCapturedStderr();
    };
    EXPECT_NE(notes(2001, false).find("each of 1000000 rays tests all 2001 primitives"),
              std::string::npos);
    EXPECT_NE(notes(2001, false).find("`--accel boxes`"), std::string::npos);
    EXPECT_EQ(notes(2000, false), "");
    EXPECT_EQ(notes(2001, true), "");
    EXPECT_EQ(notes(2001, false, bvh::AccelKind::spheres), "");
}

TEST(Notes, InstancesCountAsOftenAsTheyArePlaced) {
    scene::World world;
    world.prototypes.resize(2);
    world.prototypes[0].spheres.resize(1000);
    world.prototypes[1].instances.resize(2);  // of the first one
    world.instances.resize(3);
    for (scene::WorldInstance& instance : world.instances) instance.prototype = 1;
    View view;
    view.render_options.resolution = {1000, 1000};
    Options options;
    options.accel = bvh::AccelKind::none;
    testing::internal::CaptureStderr();
    print_notes(view, world, options);
    // 3 x (2 x 1000 + 2) + 3
    EXPECT_NE(testing::internal::GetCapturedStderr().find("tests all 6009 primitives"),
              std::string::npos);
}

/// A picture of 4 x 3 pixels with 16 samples, for its statistics.
class FormatStats : public testing::Test {
 protected:
    FormatStats() {
        world_.object_ids[static_cast<std::size_t>(scene::PrimitiveKind::triangle)].resize(12);
        world_.object_ids[static_cast<std::size_t>(scene::PrimitiveKind::plane)].resize(1);
        options_.accel = bvh::AccelKind::spheres;
        view_.render_options.samples = {16, 32};
        accel_.nodes = 9;
        accel_.leaves = 5;
        accel_.depth = 4;
        accel_.references = 13;
        accel_.cost = 2.75;
        accel_.bytes = 3 * 1024 * 1024;
        result_.image = image::Image(4, 3);
        result_.primary.rays = 2'000'000;
        result_.primary.node_tests = 3'000'000;
        result_.primary.primitive_tests = 5'000'000;
        result_.primary.instance_tests = 500'000;
        result_.thread_count = 2;
        times_ = {0.5, 0.25, 0.125, 4.0, 0.0625};
    }

    RenderReport report() const { return {world_, options_, view_, accel_, result_, times_}; }

    scene::World world_;
    Options options_;
    View view_;
    bvh::AccelStats accel_;
    render::RenderResult result_;
    StageTimes times_;
};

TEST_F(FormatStats, SaysWhatWasRenderedAndHowFast) {
    const std::string text = format_stats(report());
    EXPECT_TRUE(text.starts_with(
        "primitives   13: 12 triangles, 1 planes\n"
        "hierarchy    spheres: 9 nodes, 5 of them leaves, at most 4 deep; 13 references, cost "
        "2.75, "
        "3.00 MiB\n"
        "picture      4 x 3 pixels, 16 samples each\n"
        "rays         2000000 primary\n"
        "tests        1.50 nodes, 2.50 primitives, 0.25 instances per ray\n"
        "samples      0 clamped, 0 not a number\n"
        "seconds      0.500 parse, 0.250 flatten, 0.125 build, 4.000 render, 0.062 write\n"
        "speed        0.500 Mrays/s on 2 threads\n"
        "memory       "))
        << text;
    EXPECT_EQ(text.find(" 0.0 MiB"), std::string::npos) << text;
}

TEST_F(FormatStats, BoxesNameWhatTheyAreWalkedWith) {
    options_.accel = bvh::AccelKind::boxes;
    const std::string simd = bvh::simd_walks().name;
    EXPECT_NE(format_stats(report()).find("hierarchy    boxes (" + simd + "): 9 nodes"),
              std::string::npos)
        << format_stats(report());
    EXPECT_EQ(test::read_json(format_stats_json(report()))["hierarchy"]["simd"].string, simd);
}

TEST_F(FormatStats, PrototypesAndTheirPlacesAreCounted) {
    world_.prototypes.resize(1);
    world_.prototypes[0]
        .object_ids[static_cast<std::size_t>(scene::PrimitiveKind::triangle)]
        .resize(8);
    world_.object_ids[static_cast<std::size_t>(scene::PrimitiveKind::instance)].resize(5);
    world_.place_count = 6;
    EXPECT_TRUE(
        format_stats(report()).starts_with("primitives   26: 20 triangles, 1 planes, 5 instances; "
                                           "1 prototypes in 5 places\n"))
        << format_stats(report());
}

TEST_F(FormatStats, NoRaysIsNotADivision) {
    result_ = {};
    times_ = {};
    const std::string text = format_stats(report());
    EXPECT_NE(text.find("0.00 nodes, 0.00 primitives"), std::string::npos) << text;
    EXPECT_NE(text.find("0.000 Mrays/s"), std::string::npos) << text;
}

TEST_F(FormatStats, MachinesGetOneLineOfJson) {
    const std::string text = format_stats_json(report());
    EXPECT_EQ(text.find('\n'), text.size() - 1);
    const test::Json json = test::read_json(text);
    EXPECT_EQ(json["primitives"]["triangles"].number, 12.0);
    EXPECT_EQ(json["hierarchy"]["kind"].string, "spheres");
    EXPECT_EQ(json["hierarchy"]["simd"].string, "");
    EXPECT_EQ(json["hierarchy"]["nodes"].number, 9.0);
    EXPECT_EQ(json["hierarchy"]["cost"].number, 2.75);
    EXPECT_EQ(json["hierarchy"]["bytes"].number, 3145728.0);
    EXPECT_EQ(json["picture"]["first_sample"].number, 16.0);
    EXPECT_EQ(json["picture"]["samples"].number, 16.0);
    EXPECT_EQ(json["rays"]["primary"]["count"].number, 2e6);
    EXPECT_EQ(json["rays"]["primary"]["node_tests"].number, 3e6);
    EXPECT_EQ(json["rays"]["primary"]["instance_tests"].number, 5e5);
    EXPECT_EQ(json["seconds"]["build"].number, 0.125);
    EXPECT_EQ(json["threads"].number, 2.0);
    EXPECT_GT(json["peak_bytes"].number, 0.0);
}

TEST_F(FormatStats, WithLimitsTellsTheSamplesInAllAndTheirMean) {
    view_.render_options.resolution = {4, 3};
    view_.render_options.samples = {0, 32'768};
    view_.render_options.limits.seconds = 30.0;
    result_.sample_count = 450;
    EXPECT_NE(format_stats(report()).find(
                  "picture      4 x 3 pixels, 450 samples, 37.5 each on average\n"),
              std::string::npos)
        << format_stats(report());
    view_.render_options.limits.noise = 0.01;
    result_.converged_pixels = 9;
    EXPECT_NE(format_stats(report()).find(
                  "37.5 each on average; 75.0 % of the pixels are as quiet as asked for\n"),
              std::string::npos)
        << format_stats(report());
    const test::Json json = test::read_json(format_stats_json(report()));
    EXPECT_EQ(json["picture"]["samples_taken"].number, 450.0);
    EXPECT_EQ(json["picture"]["samples_per_pixel"].number, 37.5);
    EXPECT_EQ(json["picture"]["converged_pixels"].number, 9.0);
}

}  // namespace
}  // namespace lray::cli
