// A scene with all that is made of it before a picture can be: each part refers to those before it.
#pragma once

#include <memory>
#include <utility>

#include "base/bounds.h"
#include "base/source.h"
#include "bvh/accel.h"
#include "scene/scene.h"
#include "scene/world.h"
#include "shade/transport/lit_world.h"

namespace lray::render {

struct PreparedScene {
    PreparedScene(Sources its_sources, scene::Scene its_scene, scene::World its_world)
        : sources(std::move(its_sources)),
          scene(std::move(its_scene)),
          world(std::move(its_world)) {}
    PreparedScene(const PreparedScene&) = delete;  // its parts refer to one another
    PreparedScene& operator=(const PreparedScene&) = delete;

    Sources sources;  // that the spans of the scene lead to
    scene::Scene scene;
    scene::World world;
    std::unique_ptr<const bvh::Accel> accel{};
    std::unique_ptr<const shade::LitWorld> lit{};  // what `full` shading needs; else none
};

}  // namespace lray::render
