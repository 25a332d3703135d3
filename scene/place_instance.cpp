// Placing instances: only the map of each is made, what it places is there already.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/placer.h"

namespace lray::scene {

namespace {

/// The map of the unit cube onto a box.
struct BoxMap {
    DVec3 middle{};
    DVec3 half{};

    explicit BoxMap(const Bounds& bounds)
        : middle(0.5 * (DVec3{bounds.min} + DVec3{bounds.max})), half(DVec3{bounds.max} - middle) {}
};

}  // namespace

void Placer::place_instance(NodeId node_id, const Prototype& prototype,
                            const Placement& placement) {
    add_object(node_id, placement);
    if (prototype.bounds.is_empty()) return;
    const Node& node = scene_.node(node_id);
    const Transform& transform = placement.world_from_object;
    const DMat3& linear = transform.linear();
    const DVec3 offset = transform.point(prototype.origin_object);
    const BoxMap box(prototype.bounds);
    const DVec3 middle = offset + linear * box.middle;
    DVec3 extent{0.0};
    for (int axis = 0; axis < 3; ++axis) {
        for (int row = 0; row < 3; ++row) {
            extent[row] += std::fabs(linear[axis][row]) * box.half[axis];
        }
    }
    if (!are_placeable(node, std::array{offset, middle + extent, middle - extent})) return;
    const auto frame = invert(node, linear, offset);
    if (!frame) return;
    double steepest = 0.0;
    for (int column = 0; column < 3; ++column) {
        steepest = std::max(steepest, reach(DVec3{frame->object_from_world[column]}));
    }
    const double thinness = std::max(1.0, steepest * prototype.thinness);
    if (!(thinness <= 1.0 / kMinSize)) {
        refuse(Code::E0304, node,
               fmt::format("what this {} places is {} thin in the world; the least is {}",
                           name_of(node.kind), 1.0 / thinness, kMinSize));
        return;
    }
    thinness_ = std::max(thinness_, thinness);
    geometry_.instances.push_back(
        {*frame, placed_bounds(prototype.bounds, *frame), prototype.index, geometry_.place_count});
    geometry_.place_count += prototype.place_count;
    add_object_id(PrimitiveKind::instance);
}

}  // namespace lray::scene
