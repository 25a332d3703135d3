// Fuzzes the running of programs: neither the memory of components nor the fast path of literals
// changes the world that a scene makes.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/assert.h"
#include "base/diagnostics.h"
#include "base/file_access.h"
#include "base/source.h"
#include "parser/load.h"
#include "scene/flatten.h"
#include "tests/fuzz/scene_directory.h"
#include "tests/fuzz/small_limits.h"

namespace {

using namespace lray;

/// A world as numbers that are compared bit by bit.
class Digest {
 public:
    explicit Digest(const scene::World& world) {
        for (const Vec3& vertex : world.vertices) add(vertex);
        for (const scene::Triangle& triangle : world.triangles) {
            for (const std::uint32_t index : triangle.vertices) add(index);
        }
        for (const scene::Rectangle& rectangle : world.rectangles) {
            for (const Vec3& corner : rectangle.corners) add(corner);
        }
        for (const scene::Sphere& sphere : world.spheres) {
            add(sphere.center);
            add(sphere.radius);
        }
        for (const scene::Ellipsoid& ellipsoid : world.ellipsoids) add(ellipsoid.frame);
        for (const scene::Cylinder& cylinder : world.cylinders) {
            add(cylinder.frame);
            add(cylinder.top_radius);
            add(std::uint32_t{cylinder.caps});
        }
        for (const scene::Disk& disk : world.disks) {
            add(disk.frame);
            add(disk.hole);
        }
        for (const scene::Box& box : world.boxes) add(box.frame);
        for (const scene::Plane& plane : world.planes) {
            add(plane.point);
            add(plane.normal);
        }
        for (const scene::Torus& torus : world.tori) {
            add(torus.frame);
            add(torus.tube);
        }
        // Equal materials may have other numbers: they are made each time a component runs.
        for (const scene::Object& object : world.objects) {
            add(Vec3(world.materials[object.material].diffuse.constant));
            add(std::uint32_t{object.visible} * 2 + std::uint32_t{object.casts_shadow});
        }
        add(static_cast<std::uint32_t>(world.lights.size()));
    }

    friend bool operator==(const Digest&, const Digest&) = default;

 private:
    void add(std::uint32_t word) { words_.push_back(word); }
    void add(float number) { words_.push_back(std::bit_cast<std::uint32_t>(number)); }
    void add(const Vec3& v) {
        add(v.x);
        add(v.y);
        add(v.z);
    }
    void add(const scene::AffineFrame& frame) {
        add(frame.origin);
        for (int column = 0; column < 3; ++column) add(frame.object_from_world[column]);
    }

    std::vector<std::uint32_t> words_;
};

struct Outcome {
    std::optional<Digest> world{};
    bool is_limited = false;
};

Outcome run(const std::string& path, const parser::LoadSettings& settings) {
    FileAccess files;
    Sources sources;
    Diagnostics diagnostics;
    Outcome outcome;
    const parser::LoadResult result = parser::load(path, settings, files, sources, diagnostics);
    LRAY_ASSERT(result.usage_mistakes.empty());
    LRAY_ASSERT(result.scene.has_value() == !diagnostics.has_errors());
    if (result.scene) {
        const auto world = scene::flatten(*result.scene, {.primitives = 10'000}, diagnostics);
        LRAY_ASSERT(world.has_value() == !diagnostics.has_errors());
        if (world) outcome.world.emplace(*world);
    }
    outcome.is_limited = diagnostics.has_limit_errors();
    return outcome;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::SceneDirectory kDirectory;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const std::string path = kDirectory.write("scene.lrs", text);
    parser::LoadSettings settings;
    settings.limits = fuzz::kSmallLimits;
    const Outcome usual = run(path, settings);
    settings.use_memo = false;
    settings.use_literal_fast_path = false;
    const Outcome plain = run(path, settings);
    // The plain way takes more steps and makes more nodes.
    if (usual.is_limited || plain.is_limited) return 0;
    LRAY_ASSERT(usual.world == plain.world);
    return 0;
}
