#include "parser/builtins/blackbody.h"

#include <algorithm>
#include <cmath>

namespace lray::parser {

namespace {

/// A bell curve that falls off differently to both sides.
double lobe(double nanometres, double center, double width_below, double width_above) {
    const double x = (nanometres - center) / (nanometres < center ? width_below : width_above);
    return std::exp(-0.5 * x * x);
}

/// The colour-matching functions of the CIE 1931 standard observer, xyz.
/// Source: Wyman, Sloan, Shirley 2013, "Simple Analytic Approximations to the CIE XYZ Color
/// Matching Functions", JCGT 2(2), table 1, multi-lobe fit.
DVec3 matching_functions(double nm) {
    return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
                0.065 * lobe(nm, 501.1, 20.4, 26.2),
            0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
            1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

/// Spectral radiance by Planck's law, up to a factor.
double radiance(double nanometres, double kelvin) {
    constexpr double kSecondConstant = 1.438776877e7;  // h c / k in nm K, CODATA 2018
    const double x = nanometres / 560.0;               // a factor that keeps the powers near 1
    return 1.0 / (x * x * x * x * x * std::expm1(kSecondConstant / (nanometres * kelvin)));
}

}  // namespace

DVec3 blackbody_color(double kelvin) {
    DVec3 xyz{0.0};
    constexpr int kFirst = 360;  // nanometres
    constexpr int kLast = 830;
    constexpr int kStep = 5;
    for (int nm = kFirst; nm <= kLast; nm += kStep) {
        xyz += matching_functions(nm) * radiance(nm, kelvin);
    }
    // Linear sRGB of XYZ. Source: IEC 61966-2-1:1999, section 5.
    const DVec3 rgb{3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z,
                    -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
                    0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z};
    const double largest = std::max({rgb.x, rgb.y, rgb.z});
    return {std::max(rgb.x / largest, 0.0), std::max(rgb.y / largest, 0.0),
            std::max(rgb.z / largest, 0.0)};
}

}  // namespace lray::parser
