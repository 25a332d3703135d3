// Only + - * /, so that a screen shows the same bits on every processor.
#include "image/tone_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/assert.h"
#include "image/srgb.h"

namespace lray::image {

namespace {

// Source: Narkowicz 2015, "ACES Filmic Tone Mapping Curve": (x (a x + b)) / (x (c x + d) + e). It
// crosses 1 near 7.2 and tends to a / c = 1.033, which is clamped.
constexpr double kA = 2.51;
constexpr double kB = 0.03;
constexpr double kC = 2.43;
constexpr double kD = 0.59;
constexpr double kE = 0.14;

/// Beyond this the curve is flat to the last bit of a float, and its squares stay finite.
constexpr double kMaxLight = 1e30;

}  // namespace

double exposure_factor(double stops) {
    LRAY_ASSERT(std::fabs(stops) <= 1000.0);
    const double whole = std::nearbyint(stops);
    const double x = (stops - whole) * std::numbers::ln2;  // |x| <= 0.3466
    // Taylor's series of e^x from its far end: the first term left out, x^15 / 15!, is below 1e-19.
    double power = 1.0;
    for (int k = 14; k >= 1; --k) power = 1.0 + power * x / k;
    return std::ldexp(power, static_cast<int>(whole));
}

Display::Display(const DisplaySettings& settings)
    : settings_(settings), factor_(exposure_factor(settings.exposure)) {}

double Display::curve(double x) const {
    switch (settings_.tonemap) {
        case ToneMap::none:
            return x;
        case ToneMap::reinhard:
            // Source: Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images",
            // eq. 3, for each channel.
            return x / (1.0 + x);
        case ToneMap::aces:
            return (x * (kA * x + kB)) / (x * (kC * x + kD) + kE);
    }
    LRAY_ASSERT(false);
}

double Display::curve_slope(double x) const {
    switch (settings_.tonemap) {
        case ToneMap::none:
            return 1.0;
        case ToneMap::reinhard:
            return 1.0 / ((1.0 + x) * (1.0 + x));
        case ToneMap::aces: {
            const double below = x * (kC * x + kD) + kE;
            const double above = x * (kA * x + kB);
            return ((2.0 * kA * x + kB) * below - above * (2.0 * kC * x + kD)) / (below * below);
        }
    }
    LRAY_ASSERT(false);
}

Color Display::shown(Color light) const {
    if (is_identity()) return light;
    Color result{0.0f};
    for (int channel = 0; channel < 3; ++channel) {
        // The curves are made for what is not negative.
        const double x = std::clamp(static_cast<double>(light[channel]) * factor_, 0.0, kMaxLight);
        result[channel] = static_cast<float>(curve(x));
    }
    return result;
}

double Display::displayed_error(double mean, double standard_error) const {
    const double x = std::min(mean * factor_, kMaxLight);
    const double light_error = standard_error * factor_;
    const double value = curve(std::max(x, 0.0));
    const double error = light_error * curve_slope(std::max(x, 0.0));
    const double beyond = x < 0.0 ? -x : std::max(value - 1.0, 0.0);
    const double back = std::max(error - beyond, 0.0);
    if (settings_.gamma == Gamma::linear) return back;
    return back * static_cast<double>(srgb_slope(static_cast<float>(std::min(value, 1.0))));
}

Image displayed(Image picture, const DisplaySettings& settings) {
    const Display display(settings);
    if (display.is_identity()) return picture;
    for (Color& pixel : picture.pixels) pixel = display.shown(pixel);
    return picture;
}

}  // namespace lray::image
