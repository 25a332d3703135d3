#include "scene/average_color.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "base/noise.h"
#include "scene/vein_profiles.h"

namespace lray::scene {

namespace {

Color middle(Color a, Color b) {
    return Color{0.5 * (DVec3{a} + DVec3{b})};
}

Color blend(Color a, Color b, double share) {
    return Color{(1.0 - share) * DVec3{a} + share * DVec3{b}};
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

DVec3 color_at(std::span<const ColorStop> stops, double place) {
    const auto next = std::upper_bound(stops.begin(), stops.end(), place,
                                       [](double at, const ColorStop& s) { return at < s.at; });
    if (next == stops.begin()) return DVec3{next->color};
    if (next == stops.end()) return DVec3{stops.back().color};
    const ColorStop& stop = next[-1];
    const double share = (place - stop.at) / (next->at - stop.at);
    return (1.0 - share) * DVec3{stop.color} + share * DVec3{next->color};
}

/// The distribution of the sum of four even ones from -1/2 to 1/2: a bell on [-2, 2] with the
/// variance 1/3. Sums of octaves of noise are spread much like it.
double bell(double x) {
    const double near = 2.0 - std::fabs(x);
    const double far = std::max(1.0 - std::fabs(x), 0.0);
    return (near * near * near - 4.0 * far * far * far) / 6.0;
}

/// The mean of what the stops say over the values that the noise takes.
Color noise_mean(const NoiseTexture& noise) {
    double weights = 0.0;
    double squares = 0.0;
    double weight = 1.0;
    for (std::uint32_t i = 0; i < noise.octaves; ++i, weight *= noise.gain) {
        weights += weight;
        squares += weight * weight;
    }
    const double variance = kNoiseVariance * squares / (weights * weights);
    const double scale = 0.5 * std::sqrt(3.0 * variance);  // of the bell; noise is mapped by 1/2
    constexpr int kSteps = 256;
    DVec3 sum{0.0};
    double bells = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double x = -2.0 + (i + 0.5) * (4.0 / kSteps);
        sum += bell(x) * color_at(noise.stops, 0.5 + scale * x);
        bells += bell(x);
    }
    return Color{sum / bells};
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
    Color operator()(const NoiseTexture& noise) const { return noise_mean(noise); }
    Color operator()(const MarbleTexture& marble) const {
        return blend(marble.a, marble.b, MarbleProfile::integral(1.0));
    }
    Color operator()(const WoodTexture& wood) const {
        return blend(wood.a, wood.b, WoodProfile::integral(1.0));
    }
    Color operator()(const VertexColorsTexture&) const { return Color{1.0f}; }
};

}  // namespace

Color average_color(const TexturePattern& pattern, std::span<const Picture> pictures) {
    return std::visit(Averager{pictures}, pattern);
}

}  // namespace lray::scene
