#include "bench/trace_scenes.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/bounds.h"
#include "base/diagnostic_printer.h"
#include "base/diagnostics.h"
#include "base/file_access.h"
#include "base/portable_math.h"
#include "base/random.h"
#include "base/source.h"
#include "scene/formats/obj_reader.h"

namespace lray::bench {

namespace {

constexpr std::array<std::string_view, 6> kNames{"bunny",       "hall", "terrain-1m",
                                                 "terrain-10m", "soup", "spheres"};

constexpr std::size_t kScatteredCount = 1'000'000;

double number(std::string_view what, std::uint64_t i, std::uint64_t k) {
    return KeyedRandom{}.with(what).with_bits(i).with_bits(k).number();
}

DVec3 point_in_cube(std::string_view what, std::uint64_t i) {
    return {number(what, i, 0), number(what, i, 1), number(what, i, 2)};
}

/// Returns a point of the unit sphere, all alike.
/// Source: Archimedes; Weisstein, "Sphere Point Picking", eq. 6-8.
DVec3 direction(std::string_view what, std::uint64_t i) {
    const double z = 1.0 - 2.0 * number(what, i, 0);
    const DVec2 around = unit_circle_point(number(what, i, 1));
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * around.x, radius * around.y, z};
}

/// Looks at the unit cube from outside.
TraceScene scene_of_cube() {
    TraceScene result;
    result.eye = {1.9f, 1.4f, 2.3f};
    result.target = {0.5f, 0.5f, 0.5f};
    result.view_width = 0.4;
    result.light = {-0.6f, 2.5f, 1.8f};
    return result;
}

TraceScene make_soup() {
    constexpr double kEdge = 0.01;
    TraceScene result = scene_of_cube();
    scene::World& world = result.world;
    world.vertices.reserve(3 * kScatteredCount + 1);
    world.triangles.reserve(kScatteredCount);
    for (std::uint32_t i = 0; i < kScatteredCount; ++i) {
        const DVec3 corner = point_in_cube("soup corner", i);
        world.vertices.emplace_back(corner);
        world.vertices.emplace_back(corner + kEdge * direction("soup edge", 2 * i));
        world.vertices.emplace_back(corner + kEdge * direction("soup edge", 2 * i + 1));
        world.triangles.push_back({{3 * i, 3 * i + 1, 3 * i + 2}});
    }
    return result;
}

TraceScene make_spheres() {
    constexpr double kLeastRadius = 0.0005;
    constexpr double kMostRadius = 0.004;
    TraceScene result = scene_of_cube();
    result.world.spheres.reserve(kScatteredCount);
    for (std::size_t i = 0; i < kScatteredCount; ++i) {
        const double radius =
            kLeastRadius + (kMostRadius - kLeastRadius) * number("sphere radius", i, 0);
        result.world.spheres.push_back(
            {Vec3{point_in_cube("sphere center", i)}, static_cast<float>(radius)});
    }
    return result;
}

std::optional<TraceScene> read_bunny(const std::string& path) {
    FileAccess files;
    ReadResult read = files.read_main(path, std::numeric_limits<std::uint32_t>::max());
    if (read.status != ReadStatus::ok) {
        fmt::print(stderr, "{}: cannot be read {}\n", path, read.reason);
        return std::nullopt;
    }
    Sources sources;
    Diagnostics diagnostics;
    const SourceId file = sources.add(path, std::move(read.text));
    auto mesh = scene::read_obj(sources, file, Span{}, diagnostics);
    if (!mesh) {
        fmt::print(stderr, "{}", format_diagnostics(diagnostics, sources, {}));
        return std::nullopt;
    }
    TraceScene result;
    result.world.vertices = std::move(mesh->positions);
    result.world.triangles.reserve(mesh->triangles.size());
    for (const scene::IndexTriple& triple : mesh->triangles) {
        result.world.triangles.push_back({triple});
    }
    Bounds bounds;
    for (const Vec3 vertex : result.world.vertices) bounds.add(vertex);
    const Vec3 size = bounds.max - bounds.min;
    result.target = 0.5f * (bounds.min + bounds.max);
    result.eye = result.target + size * Vec3{0.3f, 0.4f, 2.0f};
    result.light = result.target + size * Vec3{-1.5f, 2.5f, 2.0f};
    result.view_width = 0.6;
    return result;
}

std::optional<TraceScene> make_unfinished(std::string_view name, const std::string& mesh_path) {
    if (name == "bunny") return read_bunny(mesh_path);
    if (name == "hall") return make_hall();
    if (name == "terrain-1m") return make_terrain(707);
    if (name == "terrain-10m") return make_terrain(2236);
    if (name == "soup") return make_soup();
    if (name == "spheres") return make_spheres();
    fmt::print(stderr, "no scene is called {}\n", name);
    return std::nullopt;
}

}  // namespace

std::span<const std::string_view> trace_scene_names() {
    return kNames;
}

std::optional<TraceScene> make_trace_scene(std::string_view name, const std::string& mesh_path) {
    auto result = make_unfinished(name, mesh_path);
    if (!result) return std::nullopt;
    result->name = name;
    finish_world(result->world);
    return result;
}

void finish_world(scene::World& world) {
    using enum scene::PrimitiveKind;
    const scene::ObjectId only{0};
    world.objects.resize(1);
    world.object_ids[static_cast<std::size_t>(triangle)].assign(world.triangles.size(), only);
    world.object_ids[static_cast<std::size_t>(sphere)].assign(world.spheres.size(), only);
    // Embree loads 16 bytes of the last vertex, too.
    world.vertices.reserve(world.vertices.size() + 1);
}

}  // namespace lray::bench
