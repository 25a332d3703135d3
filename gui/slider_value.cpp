#include "gui/slider_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace lray::gui {

namespace {

constexpr double kSteps = 50.0;            // of the whole range
constexpr double kDistinctValues = 200.0;  // at least so many lie in a range

bool is_whole(const Slider& slider) {
    return slider.is_whole || !slider.choices.empty();
}

/// A part of the range; the range itself may be more than a double holds.
double part_of_range(const Slider& slider, double parts) {
    return slider.greatest / parts - slider.least / parts;
}

/// The value that a decimal text is, or `otherwise` if it is more than a double holds.
double parsed(const std::string& text, double otherwise = 0.0) {
    double value = otherwise;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value + 0.0;  // no negative zero
}

/// The nearest multiple of a power of ten: by way of its text, which makes it the double nearest
/// to a short decimal.
double rounded(double value, int power_of_ten) {
    if (power_of_ten <= 0) return parsed(fmt::format("{:.{}f}", value, -power_of_ten), value);
    const std::string unit = fmt::format("1e{}", power_of_ten);
    return parsed(fmt::format("{:.0f}e{}", value / parsed(unit), power_of_ten), value);
}

int floor_of_log10(double x) {
    return static_cast<int>(std::floor(std::log10(x)));
}

/// The value rounded to what is worth telling apart in its range; the ends are values whatever
/// their digits.
double tidy(const Slider& slider, double value) {
    const double finest = part_of_range(slider, kDistinctValues);
    if (!(finest > 0.0)) return slider.least;
    int power_of_ten = floor_of_log10(finest);
    double least = slider.least;
    double greatest = slider.greatest;
    if (is_whole(slider)) {
        power_of_ten = std::max(power_of_ten, 0);
        least = std::min(std::ceil(least), greatest);
        greatest = std::max(std::floor(greatest), least);
    }
    if (value <= least) return least;
    if (value >= greatest) return greatest;
    return std::clamp(rounded(value, power_of_ten), least, greatest);
}

/// The greatest of 1, 2 and 5 times a power of ten that is not greater than x.
double round_number(double x) {
    const int power_of_ten = floor_of_log10(x);
    const double unit = parsed(fmt::format("1e{}", power_of_ten));
    for (const int digit : {5, 2}) {
        if (x >= digit * unit) return parsed(fmt::format("{}e{}", digit, power_of_ten));
    }
    return unit;
}

}  // namespace

Slider in_order(Slider slider) {
    if (!slider.choices.empty()) {
        slider.least = 0.0;
        slider.greatest = static_cast<double>(slider.choices.size() - 1);
    }
    if (!std::isfinite(slider.least)) slider.least = 0.0;
    if (!(slider.greatest >= slider.least && std::isfinite(slider.greatest))) {
        slider.greatest = slider.least;
    }
    if (std::isnan(slider.value)) slider.value = slider.least;
    slider.value = std::clamp(slider.value, slider.least, slider.greatest);
    return slider;
}

double fraction_of(const Slider& slider) {
    const double half_range = part_of_range(slider, 2.0);
    if (!(half_range > 0.0)) return 0.0;
    return std::clamp((slider.value / 2.0 - slider.least / 2.0) / half_range, 0.0, 1.0);
}

double value_at(const Slider& slider, double fraction) {
    const double t = std::clamp(fraction, 0.0, 1.0);
    if (t == 0.0) return tidy(slider, slider.least);
    if (t == 1.0) return tidy(slider, slider.greatest);
    return tidy(slider, slider.least * (1.0 - t) + slider.greatest * t);
}

double stepped_value(const Slider& slider, int direction) {
    const double about = part_of_range(slider, kSteps);
    if (!(about > 0.0)) return slider.least;
    double step = round_number(about);
    if (is_whole(slider)) step = std::max(step, 1.0);
    const double moved = std::clamp(slider.value + direction * step, slider.least, slider.greatest);
    return tidy(slider, moved);
}

std::string value_text(const Slider& slider) {
    if (!slider.choices.empty()) {
        const double last = static_cast<double>(slider.choices.size() - 1);
        const double index = std::clamp(std::round(slider.value), 0.0, last);
        return slider.choices[static_cast<std::size_t>(index)];
    }
    return fmt::format("{}", slider.value + 0.0);
}

}  // namespace lray::gui
