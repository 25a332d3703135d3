#include "cli/run.h"

#include <gtest/gtest.h>

#include "cli/stats.h"

namespace lray::cli {
namespace {

TEST(PartialPath, KeepsDirectoryAndExtension) {
    EXPECT_EQ(partial_path("image.png"), "image.partial.png");
    EXPECT_EQ(partial_path("a.b/image.ppm"), "a.b/image.partial.ppm");
    EXPECT_EQ(partial_path("a.b/image"), "a.b/image.partial");
}

TEST(Notes, BruteForceThatWillBeSlowIsAnnounced) {
    const auto notes = [](std::size_t sphere_count, bool quiet) {
        scene::World world;
        world.spheres.resize(sphere_count);
        View view;
        view.render_options.resolution = {1000, 1000};
        Options options;
        options.quiet = quiet;
        testing::internal::CaptureStderr();
        print_notes(view, world, options);
        return testing::internal::GetCapturedStderr();
    };
    EXPECT_NE(notes(2001, false).find("each of 1000000 rays tests all 2001 primitives"),
              std::string::npos);
    EXPECT_EQ(notes(2000, false), "");
    EXPECT_EQ(notes(2001, true), "");
}

TEST(FormatStats, SaysWhatWasRenderedAndHowFast) {
    scene::World world;
    world.object_ids[static_cast<std::size_t>(scene::PrimitiveKind::triangle)].resize(12);
    world.object_ids[static_cast<std::size_t>(scene::PrimitiveKind::plane)].resize(1);
    render::RenderResult result;
    result.image = image::Image(4, 3);
    result.counts.rays = 2'000'000;
    result.counts.primitive_tests = 5'000'000;
    result.thread_count = 2;
    const StageTimes times{0.5, 0.25, 0.125, 4.0, 0.0625};
    const std::string text = format_stats(world, bvh::AccelKind::none, result, times);
    EXPECT_NE(text.find("12 triangles, 1 planes"), std::string::npos) << text;
    EXPECT_NE(text.find("4 x 3 pixels"), std::string::npos) << text;
    EXPECT_NE(text.find("2000000, 2.5 tests per ray"), std::string::npos) << text;
    EXPECT_NE(text.find("0.500 parse, 0.250 flatten, 0.125 build, 4.000 render"), std::string::npos)
        << text;
    EXPECT_NE(text.find("0.500 Mrays/s on 2 threads"), std::string::npos) << text;
    EXPECT_EQ(text.find("0.0 MiB"), std::string::npos) << text;
}

TEST(FormatStats, NoRaysIsNotADivision) {
    const std::string text = format_stats({}, bvh::AccelKind::none, {}, {});
    EXPECT_NE(text.find("0, 0.0 tests per ray"), std::string::npos) << text;
    EXPECT_NE(text.find("0.000 Mrays/s"), std::string::npos) << text;
}

}  // namespace
}  // namespace lray::cli
