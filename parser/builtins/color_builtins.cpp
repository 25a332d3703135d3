// Functions that make colours. Colours are linear; what displays show is decoded.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "image/srgb.h"
#include "parser/builtins/blackbody.h"
#include "parser/builtins/blend.h"
#include "parser/builtins/families.h"
#include "parser/builtins/results.h"

namespace lray::parser {

namespace {

Value color_rgb(Call& call) {
    return of_rgb(call, call.number(0), call.number(1), call.number(2));
}
Value color_srgb(Call& call) {
    return of_rgb(call, image::srgb_decode(call.number(0)), image::srgb_decode(call.number(1)),
                  image::srgb_decode(call.number(2)));
}
Value color_gray(Call& call) {
    return of_rgb(call, call.number(0), call.number(0), call.number(0));
}

/// One channel of a hue in degrees: a trapezoid, 1 within 60 degrees of its own hue.
double hue_channel(double hue, double own) {
    const double away = std::fabs(std::remainder(hue - own, 360.0));
    return std::clamp(2.0 - away / 60.0, 0.0, 1.0);
}

Value of_display(Call& call, double lo, double hi, double hue) {
    const auto channel = [&](double own) {
        return image::srgb_decode(lo + (hi - lo) * hue_channel(hue, own));
    };
    return of_rgb(call, channel(0.0), channel(120.0), channel(240.0));
}

Value color_hsv(Call& call) {
    const double saturation = std::clamp(call.number(1), 0.0, 1.0);
    const double value = std::clamp(call.number(2), 0.0, 1.0);
    return of_display(call, value * (1.0 - saturation), value, call.number(0));
}

Value color_hsl(Call& call) {
    const double saturation = std::clamp(call.number(1), 0.0, 1.0);
    const double lightness = std::clamp(call.number(2), 0.0, 1.0);
    const double reach = saturation * std::min(lightness, 1.0 - lightness);
    return of_display(call, lightness - reach, lightness + reach, call.number(0));
}

Value color_kelvin(Call& call) {
    const double kelvin = call.number(0);
    if (kelvin < kCoolestBlackbody || kelvin > kHottestBlackbody) {
        call.diagnostics.error(
            Code::E0304, call.spans[0],
            fmt::format("`kelvin` takes {} to {} K, this is {}", format_number(kCoolestBlackbody),
                        format_number(kHottestBlackbody), format_number(kelvin)));
        return Value::poison();
    }
    constexpr std::uint64_t kCost = 100;  // wavelengths
    if (!take_steps(call, kCost)) return Value::poison();
    const DVec3 color = blackbody_color(kelvin);
    return of_rgb(call, color.x, color.y, color.z);
}

Value color_mix(Call& call) {
    return blend(call, call[0], call[1], call.number(2));
}

using enum ParameterType;

// clang-format off
constexpr std::array kBuiltins = {
    Builtin{"rgb", {{{"r", number}, {"g", number}, {"b", number}}}, color_rgb, "a colour, linear"},
    Builtin{"srgb", {{{"r", number}, {"g", number}, {"b", number}}}, color_srgb, "a colour as displays show it, 0 to 1"},
    Builtin{"gray", {{{"value", number}}}, color_gray, "a grey, linear"},
    Builtin{"hsv", {{{"hue", number}, {"saturation", number}, {"value", number}}}, color_hsv, "a colour by hue in degrees"},
    Builtin{"hsl", {{{"hue", number}, {"saturation", number}, {"lightness", number}}}, color_hsl, "a colour by hue in degrees"},
    Builtin{"kelvin", {{{"temperature", number}}}, color_kelvin, "the colour of a glowing body of 1000 to 40000 K, its largest component 1"},
    Builtin{"mix", {{{"a", blendable}, {"b", blendable}, {"t", number}}}, color_mix, "a at t = 0, b at t = 1, beyond them outside of 0 to 1; of numbers, vectors or colours"},
};
// clang-format on

}  // namespace

std::span<const Builtin> color_builtins() {
    return kBuiltins;
}

}  // namespace lray::parser
