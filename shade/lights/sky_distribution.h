// Directions chosen by how bright a picture of all around is there: a distribution that is constant
// in cells of longitude and latitude.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"

namespace lray::shade {

/// Longitude and latitude are places in [0, 1]^2, as in scene::EnvironmentLight; within a cell
/// directions are uniform by solid angle. Near values of u choose near directions.
class SkyDistribution {
 public:
    /// Shape: `brightness` has width x height cells, row by row from straight down, none negative
    /// and not all 0.
    SkyDistribution(std::uint32_t width, std::uint32_t height, std::span<const float> brightness);

    struct Place {
        double longitude = 0.0;
        double sin_latitude = 0.0;
        double pdf = 0.0;  // per solid angle
    };
    Place sample(DVec2 u) const;

    /// Returns the density of choosing a place.
    double pdf(double longitude, double sin_latitude) const;

 private:
    double density(std::uint32_t row, std::uint32_t column) const;

    std::uint32_t width_ = 0;
    std::vector<double> latitudes_{};  // sines, at the borders of rows: height + 1
    std::vector<double> rows_{};       // probability of the rows before: height + 1
    std::vector<float> columns_{};     // likewise of the cells of each row: height x (width + 1)
};

}  // namespace lray::shade
