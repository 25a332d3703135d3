#include "shade/textures/code_values.h"

#include <algorithm>

#include "image/srgb.h"

namespace lray::shade {

namespace {

constexpr float kParts = 4096.0f;

CodeValues make_values(bool is_srgb) {
    CodeValues values;
    const auto decoded = [&](double code) {
        const double share = code / 255.0;
        return static_cast<float>(is_srgb ? image::srgb_decode(share) : share);
    };
    for (std::size_t code = 0; code < values.linear.size(); ++code) {
        values.linear[code] = decoded(static_cast<double>(code));
    }
    for (std::size_t code = 0; code < values.borders.size(); ++code) {
        values.borders[code] = decoded(static_cast<double>(code) + 0.5);
    }
    for (std::size_t part = 0; part < values.first_code.size(); ++part) {
        const float begin = static_cast<float>(part) / kParts;
        const auto border = std::upper_bound(values.borders.begin(), values.borders.end(), begin);
        values.first_code[part] = static_cast<std::uint8_t>(border - values.borders.begin());
    }
    return values;
}

}  // namespace

std::uint8_t CodeValues::nearest_code(float value) const {
    if (!(value > 0.0f)) return 0;
    const float inside = std::min(value, 1.0f);
    std::uint8_t code = first_code[static_cast<std::size_t>(inside * kParts)];
    if (code < borders.size() && inside >= borders[code]) ++code;
    return code;
}

const CodeValues& code_values(bool is_srgb) {
    static const CodeValues srgb = make_values(true);
    static const CodeValues data = make_values(false);
    return is_srgb ? srgb : data;
}

}  // namespace lray::shade
