#include "tests/shade/lit_scene.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>

#include "base/diagnostic_printer.h"
#include "base/file_access.h"
#include "parser/load.h"
#include "scene/flatten.h"
#include "shade/transport/boundary.h"
#include "tests/support/temp_directory.h"

namespace lray::test {

LitScene::LitScene(std::string_view text, bvh::AccelKind kind) {
    const TempDirectory directory;
    directory.write("main.lrs", text);
    FileAccess files;
    scene_ = parser::load(directory.path("main.lrs"), {}, files, sources_, diagnostics_).scene;
    if (scene_) world_ = scene::flatten(*scene_, {}, diagnostics_);
    if (!world_) {
        std::string messages;
        for (const Diagnostic* diagnostic : diagnostics_.sorted()) {
            messages += diagnostic->message + "\n";
        }
        throw std::runtime_error("a scene of a test is wrong: " + messages);
    }
    accel_ = bvh::build(*world_, {.kind = kind});
    lit_ = std::make_unique<shade::LitWorld>(*world_, *accel_);
    settings.shader = shade::Shader::full;
    settings.background = scene_->render.background;
    settings.ambient = scene_->render.ambient;
    settings.max_depth = scene_->render.max_depth;
    settings.integrator = scene_->render.integrator;
    settings.transparent_shadows = scene_->render.transparent_shadows;
}

Color LitScene::seen(DVec3 origin, DVec3 direction, std::uint32_t sample) const {
    const Ray ray{Vec3{origin}, Vec3{direction / std::sqrt(dot(direction, direction))}};
    const shade::RayCone cone{};
    const PixelSample of_pixel = PixelSample::of(SamplerKind::sobol, 1, 2, 3, sample);
    bvh::TraceCounts camera_counts;
    const bvh::Hit hit = accel_->nearest_hit(ray, {}, camera_counts);
    const shade::Media media = shade::media_at(*lit_, ray.origin, camera_counts);
    const std::atomic<bool> cancel = false;
    Color color{0.0f};
    const bool is_complete = shade::follow_light(
        *lit_, settings, media,
        {std::span(&ray, 1), std::span(&cone, 1), std::span(&of_pixel, 1), std::span(&hit, 1)},
        std::span(&color, 1), counts_, cancel);
    EXPECT_TRUE(is_complete);
    return color;
}

DVec3 LitScene::mean(DVec3 origin, DVec3 direction, std::uint32_t sample_count) const {
    DVec3 sum{0.0};
    for (std::uint32_t i = 0; i < sample_count; ++i) sum += DVec3{seen(origin, direction, i)};
    return sum / static_cast<double>(sample_count);
}

}  // namespace lray::test
