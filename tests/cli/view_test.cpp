#include "cli/view.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace lray::cli {
namespace {

constexpr Color kRed{1.0f, 0.0f, 0.0f};
constexpr Color kBlue{0.0f, 0.0f, 1.0f};

scene::Scene scene_with_cameras() {
    scene::Scene scene;
    scene.render.resolution = {400, 300};
    scene.render.background = kRed;
    scene.render.samples = 4;
    scene.render.seed = 77;
    scene::Camera front;
    front.name = "front";
    front.position = {0.0, 0.0, 1.0};
    scene::Camera top;
    top.name = "top";
    top.position = {0.0, 2.0, 0.1};
    top.resolution = scene::Resolution{50, 40};
    top.background = kBlue;
    top.samples = 9;
    scene.cameras = {front, top};
    return scene;
}

View chosen(const scene::Scene& scene, const Options& options) {
    const auto result = choose_view(scene, {}, options);
    if (const auto* failure = std::get_if<Failure>(&result)) {
        ADD_FAILURE() << failure->message;
        return {};
    }
    return std::get<View>(result);
}

Failure refused(const scene::Scene& scene, const Options& options) {
    const auto result = choose_view(scene, {}, options);
    if (std::holds_alternative<View>(result)) {
        ADD_FAILURE() << "no error";
        return {ExitCode::done, {}, {}};
    }
    return std::get<Failure>(result);
}

TEST(ChooseView, FirstCameraAndTheRenderBlock) {
    const View view = chosen(scene_with_cameras(), {});
    EXPECT_EQ(view.camera.name, "front");
    EXPECT_EQ(view.render_options.resolution, (scene::Resolution{400, 300}));
    EXPECT_EQ(view.render_options.shading.background, kRed);
    EXPECT_EQ(view.pixel_count(), 120'000u);
}

TEST(ChooseView, NamedCameraOverridesTheRenderBlock) {
    Options options;
    options.camera_name = "top";
    const View view = chosen(scene_with_cameras(), options);
    EXPECT_EQ(view.camera.name, "top");
    EXPECT_EQ(view.render_options.resolution, (scene::Resolution{50, 40}));
    EXPECT_EQ(view.render_options.shading.background, kBlue);
}

TEST(ChooseView, CommandLineOverridesTheCamera) {
    Options options;
    options.camera_name = "top";
    options.size = scene::Resolution{7, 5};
    options.thread_count = 3;
    const View view = chosen(scene_with_cameras(), options);
    EXPECT_EQ(view.render_options.resolution, (scene::Resolution{7, 5}));
    EXPECT_EQ(view.render_options.thread_count, 3u);
}

TEST(ChooseView, SamplesOfTheCommandLineThenTheCameraThenTheRenderBlock) {
    using Range = render::SampleRange;
    const scene::Scene scene = scene_with_cameras();
    const auto samples = [&](const Options& options) {
        return chosen(scene, options).render_options.samples;
    };
    Options options;
    EXPECT_EQ(samples(options), (Range{0, 4}));
    EXPECT_EQ(chosen(scene, options).ray_count(), 480'000u);
    options.camera_name = "top";
    EXPECT_EQ(samples(options), (Range{0, 9}));
    options.samples = 16;
    EXPECT_EQ(samples(options), (Range{0, 16}));
    options.sample_range = Range{3, 12};
    EXPECT_EQ(samples(options), (Range{3, 12}));
    options.sample_range = Range{3, 200};
    EXPECT_EQ(samples(options), (Range{3, 16})) << "the first limit reached ends it";
    options.samples.reset();
    EXPECT_EQ(samples(options), (Range{3, 200}));
    options.position = render::PixelPosition::center;
    EXPECT_EQ(samples(options), (Range{0, 1})) << "level 1";
    EXPECT_EQ(chosen({}, {}).render_options.samples, (Range{0, 1})) << "the default";
}

TEST(ChooseView, SeedShaderAndPositionReachTheRender) {
    Options options;
    EXPECT_EQ(chosen(scene_with_cameras(), options).render_options.seed, 77u);
    options.seed = 0;
    options.shader = shade::Shader::depth;
    options.position = render::PixelPosition::center;
    options.accel = bvh::AccelKind::spheres;
    const render::RenderOptions given = chosen(scene_with_cameras(), options).render_options;
    EXPECT_EQ(given.seed, 0u);
    EXPECT_EQ(given.shading.shader, shade::Shader::depth);
    EXPECT_EQ(given.position, render::PixelPosition::center);
    EXPECT_GT(given.batch_size, 1u);
    options.accel = bvh::AccelKind::none;
    EXPECT_EQ(chosen(scene_with_cameras(), options).render_options.batch_size, 1u);
}

TEST(ChooseView, UnknownCameraIsAUsageErrorThatNamesTheOthers) {
    Options options;
    options.camera_name = "tpo";
    const Failure near = refused(scene_with_cameras(), options);
    EXPECT_EQ(near.exit_code, ExitCode::usage);
    EXPECT_EQ(near.message, "the scene has no camera named `tpo`");
    EXPECT_EQ(near.help, "did you mean `top`?");
    options.camera_name = "elsewhere";
    EXPECT_EQ(refused(scene_with_cameras(), options).help, "it has `front`, `top`");
    scene::Scene nameless;
    nameless.cameras.resize(1);
    EXPECT_EQ(refused(nameless, options).help,
              "none has a name; write one before its brace: camera \"front\" { ... }");
    scene::Scene many;
    many.cameras.resize(10);
    for (std::size_t i = 0; i < 10; ++i) many.cameras[i].name = fmt::format("c{}", i);
    EXPECT_EQ(refused(many, options).help,
              "it has `c0`, `c1`, `c2`, `c3`, `c4`, `c5`, `c6`, `c7` and 2 more");
}

TEST(ChooseView, SceneWithoutCameraGetsAFittedOne) {
    const View view = chosen({}, {});
    EXPECT_EQ(view.render_options.resolution, (scene::Resolution{800, 600}));
    EXPECT_GT(view.camera.position.y, 0.0);
    EXPECT_NE(view.camera.position, scene::Camera{}.position);
}

TEST(ChooseView, CropMustLieInThePicture) {
    Options options;
    options.crop = render::PixelRect{0, 0, 400, 300};
    EXPECT_EQ(chosen(scene_with_cameras(), options).pixel_count(), 120'000u);
    options.crop = render::PixelRect{399, 299, 400, 300};
    EXPECT_EQ(chosen(scene_with_cameras(), options).pixel_count(), 1u);
    for (const auto& crop :
         {render::PixelRect{0, 0, 401, 300}, render::PixelRect{0, 0, 400, 301}}) {
        options.crop = crop;
        const Failure failure = refused(scene_with_cameras(), options);
        EXPECT_EQ(failure.exit_code, ExitCode::usage);
        EXPECT_EQ(failure.help, "the picture has 400 x 300 pixels");
    }
    EXPECT_EQ(refused(scene_with_cameras(), options).message,
              "`--crop 0,0,400,301` leaves the picture");
}

TEST(ChooseView, PixelLimitHoldsForWhatIsWritten) {
    Options options;
    options.max_output_pixels = 120'001;
    EXPECT_EQ(chosen(scene_with_cameras(), options).pixel_count(), 120'000u);
    options.max_output_pixels = 120'000;
    EXPECT_EQ(chosen(scene_with_cameras(), options).pixel_count(), 120'000u);
    options.max_output_pixels = 119'999;
    const Failure failure = refused(scene_with_cameras(), options);
    EXPECT_EQ(failure.exit_code, ExitCode::limit);
    EXPECT_EQ(failure.message, "the picture would have 120000 pixels; the limit is 119999");
    EXPECT_NE(failure.help.find("--max-output-pixels"), std::string::npos);
    options.size = scene::Resolution{2147483647, 2147483647};
    EXPECT_EQ(refused(scene_with_cameras(), options).exit_code, ExitCode::limit);
    options.crop = render::PixelRect{2147483000, 2147483000, 2147483100, 2147483100};
    EXPECT_EQ(chosen(scene_with_cameras(), options).pixel_count(), 10'000u);
}

TEST(ChooseView, WhatTheFormatCannotHoldIsToldBeforeItIsRendered) {
    Options options;
    options.size = scene::Resolution{2, 65'501};
    options.format = image::Format::jpg;
    const Failure failure = refused(scene_with_cameras(), options);
    EXPECT_EQ(failure.exit_code, ExitCode::usage);
    EXPECT_EQ(failure.message,
              "the picture would have a side of 65501 pixels; the most of the format jpg is 65500");
    options.crop = render::PixelRect{0, 1, 2, 65'501};
    EXPECT_EQ(chosen(scene_with_cameras(), options).pixel_count(), 131'000u);
    options.crop.reset();
    options.format = image::Format::png;
    EXPECT_EQ(chosen(scene_with_cameras(), options).pixel_count(), 131'002u);
}

TEST(ChooseView, WithLimitsTheCapIsTheMaximumUnlessGiven) {
    using Range = render::SampleRange;
    Options options;
    options.sample_limits.seconds = 2.0;
    const View view = chosen(scene_with_cameras(), options);
    EXPECT_EQ(view.render_options.samples, (Range{0, 32'768}));
    EXPECT_EQ(view.render_options.limits.seconds, 2.0);
    EXPECT_EQ(view.ray_count(), 120'000u) << "one pass is sure";
    options.samples = 16;
    options.sample_limits.noise = 0.5;
    EXPECT_EQ(chosen(scene_with_cameras(), options).render_options.samples, (Range{0, 16}));
    EXPECT_EQ(chosen(scene_with_cameras(), options).render_options.limits.noise, 0.5);
    options.position = render::PixelPosition::center;
    const View center = chosen(scene_with_cameras(), options);
    EXPECT_EQ(center.render_options.samples, (Range{0, 1})) << "level 1";
    EXPECT_FALSE(center.render_options.limits.is_any());
}

TEST(ChooseView, SamplerOfTheCommandLineThenTheRenderBlock) {
    scene::Scene scene = scene_with_cameras();
    EXPECT_EQ(chosen(scene, {}).render_options.sampler, SamplerKind::sobol);
    scene.render.sampler = SamplerKind::random;
    EXPECT_EQ(chosen(scene, {}).render_options.sampler, SamplerKind::random);
    Options options;
    options.sampler = SamplerKind::sobol;
    EXPECT_EQ(chosen(scene, options).render_options.sampler, SamplerKind::sobol);
}

TEST(ChooseView, LightOfTheRenderBlockReachesTheShading) {
    scene::Scene scene = scene_with_cameras();
    scene.render.integrator = scene::Integrator::path;
    scene.render.ambient = kBlue;
    scene.render.max_depth = 17;
    scene.render.transparent_shadows = true;
    const shade::Settings shading = chosen(scene, {}).render_options.shading;
    EXPECT_EQ(shading.integrator, scene::Integrator::path);
    EXPECT_EQ(shading.ambient, kBlue);
    EXPECT_EQ(shading.max_depth, 17u);
    EXPECT_TRUE(shading.transparent_shadows);
}

scene::World lit_world() {
    scene::World world;
    world.lights.emplace_back();
    return world;
}

shade::Shader shader_of(const scene::Scene& scene, const scene::World& world,
                        const Options& options) {
    return std::get<View>(choose_view(scene, world, options)).render_options.shading.shader;
}

TEST(ChooseView, LightIsShownIfThereIsAny) {
    const scene::Scene scene = scene_with_cameras();
    EXPECT_EQ(shader_of(scene, {}, {}), shade::Shader::flat);
    EXPECT_EQ(shader_of(scene, lit_world(), {}), shade::Shader::full);
    Options options;
    options.shader = shade::Shader::full;
    EXPECT_EQ(shader_of(scene, {}, options), shade::Shader::full);
    options.shader = shade::Shader::normals;
    EXPECT_EQ(shader_of(scene, lit_world(), options), shade::Shader::normals);
}

TEST(ChooseView, WhatGivesOffLightIsALightAlongPathsAlone) {
    scene::Scene scene = scene_with_cameras();
    scene::World world;
    world.materials.emplace_back();
    scene.render.integrator = scene::Integrator::path;
    EXPECT_EQ(shader_of(scene, world, {}), shade::Shader::flat);
    world.materials.back().emission = Color{0.0f, 2.0f, 0.0f};
    EXPECT_EQ(shader_of(scene, world, {}), shade::Shader::full);
    scene.render.integrator = scene::Integrator::whitted;
    EXPECT_EQ(shader_of(scene, world, {}), shade::Shader::flat);
}

TEST(ChooseView, ExposureAndToneMapAreForLightAndGammaForAll) {
    scene::Scene scene = scene_with_cameras();
    scene.render.exposure = 1.5;
    scene.render.tonemap = image::ToneMap::aces;
    scene.render.gamma = image::Gamma::linear;
    Options options;
    options.shader = shade::Shader::full;
    const image::DisplaySettings light = chosen(scene, options).render_options.display;
    EXPECT_EQ(light.exposure, 1.5);
    EXPECT_EQ(light.tonemap, image::ToneMap::aces);
    EXPECT_EQ(light.gamma, image::Gamma::linear);
    options.shader = shade::Shader::depth;
    const image::DisplaySettings depth = chosen(scene, options).render_options.display;
    EXPECT_EQ(depth.exposure, 0.0);
    EXPECT_EQ(depth.tonemap, image::ToneMap::none);
    EXPECT_EQ(depth.gamma, image::Gamma::linear);
}

}  // namespace
}  // namespace lray::cli
