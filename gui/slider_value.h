// The value of one slider: where it lies in its range, and the numbers it takes, which are short in
// decimal, so that their text is exact.
#pragma once

#include <string>
#include <vector>

namespace lray::gui {

/// Shape: least <= value <= greatest, finite.
struct Slider {
    std::string name{};
    double value = 0.0;
    double least = 0.0;
    double greatest = 1.0;
    bool is_whole = false;
    /// If not empty, the value is the index of one of them, and the range that of the indices.
    std::vector<std::string> choices{};
};

/// Returns the slider with its range in order and its value in it.
Slider in_order(Slider slider);

/// Returns where the value lies in its range, in [0, 1]; 0 if there is but one value.
double fraction_of(const Slider& slider);

/// Returns the value next to that part of the range: of few digits, no finer than can be seen.
double value_at(const Slider& slider, double fraction);

/// Returns the value a fiftieth of the range up or down, or about that: by a round number, and one
/// choice or whole number at least. It ends at the ends of the range.
double stepped_value(const Slider& slider, int direction);

/// Returns the value as it is shown and as `-D name=...` takes it: the shortest text that is
/// exactly it.
std::string value_text(const Slider& slider);

}  // namespace lray::gui
