#include "cli/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/did_you_mean.h"
#include "image/write.h"
#include "render/film.h"
#include "render/fit_camera.h"
#include "scene/lit.h"

namespace lray::cli {

namespace {

constexpr std::size_t kMaxListed = 8;

Failure unknown_camera(const scene::Scene& scene, std::string_view name) {
    std::vector<std::string_view> names;
    for (const scene::Camera& camera : scene.cameras) {
        if (!camera.name.empty()) names.push_back(camera.name);
    }
    Failure failure;
    failure.message = fmt::format("the scene has no camera named `{}`", name);
    if (names.empty()) {
        failure.help = "none has a name; write one before its brace: camera \"front\" { ... }";
        return failure;
    }
    failure.help = did_you_mean(name, names);
    if (!failure.help.empty()) return failure;
    failure.help = "it has";
    for (std::size_t i = 0; i < std::min(names.size(), kMaxListed); ++i) {
        failure.help += fmt::format("{} `{}`", i == 0 ? "" : ",", names[i]);
    }
    if (names.size() > kMaxListed) {
        failure.help += fmt::format(" and {} more", names.size() - kMaxListed);
    }
    return failure;
}

std::optional<Failure> check_size(const View& view, const Options& options) {
    const auto [width, height] = view.render_options.resolution;
    if (options.crop && (options.crop->x1 > width || options.crop->y1 > height)) {
        return Failure{ExitCode::usage,
                       fmt::format("`--crop {},{},{},{}` leaves the picture", options.crop->x0,
                                   options.crop->y0, options.crop->x1, options.crop->y1),
                       fmt::format("the picture has {} x {} pixels", width, height)};
    }
    if (view.pixel_count() > options.max_output_pixels) {
        return Failure{
            ExitCode::limit,
            fmt::format("the picture would have {} pixels; the limit is {}", view.pixel_count(),
                        options.max_output_pixels),
            "raise it with `--max-output-pixels N`, or render a part with `--crop X0,Y0,X1,Y1`"};
    }
    const render::PixelRect area = options.crop.value_or(render::PixelRect{0, 0, width, height});
    const std::uint32_t side = std::max(area.width(), area.height());
    const auto most = options.format ? image::max_side(*options.format) : std::nullopt;
    if (most && side > *most) {
        return Failure{ExitCode::usage,
                       fmt::format("the picture would have a side of {} pixels; the most of the "
                                   "format {} is {}",
                                   side, image::format_name(*options.format), *most),
                       "choose another format, or render a part with `--crop X0,Y0,X1,Y1`"};
    }
    return std::nullopt;
}

/// Which samples of each pixel: the command line over the camera over the render block. The centre
/// of a pixel is one place; what ends a render earlier leaves the number open, and so does a
/// window.
render::SampleRange samples_of(const scene::Scene& scene, const scene::Camera* camera,
                               const Options& options) {
    if (options.position == render::PixelPosition::center) return {0, 1};
    if (options.sample_range) {
        const auto [begin, end] = *options.sample_range;
        return {begin, std::min(end, options.samples.value_or(end))};
    }
    if (options.sample_limits.is_any() || options.mode == Mode::window) {
        return {0, options.samples.value_or(render::Film::kMaxSamples)};
    }
    std::uint32_t count = scene.render.samples;
    if (camera != nullptr) count = camera->samples.value_or(count);
    return {0, options.samples.value_or(count)};
}

/// What the picture shows: as asked for, else light if there is any.
shade::Settings shading_of(const scene::Scene& scene, const scene::World& world,
                           const scene::Camera* camera, const Options& options) {
    const shade::Shader usual =
        scene::is_lit(scene, world) ? shade::Shader::full : shade::Shader::flat;
    shade::Settings shading;
    shading.shader = options.shader.value_or(usual);
    shading.background = scene.render.background;
    if (camera != nullptr) shading.background = camera->background.value_or(shading.background);
    shading.integrator = scene.render.integrator;
    shading.ambient = scene.render.ambient;
    shading.max_depth = scene.render.max_depth;
    shading.transparent_shadows = scene.render.transparent_shadows;
    return shading;
}

/// Exposure and tone map are for light: what else is shown has values of its own.
image::DisplaySettings display_of(const scene::RenderSettings& render, shade::Shader shader) {
    if (shader != shade::Shader::full) return {.gamma = render.gamma};
    return {render.exposure, render.tonemap, render.gamma};
}

}  // namespace

bool expects_light(const Options& options) {
    return options.level != 1u && !options.shader;
}

std::variant<View, Failure> choose_view(const scene::Scene& scene, const scene::World& world,
                                        const Options& options) {
    auto camera = scene.cameras.begin();
    if (options.camera_name) {
        camera = std::find_if(scene.cameras.begin(), scene.cameras.end(), [&](const auto& other) {
            return other.name == *options.camera_name;
        });
        if (camera == scene.cameras.end()) return unknown_camera(scene, *options.camera_name);
    }
    const bool has_camera = camera != scene.cameras.end();
    View view;
    view.render_options.resolution = scene.render.resolution;
    if (has_camera) {
        view.camera = *camera;
        view.render_options.resolution =
            camera->resolution.value_or(view.render_options.resolution);
    }
    view.render_options.resolution = options.size.value_or(view.render_options.resolution);
    view.render_options.crop = options.crop;
    const scene::Camera* const chosen = has_camera ? &*camera : nullptr;
    view.render_options.samples = samples_of(scene, chosen, options);
    view.render_options.position = options.position;
    view.render_options.sampler = options.sampler.value_or(scene.render.sampler);
    if (options.position == render::PixelPosition::random) {
        view.render_options.limits = options.sample_limits;
    }
    view.render_options.seed = options.seed.value_or(scene.render.seed);
    view.render_options.shading = shading_of(scene, world, chosen, options);
    view.render_options.display = display_of(scene.render, view.render_options.shading.shader);
    view.render_options.thread_count = options.thread_count;
    // Without a hierarchy a ray may take long: stopping must not wait for many.
    if (options.accel == bvh::AccelKind::none) view.render_options.batch_size = 1;
    if (auto failure = check_size(view, options)) return *failure;
    if (!has_camera) {
        view.camera = render::fit_camera(finite_bounds(world), view.render_options.resolution);
    }
    return view;
}

}  // namespace lray::cli
