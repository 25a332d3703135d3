// What the 8-bit codes of pictures stand for, and the code that is nearest to a value.
#pragma once

#include <array>
#include <cstdint>

namespace lray::shade {

struct CodeValues {
    std::array<float, 256> linear{};  // of each code; rising

    /// Returns the code that stands for the value or, between two, that on its side of where the
    /// code and a half lies. NaN is 0.
    std::uint8_t nearest_code(float value) const;

    /// Of codes and a half: where the next code begins.
    std::array<float, 255> borders{};
    /// The code at the beginning of each of equal parts of [0, 1], of which none holds two borders.
    std::array<std::uint8_t, 4097> first_code{};
};

/// Returns the values of sRGB codes, or of codes that are shares of 255.
const CodeValues& code_values(bool is_srgb);

}  // namespace lray::shade
