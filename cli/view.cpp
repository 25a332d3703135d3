#include "cli/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/did_you_mean.h"
#include "render/fit_camera.h"

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
    return std::nullopt;
}

}  // namespace

std::uint64_t View::pixel_count() const {
    const auto [width, height] = render_options.resolution;
    return render_options.crop ? render_options.crop->pixel_count() : std::uint64_t{width} * height;
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
    View view;
    view.render_options.resolution = scene.render.resolution;
    view.render_options.background = scene.render.background;
    if (camera != scene.cameras.end()) {
        view.camera = *camera;
        view.render_options.resolution =
            camera->resolution.value_or(view.render_options.resolution);
        view.render_options.background =
            camera->background.value_or(view.render_options.background);
    }
    view.render_options.resolution = options.size.value_or(view.render_options.resolution);
    view.render_options.crop = options.crop;
    view.render_options.thread_count = options.thread_count;
    if (auto failure = check_size(view, options)) return *failure;
    if (camera == scene.cameras.end()) {
        view.camera = render::fit_camera(finite_bounds(world), view.render_options.resolution);
    }
    return view;
}

}  // namespace lray::cli
