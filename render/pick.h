// What is under a position in the picture, in the words and places of the scene's text.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "base/source.h"
#include "base/vec.h"
#include "bvh/accel.h"
#include "scene/camera.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace lray::render {

/// All text is as it may be sent to a terminal.
struct Pick {
    /// The way through the graph, outermost first: "group `tree` > sphere `apple`". What has no
    /// label is left out on the way; the shape or mesh itself is always named.
    std::string name{};
    std::string place{};      // "scene.lrs:42:3" of the shape's block; the file where that is gone
    std::string placed_at{};  // likewise of the innermost instance that places it; empty if none is
                              // written elsewhere
    DVec3 point{};            // in the world
    DVec3 normal{};           // unit and outward, wherever it is seen from
    double distance = 0.0;    // from where the ray begins
};

/// Returns what the ray through a position of the full picture and the middle of the lens meets
/// first; empty when that is nothing, or once `cancel` is set.
/// Shape: the hierarchy is that of the world, and the world that of the scene. Positions in the
/// sources are looked up: no other thread may do that meanwhile.
std::optional<Pick> pick(const scene::Scene& scene, const scene::World& world,
                         const bvh::Accel& accel, const Sources& sources,
                         const scene::Camera& camera, scene::Resolution resolution,
                         DVec2 position_pixel, const std::atomic<bool>& cancel);

}  // namespace lray::render
