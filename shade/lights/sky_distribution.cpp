#include "shade/lights/sky_distribution.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/assert.h"
#include "base/portable_math.h"

namespace lray::shade {

namespace {

/// What each cell gets beside its own brightness, of the mean: what is finer than a cell may shine
/// in a cell that is dark on average.
constexpr double kEvenShare = 0.05;

/// Returns the part [sums[i], sums[i + 1]) that u lies in. Shape: sums rises from 0 to 1.
template <class Float>
std::uint32_t part_of(std::span<const Float> sums, double u) {
    const auto next = std::upper_bound(sums.begin() + 1, sums.end() - 1, u,
                                       [](double x, Float sum) { return x < double{sum}; });
    return static_cast<std::uint32_t>(next - sums.begin() - 1);
}

}  // namespace

SkyDistribution::SkyDistribution(std::uint32_t width, std::uint32_t height,
                                 std::span<const float> brightness)
    : width_(width) {
    LRAY_ASSERT(width > 0 && height > 0 && brightness.size() == std::size_t{width} * height);
    latitudes_.reserve(height + 1);
    for (std::uint32_t row = 0; row <= height; ++row) {
        // sin(latitude) = -cos(half a turn times row / height)
        latitudes_.push_back(-unit_circle_point(0.5 * row / height).x);
    }
    std::vector<double> row_weights;
    double total = 0.0;
    for (std::uint32_t row = 0; row < height; ++row) {
        double sum = 0.0;
        for (std::uint32_t column = 0; column < width; ++column) {
            sum += double{brightness[std::size_t{row} * width + column]};
        }
        row_weights.push_back(sum * (latitudes_[row + 1] - latitudes_[row]));
        total += row_weights.back();
    }
    LRAY_ASSERT(total > 0.0);
    const double even = kEvenShare * total / (2.0 * width);  // of a cell: the latitudes span 2
    const double all = total * (1.0 + kEvenShare);
    double before = 0.0;
    columns_.reserve(std::size_t{height} * (width + 1));
    rows_.push_back(0.0);
    for (std::uint32_t row = 0; row < height; ++row) {
        const double extent = latitudes_[row + 1] - latitudes_[row];
        const double weight = row_weights[row] + even * width * extent;
        double in_row = 0.0;
        columns_.push_back(0.0f);
        for (std::uint32_t column = 0; column < width; ++column) {
            in_row += (double{brightness[std::size_t{row} * width + column]} + even) * extent;
            columns_.push_back(static_cast<float>(std::min(in_row / weight, 1.0)));
        }
        columns_.back() = 1.0f;
        before += weight;
        rows_.push_back(std::min(before / all, 1.0));
    }
    rows_.back() = 1.0;
}

double SkyDistribution::density(std::uint32_t row, std::uint32_t column) const {
    const float* const cells = columns_.data() + std::size_t{row} * (width_ + 1) + column;
    const double probability =
        (rows_[row + 1] - rows_[row]) * (double{cells[1]} - double{cells[0]});
    const double solid_angle =
        2.0 * std::numbers::pi / width_ * (latitudes_[row + 1] - latitudes_[row]);
    return probability / solid_angle;
}

SkyDistribution::Place SkyDistribution::sample(DVec2 u) const {
    const std::uint32_t row = part_of<double>(rows_, u.y);
    const double in_row = (u.y - rows_[row]) / (rows_[row + 1] - rows_[row]);
    const std::span<const float> cells =
        std::span(columns_).subspan(std::size_t{row} * (width_ + 1), width_ + 1);
    const std::uint32_t column = part_of<float>(cells, u.x);
    const double low = double{cells[column]};
    const double in_column = (u.x - low) / (double{cells[column + 1]} - low);
    return {(column + in_column) / width_,
            latitudes_[row] + in_row * (latitudes_[row + 1] - latitudes_[row]),
            density(row, column)};
}

double SkyDistribution::pdf(double longitude, double sin_latitude) const {
    const std::uint32_t row = part_of<double>(latitudes_, sin_latitude);
    const double column = std::clamp(longitude * width_, 0.0, width_ - 1.0);
    return density(row, static_cast<std::uint32_t>(column));
}

}  // namespace lray::shade
