// The way through the graph to an object of the world, for messages about it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace lray::scene {

/// The nodes from below the root to the shape or mesh.
using ObjectPath = std::vector<NodeId>;

/// Returns the path of an object of the geometry of a place. Walks what is stored as flatten()
/// does, up to the object: for the few that a message is about.
ObjectPath path_of(const Scene& scene, const World& world, PlaceOffset place, ObjectId id);

/// Returns the instances on a path that are written elsewhere than what it leads to, the innermost
/// first, `max_count` at most.
std::vector<NodeId> instances_elsewhere(const Scene& scene, const ObjectPath& path,
                                        std::size_t max_count);

/// Says where an object in the world's own space is: a label with `message` at its shape; if it is
/// placed by instances, labels there, and the names on the way to it as a note.
void add_place(Diagnostic& diagnostic, const Scene& scene, const World& world, ObjectId id,
               std::string message);

/// Returns the shape's kind with its name, if it has one: "sphere `sun`".
std::string title_of(const Scene& scene, const Node& node);

}  // namespace lray::scene
