// The transfer functions. Of libm only powf is used: unlike pow in double precision, it was found
// to give the same bits whether the processor fuses multiply-add or not.
#include "image/srgb.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "base/assert.h"
#include "base/numerics.h"

namespace lray::image {

namespace {

/// Returns x^2.4 for x in (0, 1] as x^2 times the fifth root of x^2: Newton's method for
/// y^5 = x^2, begun at float precision (1e-7); each step squares the error, so two are enough.
double power_2_4(double x) {
    const double square = x * x;
    double y = static_cast<double>(std::pow(static_cast<float>(x), 0.4f));
    for (int step = 0; step < 2; ++step) {
        const double y4 = (y * y) * (y * y);
        y -= (y4 * y - square) / (5.0 * y4);
    }
    return square * y;
}

/// Returns x^(1/2.4) for x in (0.003, 1]: Newton's method for y^12 = x^5, begun at float precision;
/// a step leaves about 12 times the square of that error.
double root_2_4(double x) {
    const double square = x * x;
    const double power = square * square * x;
    double y = static_cast<double>(std::pow(static_cast<float>(x), 1.0f / 2.4f));
    const double y3 = y * y * y;
    const double y11 = y3 * y3 * y3 * (y * y);
    y -= (y11 * y - power) / (12.0 * y11);
    return y;
}

std::vector<float> make_decode_table_16() {
    std::vector<float> table(65536);
    for (std::size_t code = 0; code < table.size(); ++code) {
        table[code] = static_cast<float>(srgb_decode(static_cast<double>(code) / 65535.0));
    }
    return table;
}

std::array<float, 256> make_decode_table() {
    std::array<float, 256> table{};
    for (std::size_t code = 0; code < table.size(); ++code) {
        table[code] = static_cast<float>(srgb_decode(static_cast<double>(code) / 255.0));
    }
    return table;
}

/// Which code a linear value in (0, 1) has, without a power for each: a step for the upper 16 bits
/// of the float, in which there is one code or two.
class CodeTable {
 public:
    CodeTable() {
        for (std::uint32_t code = 1; code < 256; ++code) first_[code] = first_with_code(code);
        first_[256] = kInfinity;
        std::uint32_t code = 0;
        for (std::uint32_t step = 0; step < kStepCount; ++step) {
            while (first_[code + 1] <= value_of(step)) ++code;
            code_of_step_[step] = static_cast<std::uint8_t>(code);
            LRAY_ASSERT(code == 255 || !(first_[code + 2] < value_of(step + 1)));
        }
    }

    /// Shape: 0 < x <= 1.
    std::uint8_t code_of(float x) const {
        if (x < kLeast) return 0;
        const std::uint32_t step = (std::bit_cast<std::uint32_t>(x) >> 16) - kFirstStep;
        const std::uint32_t code = code_of_step_[step];
        return static_cast<std::uint8_t>(code + (x >= first_[code + 1] ? 1 : 0));
    }

 private:
    static constexpr float kLeast = 0x1p-13f;  // of less the code is 0
    static constexpr std::uint32_t kFirstStep = std::bit_cast<std::uint32_t>(kLeast) >> 16;
    static constexpr std::uint32_t kStepCount =
        (std::bit_cast<std::uint32_t>(1.0f) >> 16) - kFirstStep + 1;

    static float value_of(std::uint32_t step) {
        return std::bit_cast<float>((step + kFirstStep) << 16);
    }

    /// Between two bits of a float.
    static float first_with_code(std::uint32_t code) {
        std::uint32_t below = std::bit_cast<std::uint32_t>(kLeast);
        std::uint32_t at = std::bit_cast<std::uint32_t>(1.0f);
        while (at - below > 1) {
            const std::uint32_t middle = below + (at - below) / 2;
            const float encoded = srgb_encode(std::bit_cast<float>(middle)) * 255.0f + 0.5f;
            (static_cast<std::uint32_t>(encoded) >= code ? at : below) = middle;
        }
        return std::bit_cast<float>(at);
    }

    std::array<float, 257> first_{};  // the least value of each code
    std::array<std::uint8_t, kStepCount> code_of_step_{};
};

}  // namespace

float srgb_encode(float linear) {
    if (!(linear > 0.0f)) return 0.0f;
    if (linear >= 1.0f) return 1.0f;
    if (linear <= 0.0031308f) return 12.92f * linear;
    return 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float srgb_slope(float linear) {
    if (!(linear > 0.0031308f)) return 12.92f;
    const float x = std::min(linear, 1.0f);
    return 1.055f / 2.4f * std::pow(x, 1.0f / 2.4f) / x;
}

std::uint8_t linear_encode_8(float linear) {
    if (!(linear > 0.0f)) return 0;
    return static_cast<std::uint8_t>(std::min(linear, 1.0f) * 255.0f + 0.5f);
}

std::uint16_t srgb_encode_16(float linear) {
    if (!(linear > 0.0f)) return 0;
    if (linear >= 1.0f) return 65535;
    const double x{linear};
    const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * root_2_4(x) - 0.055;
    return static_cast<std::uint16_t>(encoded * 65535.0 + 0.5);
}

std::uint16_t linear_encode_16(float linear) {
    if (!(linear > 0.0f)) return 0;
    return static_cast<std::uint16_t>(std::min(double{linear}, 1.0) * 65535.0 + 0.5);
}

double srgb_decode(double encoded) {
    if (!(encoded > 0.0)) return 0.0;
    if (encoded >= 1.0) return 1.0;
    if (encoded <= 0.04045) return encoded / 12.92;
    return power_2_4((encoded + 0.055) / 1.055);
}

std::uint8_t srgb_encode_8(float linear) {
    static const CodeTable table;
    if (!(linear > 0.0f)) return 0;
    return table.code_of(std::min(linear, 1.0f));
}

float srgb_decode_8(std::uint8_t code) {
    static const std::array<float, 256> table = make_decode_table();
    return table[code];
}

float srgb_decode_16(std::uint16_t code) {
    static const std::vector<float> table = make_decode_table_16();
    return table[code];
}

void encode_row_16(std::span<const Color> pixels, Gamma gamma, std::span<std::uint8_t> bytes) {
    const auto encode = gamma == Gamma::srgb ? srgb_encode_16 : linear_encode_16;
    LRAY_ASSERT(bytes.size() == 6 * pixels.size());
    Color last{0.0f};
    std::array<std::uint8_t, 6> code{};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (pixels[i] != last) {
            last = pixels[i];
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const std::uint16_t number = encode(last[static_cast<int>(channel)]);
                code[2 * channel] = static_cast<std::uint8_t>(number >> 8);
                code[2 * channel + 1] = static_cast<std::uint8_t>(number & 0xff);
            }
        }
        std::copy(code.begin(), code.end(), bytes.begin() + static_cast<std::ptrdiff_t>(6 * i));
    }
}

void encode_row(std::span<const Color> pixels, Gamma gamma, std::span<std::uint8_t> bytes) {
    const auto encode = gamma == Gamma::srgb ? srgb_encode_8 : linear_encode_8;
    LRAY_ASSERT(bytes.size() == 3 * pixels.size());
    // Neighbours are often alike (background, flat painting): a run is encoded once.
    Color last{0.0f};
    std::array<std::uint8_t, 3> code{};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (pixels[i] != last) {
            last = pixels[i];
            code = {encode(last.r), encode(last.g), encode(last.b)};
        }
        bytes[3 * i] = code[0];
        bytes[3 * i + 1] = code[1];
        bytes[3 * i + 2] = code[2];
    }
}

void srgb_decode_row(std::span<const std::uint8_t> bytes, std::span<Color> pixels) {
    LRAY_ASSERT(bytes.size() == 3 * pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels[i] = {srgb_decode_8(bytes[3 * i]), srgb_decode_8(bytes[3 * i + 1]),
                     srgb_decode_8(bytes[3 * i + 2])};
    }
}

}  // namespace lray::image
