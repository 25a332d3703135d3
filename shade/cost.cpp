#include "shade/cost.h"

#include <array>
#include <bit>

namespace lray::shade {

namespace {

// clang-format off
constexpr std::array<Color, 8> kScale{{
    {0.0f, 0.0f, 0.1f}, {0.0f, 0.0f, 0.6f}, {0.0f, 0.5f, 0.7f}, {0.0f, 0.6f, 0.0f},
    {0.9f, 0.8f, 0.0f}, {1.0f, 0.3f, 0.0f}, {0.7f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f},
}};
// clang-format on
constexpr double kDoublingsPerColor = 2.0;

/// The logarithm to the base 2, linear between powers of two: exact operations only, so that it is
/// the same on every processor. Shape: tests > 0.
double doublings(std::uint64_t tests) {
    const auto exponent = static_cast<int>(std::bit_width(tests)) - 1;
    const double power = static_cast<double>(std::uint64_t{1} << exponent);
    return exponent + (static_cast<double>(tests) / power - 1.0);
}

}  // namespace

std::uint64_t test_count(const bvh::TraceCounts& counts) {
    return counts.node_tests + counts.primitive_tests + counts.instance_tests;
}

Color cost_color(std::uint64_t tests) {
    if (tests == 0) return Color{0.0f};
    const double place = doublings(tests) / kDoublingsPerColor;
    const auto step = static_cast<std::size_t>(place);
    if (step + 1 >= kScale.size()) return kScale.back();
    const float share = static_cast<float>(place - static_cast<double>(step));
    return (1.0f - share) * kScale[step] + share * kScale[step + 1];
}

}  // namespace lray::shade
