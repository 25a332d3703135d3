// What the rays of samples cost.
#pragma once

#include "bvh/accel.h"
#include "shade/transport/follow_light.h"

namespace lray::render {

struct RayCounts {
    bvh::TraceCounts primary{};  // from the camera
    shade::LightCounts light{};  // those that full shading sends after them

    RayCounts& operator+=(const RayCounts& other) {
        primary += other.primary;
        light += other.light;
        return *this;
    }
};

}  // namespace lray::render
