#include "tests/shade/chi_square.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "tests/support/random.h"

namespace lray::test {

namespace {

constexpr std::size_t kBinsZ = 24;
constexpr std::size_t kBinsTurn = 32;
constexpr std::size_t kSamples = 200'000;
constexpr double kLeastExpected = 8.0;  // bins with less are one bin

Vec3 direction_at(double z, double turn) {
    const double sine = std::sqrt(std::max(1.0 - z * z, 0.0));
    const double angle = 2.0 * std::numbers::pi * turn;
    return {sine * std::cos(angle), sine * std::sin(angle), z};
}

}  // namespace

double chi_square_probability(const DirectionSampler& sampler, const DirectionDensity& density,
                              std::uint64_t seed, const SphereWindow& window) {
    const double extent = window.high_z - window.low_z;
    std::vector<double> expected;
    double inside = 0.0;
    const auto side = static_cast<std::size_t>(window.points_per_side);
    const double points = window.points_per_side;
    for (std::size_t i = 0; i < kBinsZ; ++i) {
        for (std::size_t j = 0; j < kBinsTurn; ++j) {
            double sum = 0.0;
            for (std::size_t k = 0; k < side * side; ++k) {
                const double a = (static_cast<double>(k / side) + 0.5) / points;
                const double b = (static_cast<double>(k % side) + 0.5) / points;
                const double z = window.low_z + extent * (static_cast<double>(i) + a) / kBinsZ;
                sum += density(direction_at(z, (static_cast<double>(j) + b) / kBinsTurn));
            }
            const double bin_solid_angle =
                2.0 * std::numbers::pi * extent / static_cast<double>(kBinsZ * kBinsTurn);
            const double probability = sum / (points * points) * bin_solid_angle;
            inside += probability;
            expected.push_back(probability * kSamples);
        }
    }
    std::vector<double> found(expected.size(), 0.0);
    double found_outside = 0.0;
    Random random(seed);
    for (std::size_t i = 0; i < kSamples; ++i) {
        const double choice = random.uniform();
        const double u = random.uniform();
        const std::optional<Vec3> wi = sampler(choice, {u, random.uniform()});
        const double place = wi ? (static_cast<double>(wi->z) - window.low_z) / extent : -1.0;
        if (!(place >= 0.0 && place < 1.0)) {
            found_outside += 1.0;
            continue;
        }
        const double turn = std::atan2(wi->y, wi->x) / (2.0 * std::numbers::pi);
        const double around = std::min(turn < 0.0 ? turn + 1.0 : turn, 0x1.fffffffffffffp-1);
        found[static_cast<std::size_t>(place * kBinsZ) * kBinsTurn +
              static_cast<std::size_t>(around * kBinsTurn)] += 1.0;
    }
    double rest_expected = std::max(1.0 - inside, 0.0) * kSamples;
    double rest_found = found_outside;
    double statistic = 0.0;
    double degrees = 0.0;
    const auto add = [&](double seen, double wanted) {
        statistic += (seen - wanted) * (seen - wanted) / wanted;
        degrees += 1.0;
    };
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] >= kLeastExpected) {
            add(found[i], expected[i]);
        } else {
            rest_expected += expected[i];
            rest_found += found[i];
        }
    }
    if (rest_expected >= kLeastExpected) {
        add(rest_found, rest_expected);
    } else if (rest_found > 8.0 * kLeastExpected) {
        return 0.0;  // where hardly any should be
    }
    degrees -= 1.0;
    if (degrees < 1.0) return 0.0;
    const double spread = 2.0 / (9.0 * degrees);
    const double normal = (std::cbrt(statistic / degrees) - (1.0 - spread)) / std::sqrt(spread);
    return 0.5 * std::erfc(normal / std::numbers::sqrt2);
}

}  // namespace lray::test
