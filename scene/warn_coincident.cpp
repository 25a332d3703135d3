#include "scene/warn_coincident.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "scene/coplanar_faces.h"
#include "scene/object_path.h"
#include "scene/same_look.h"

namespace lray::scene {

namespace {

/// Of each kind: a mistake that a loop makes a million times it makes among the first.
constexpr std::size_t kMaxCompared = 4'000;
constexpr std::size_t kMaxTold = 3;

/// All that the surface of a primitive depends on; the rest is 0.
using Numbers = std::array<float, 13>;

class NumberWriter {
 public:
    void add(float x) { numbers_[count_++] = x + 0.0f; }  // -0 is 0
    void add(Vec3 v) {
        for (int axis = 0; axis < 3; ++axis) add(v[axis]);
    }
    void add(const AffineFrame& frame) {
        add(frame.origin);
        for (int column = 0; column < 3; ++column) add(frame.object_from_world[column]);
    }
    /// In an order of their own: which corner is the first makes no difference to the surface.
    void add_sorted(std::span<Vec3> points) {
        std::sort(points.begin(), points.end(),
                  [](Vec3 a, Vec3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
        for (const Vec3 point : points) add(point);
    }

    const Numbers& numbers() const { return numbers_; }

 private:
    Numbers numbers_{};
    std::size_t count_ = 0;
};

Numbers numbers_of(const World& world, PrimitiveId id) {
    NumberWriter writer;
    const std::size_t index = id.index();
    switch (id.kind()) {
        case PrimitiveKind::triangle: {
            const IndexTriple& at = world.triangles[index].vertices;
            std::array points{world.vertices[at[0]], world.vertices[at[1]], world.vertices[at[2]]};
            writer.add_sorted(points);
            break;
        }
        case PrimitiveKind::rectangle: {
            std::array<Vec3, 4> corners = world.rectangles[index].corners;
            writer.add_sorted(corners);
            break;
        }
        case PrimitiveKind::sphere:
            writer.add(world.spheres[index].center);
            writer.add(world.spheres[index].radius);
            break;
        case PrimitiveKind::ellipsoid:
            writer.add(world.ellipsoids[index].frame);
            break;
        case PrimitiveKind::cylinder:
            writer.add(world.cylinders[index].frame);
            writer.add(world.cylinders[index].top_radius);
            break;
        case PrimitiveKind::disk:
            writer.add(world.disks[index].frame);
            writer.add(world.disks[index].hole);
            break;
        case PrimitiveKind::box:
            writer.add(world.boxes[index].frame);
            break;
        case PrimitiveKind::plane:
            writer.add(world.planes[index].point);
            writer.add(world.planes[index].normal);
            break;
        case PrimitiveKind::torus:
            writer.add(world.tori[index].frame);
            writer.add(world.tori[index].tube);
            break;
        case PrimitiveKind::instance:
            writer.add(world.instances[index].frame);
            writer.add(std::bit_cast<float>(world.instances[index].prototype));
            break;
    }
    return writer.numbers();
}

/// Equal geometry has equal keys, and hardly any other has.
std::uint64_t key_of(const Numbers& numbers) {
    std::uint64_t key = 0;
    for (const float x : numbers) {
        key = (key ^ std::bit_cast<std::uint32_t>(x)) * 0x9e3779b97f4a7c15u;
        key ^= key >> 32;
    }
    return key;
}

void add_pairs(const World& world, PrimitiveKind kind, std::vector<PrimitivePair>& pairs) {
    struct Keyed {
        std::uint64_t key = 0;
        PrimitiveId id{};
    };
    const std::vector<ObjectId>& object_ids = world.object_ids[static_cast<std::size_t>(kind)];
    std::vector<Keyed> all;
    all.reserve(std::min(object_ids.size(), kMaxCompared));
    for (std::size_t i = 0; i < std::min(object_ids.size(), kMaxCompared); ++i) {
        const PrimitiveId id(kind, i);
        all.push_back({key_of(numbers_of(world, id)), id});
    }
    std::sort(all.begin(), all.end(), [](const Keyed& a, const Keyed& b) {
        return std::tie(a.key, a.id) < std::tie(b.key, b.id);
    });
    // Neighbours in a run of equal keys: of three in one place two pairs are told.
    for (std::size_t i = 1; i < all.size(); ++i) {
        if (all[i - 1].key != all[i].key) continue;
        const PrimitiveId first = all[i - 1].id;
        const PrimitiveId second = all[i].id;
        if (numbers_of(world, first) != numbers_of(world, second)) continue;
        if (shows_a_difference(world, first, second)) pairs.push_back({first, second});
    }
}

}  // namespace

void warn_coincident(const Scene& scene, const World& world, Diagnostics& diagnostics) {
    if (world.materials.size() <= 1) return;  // all look the same
    std::vector<PrimitivePair> pairs;
    for (std::size_t kind = 0; kind < kPrimitiveKindCount; ++kind) {
        add_pairs(world, static_cast<PrimitiveKind>(kind), pairs);
    }
    const std::vector<PrimitivePair> faces = coplanar_faces(scene, world);
    pairs.insert(pairs.end(), faces.begin(), faces.end());
    // A mesh in the place of another has thousands of triangles there: each two objects once.
    const auto objects_of = [&world](const PrimitivePair& pair) {
        return std::pair(world.object_of(pair.second), world.object_of(pair.first));
    };
    std::sort(pairs.begin(), pairs.end(), [&](const PrimitivePair& a, const PrimitivePair& b) {
        return std::tuple(objects_of(a), a.second) < std::tuple(objects_of(b), b.second);
    });
    const auto last = std::unique(pairs.begin(), pairs.end(),
                                  [&](const PrimitivePair& a, const PrimitivePair& b) {
                                      return objects_of(a) == objects_of(b);
                                  });
    pairs.erase(last, pairs.end());
    for (std::size_t i = 0; i < std::min(pairs.size(), kMaxTold); ++i) {
        const auto [later_id, earlier_id] = objects_of(pairs[i]);
        const Node& later = scene.node(world.object(later_id).node_id);
        const Node& earlier = scene.node(world.object(earlier_id).node_id);
        Diagnostic& warning = diagnostics.warning(
            Code::W1206, later.span,
            fmt::format("this {} has a surface where a {} of another material has one",
                        title_of(scene, later), title_of(scene, earlier)));
        add_place(warning, scene, world, earlier_id, "the other one");
        if (i + 1 == kMaxTold && pairs.size() > kMaxTold) {
            warning.with_note(fmt::format("... and {} more", pairs.size() - kMaxTold));
        }
    }
}

}  // namespace lray::scene
