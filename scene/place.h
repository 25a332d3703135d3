// The way to a place: the instances that lead there from the world's own space.
#pragma once

#include <vector>

#include "scene/world.h"

namespace lray::scene {

/// An instance on the way, and the object that it is in the geometry it stands in.
struct PlaceStep {
    const WorldInstance* instance = nullptr;
    const Object* object = nullptr;
};

/// What is behind a step: the geometry that is placed, and how far into it the place is.
struct EnteredPlace {
    PlaceStep step{};
    const Geometry* geometry = nullptr;
    PlaceOffset place = 0;
};

/// Takes the first step to a place of a geometry that is not its own space.
/// Errors: asserts that the place is in it.
EnteredPlace enter(const World& world, const Geometry& geometry, PlaceOffset place);

/// The geometry of a place and the way there, from the world inward.
struct PlacePath {
    const Geometry* geometry = nullptr;
    std::vector<PlaceStep> steps{};
};

/// Returns the way to a place, in time proportional to its depth and the logarithm of the
/// instances. Errors: asserts that the place is in the world.
PlacePath path_to(const World& world, PlaceOffset place);

/// Returns the geometry of a place.
const Geometry& geometry_at(const World& world, PlaceOffset place);

/// Returns the index of the material that a primitive of a place shows: its own, or that of the
/// innermost instance that has one.
std::uint32_t material_at(const World& world, PlaceOffset place, PrimitiveId id);

}  // namespace lray::scene
