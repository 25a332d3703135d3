#include "cli/picture_identity.h"

#include <fmt/format.h>

#include "base/content_hash.h"
#include "parser/tools/camera_text.h"
#include "parser/tools/dump.h"

namespace lray::cli {

namespace {

/// A color as numbers that are read back to the same bits.
std::string exact(const Color& color) {
    return fmt::format("{} {} {}", color.r, color.g, color.b);
}

template <class Enum>
std::string number_of(Enum value) {
    return fmt::to_string(static_cast<int>(value));
}

std::string_view name_of(SamplerKind sampler) {
    return sampler == SamplerKind::sobol ? "sobol" : "random";
}

std::string text_of(const shade::Settings& shading) {
    return fmt::format("{}, background {}, integrator {}, ambient {}, depth {}, shadows {}",
                       number_of(shading.shader), exact(shading.background),
                       number_of(shading.integrator), exact(shading.ambient), shading.max_depth,
                       shading.transparent_shadows);
}

}  // namespace

render::PictureIdentity picture_identity(const scene::Scene& scene, const ContentHash& files,
                                         const View& view, const Options& options) {
    ContentHash contents;
    parser::dump_contents(scene, [&](std::string_view text) { contents.add(text); });
    const render::RenderOptions& render = view.render_options;
    const auto [width, height] = render.resolution;
    const render::PixelRect crop = render.crop.value_or(render::PixelRect{0, 0, width, height});
    render::PictureIdentity identity{
        {"the version of lray", LRAY_VERSION},
        {"what is in the scene", contents.text()},
        {"the meshes and pictures of the scene", files.text()},
        {"the camera", parser::camera_text(view.camera, parser::CameraDetail::all)},
        {"size", fmt::format("{}x{}", width, height)},
        {"the crop", fmt::format("{},{},{},{}", crop.x0, crop.y0, crop.x1, crop.y1)},
        {"what is shown, or the settings of light", text_of(render.shading)},
        {"the place of rays in their pixels",
         render.position == render::PixelPosition::center ? "center" : "random"},
        {"the sampler", std::string(name_of(render.sampler))},
        {"the seed", fmt::to_string(render.seed)},
    };
    if (render.shading.shader == shade::Shader::cost) {
        const auto quality = options.quality.value_or(bvh::BuildQuality::medium);
        identity.emplace_back("the hierarchy", number_of(*options.accel) + number_of(quality));
    }
    if (render.limits.noise) {
        // Which pixels get more samples follows from how they are displayed.
        identity.emplace_back(
            "the limit of noise, or the display",
            fmt::format("{} {} {} {}", *render.limits.noise, render.display.exposure,
                        number_of(render.display.tonemap), number_of(render.display.gamma)));
    }
    return identity;
}

}  // namespace lray::cli
