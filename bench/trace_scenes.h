// The scenes of trace_speed, the same on every machine.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/vec.h"
#include "scene/world.h"

namespace lray::bench {

/// Triangles, or spheres, and where they are seen and lit from.
struct TraceScene {
    std::string name{};
    scene::World world{};
    Vec3 eye{};
    Vec3 target{};
    double view_width = 1.0;  // of the square picture, at distance 1
    Vec3 light{};

    bool is_spheres() const { return !world.spheres.empty(); }
    std::size_t primitive_count() const { return world.triangles.size() + world.spheres.size(); }
};

/// Returns the names that make_trace_scene() knows, in the order in which they are measured.
std::span<const std::string_view> trace_scene_names();

/// Returns a scene by its name; the bunny's mesh is read from an OBJ file.
/// Errors: empty, said on stderr, when there is no such scene or the file cannot be read.
std::optional<TraceScene> make_trace_scene(std::string_view name, const std::string& mesh_path);

/// Fractal hills of `cell_count`^2 squares of two triangles each, one unit wide.
TraceScene make_terrain(int cell_count);

/// A closed hall, its columns and arches of small triangles and, from wall to wall through all of
/// its room, cables of long thin ones: boxes around those are mostly empty and lie in each other.
TraceScene make_hall();

/// Gives all primitives one object, as flatten() would. To be called last.
void finish_world(scene::World& world);

}  // namespace lray::bench
