// Goes through the primitives of a geometry.
#pragma once

#include "scene/world.h"

namespace lray::scene {

/// Calls visit(PrimitiveId, const Object&) for every primitive, in the order of ids, until it
/// returns false.
template <class Visit>
void each_primitive(const Geometry& geometry, Visit visit) {
    for (std::size_t kind = 0; kind < kPrimitiveKindCount; ++kind) {
        const std::vector<ObjectId>& object_ids = geometry.object_ids[kind];
        for (std::size_t i = 0; i < object_ids.size(); ++i) {
            const PrimitiveId id(static_cast<PrimitiveKind>(kind), i);
            if (!visit(id, geometry.object(object_ids[i]))) return;
        }
    }
}

}  // namespace lray::scene
