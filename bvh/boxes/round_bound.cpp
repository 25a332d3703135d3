#include "bvh/boxes/round_bound.h"

#include <cmath>
#include <numbers>

#include "base/assert.h"

namespace lray::bvh {

namespace {

/// A cylinder around +Y of an object space.
struct Bound {
    const scene::AffineFrame& frame;
    double radius = 1.0;
    double bottom = -1.0;
    double top = 1.0;
};

Bound bound_of(const scene::Geometry& geometry, scene::PrimitiveId id) {
    switch (id.kind()) {
        case scene::PrimitiveKind::ellipsoid:
            return {geometry.ellipsoids[id.index()].frame};
        case scene::PrimitiveKind::cylinder:
            return {geometry.cylinders[id.index()].frame, 1.0, 0.0, 1.0};
        case scene::PrimitiveKind::disk:
            return {geometry.disks[id.index()].frame, 1.0, 0.0, 0.0};
        case scene::PrimitiveKind::box:
            return {geometry.boxes[id.index()].frame, std::numbers::sqrt2};
        case scene::PrimitiveKind::torus: {
            const scene::Torus& torus = geometry.tori[id.index()];
            const double tube = static_cast<double>(torus.tube);
            return {torus.frame, 1.0, -tube, tube};
        }
        case scene::PrimitiveKind::triangle:
        case scene::PrimitiveKind::rectangle:
        case scene::PrimitiveKind::sphere:
        case scene::PrimitiveKind::plane:
        case scene::PrimitiveKind::instance:
            break;
    }
    LRAY_ASSERT(false);
}

}  // namespace

RoundBound round_bound(const scene::Geometry& geometry, scene::PrimitiveId id) {
    const Bound bound = bound_of(geometry, id);
    RoundBound result;
    double stretch = 0.0;
    for (int column = 0; column < 3; ++column) {
        const auto at = static_cast<std::size_t>(column);
        result.origin[at] = bound.frame.origin[column];
        for (int row = 0; row < 3; ++row) {
            const double number = static_cast<double>(bound.frame.object_from_world[column][row]) /
                                  (row == 1 ? 1.0 : bound.radius);
            result.bound_from_world[at][static_cast<std::size_t>(row)] = static_cast<float>(number);
            stretch += std::fabs(number);
        }
    }
    result.bottom = static_cast<float>(bound.bottom);
    result.top = static_cast<float>(bound.top);
    result.stretch = static_cast<float>(stretch);
    result.id = id.value;
    return result;
}

}  // namespace lray::bvh
