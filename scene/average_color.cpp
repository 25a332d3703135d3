#include "scene/average_color.h"

#include "base/assert.h"

namespace lray::scene {

namespace {

Color middle(Color a, Color b) {
    return Color{0.5 * (DVec3{a} + DVec3{b})};
}

/// The mean over [from, to] of what the stops say, constant outside of them.
Color mean_of(std::span<const ColorStop> stops, double from, double to) {
    LRAY_ASSERT(!stops.empty());
    // Ends that coincide leave no length to average over, and only a hard edge.
    if (!(to > from)) return middle(stops.front().color, stops.back().color);
    DVec3 sum = (stops.front().at - from) * DVec3{stops.front().color} +
                (to - stops.back().at) * DVec3{stops.back().color};
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const DVec3 colors = DVec3{stops[i - 1].color} + DVec3{stops[i].color};
        sum += 0.5 * (stops[i].at - stops[i - 1].at) * colors;
    }
    return Color{sum / (to - from)};
}

struct Averager {
    std::span<const Picture> pictures;

    Color operator()(const ImageTexture& image) const {
        const Picture& picture = pictures[image.picture_id.index()];
        return image.is_srgb ? picture.srgb_mean : picture.linear_mean;
    }
    Color operator()(const CheckerTexture& checker) const { return middle(checker.a, checker.b); }
    Color operator()(const StripesTexture& stripes) const { return middle(stripes.a, stripes.b); }
    Color operator()(const GradientTexture& gradient) const {
        return mean_of(gradient.stops, 0.0, 1.0);
    }
    Color operator()(const RampTexture& ramp) const {
        return mean_of(ramp.stops, ramp.stops.front().at, ramp.stops.back().at);
    }
    Color operator()(const NoiseTexture& noise) const { return mean_of(noise.stops, 0.0, 1.0); }
    Color operator()(const MarbleTexture& marble) const { return middle(marble.a, marble.b); }
    Color operator()(const WoodTexture& wood) const { return middle(wood.a, wood.b); }
};

}  // namespace

Color average_color(const TexturePattern& pattern, std::span<const Picture> pictures) {
    return std::visit(Averager{pictures}, pattern);
}

}  // namespace lray::scene
