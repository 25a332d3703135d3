// What a tree of boxes is expected to cost to trace: the surface-area measure, with triangles and
// spheres counted in blocks.
#pragma once

#include <cstdint>

#include "bvh/boxes/box_layout.h"
#include "bvh/boxes/ref_set.h"

namespace lray::bvh {

/// The cost of looking at a node's children, when that of a block of triangles is 1.
inline constexpr double kNodeCost = 0.5;

/// That of coming to a leaf, beside its blocks.
inline constexpr double kLeafCost = 0.2;

/// Blocks that so much weight (kRefWeights) fills.
inline double block_count(std::uint64_t weight) {
    return static_cast<double>((weight + kBoxWidth - 1) / kBoxWidth);
}

inline double leaf_cost(std::uint64_t weight) {
    return kLeafCost + block_count(weight);
}

/// In proportion to the chance that a ray which meets something around a box meets the box. In
/// double no product of two extents leaves the range.
inline double half_area(const Box4& box) {
    float extent[4];
    store_four(extent, box.upper - box.lower);
    const auto x = static_cast<double>(extent[0]);
    const auto y = static_cast<double>(extent[1]);
    const auto z = static_cast<double>(extent[2]);
    return x * y + y * z + z * x;
}

/// The area by which sets are compared. What has none counts by its length, in so small a part that
/// it only decides there: a row of points on a line is divided in order, too.
class Measure {
 public:
    explicit Measure(const Box4& whole) : length_share_(0x1p-40 * length(whole)) {}

    double operator()(const Box4& box) const {
        return half_area(box) + length_share_ * length(box);
    }

 private:
    static double length(const Box4& box) {
        float extent[4];
        store_four(extent, box.upper - box.lower);
        return static_cast<double>(extent[0]) + static_cast<double>(extent[1]) +
               static_cast<double>(extent[2]);
    }

    double length_share_;
};

}  // namespace lray::bvh
