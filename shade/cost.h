// What rays cost, as a colour: why hierarchies matter, for all to see.
#pragma once

#include <cstdint>

#include "base/vec.h"
#include "bvh/accel.h"

namespace lray::shade {

/// Returns the tests of a ray: nodes, primitives and instances.
std::uint64_t test_count(const bvh::TraceCounts& counts);

/// Returns the colour of a number of tests on a fixed scale, each colour four times the tests of
/// the one before: none black, 1 dark blue, 4 blue, 16 cyan, 64 green, 256 yellow, 1024 orange,
/// 4096 red, 16384 and more white. Between them it is linear in the number's place on the scale.
Color cost_color(std::uint64_t tests);

inline Color cost(const bvh::TraceCounts& counts) {
    return cost_color(test_count(counts));
}

}  // namespace lray::shade
