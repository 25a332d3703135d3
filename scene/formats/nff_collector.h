// Gathers the shapes, lights and surfaces of an NFF file, within limits: each surface once,
// polygons cut into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "base/source.h"
#include "scene/formats/nff_mistakes.h"
#include "scene/formats/nff_reader.h"
#include "scene/formats/nff_scene.h"
#include "scene/triangulate_polygon.h"

namespace lray::scene::nff {

/// All spans are of the statement that is added. Once a limit is reached, which is told of, nothing
/// more is added.
class Collector {
 public:
    Collector(const NffLimits& limits, Mistakes& mistakes) : limits_(limits), mistakes_(mistakes) {}

    /// The surface of the shapes that follow.
    void set_fill(const NffSurface& surface);

    void add(const NffLight& light);
    void add(const SphereShape& sphere, Span span);
    void add(const CylinderShape& cone, Span span);

    /// Shape: 3 corners or more that a float holds; no normals, or one for each corner.
    void add_polygon(const std::vector<DVec3>& corners, const std::vector<DVec3>& normals,
                     Span span);

    bool is_full() const { return is_full_; }

    NffScene& scene() { return scene_; }

 private:
    template <class Shape>
    void add(NodeKind kind, std::vector<Shape>& shapes, const Shape& shape, Span span);
    void add_triangle(const IndexTriple& corners, const std::vector<DVec3>& points,
                      const std::vector<DVec3>& normals, Span span);
    std::optional<std::uint32_t> surface_index(Span span);
    bool has_room_for_node(Span span);
    bool take_bytes(std::uint64_t size, Span span);

    const NffLimits& limits_;
    Mistakes& mistakes_;
    NffScene scene_{};
    bool is_full_ = false;

    NffSurface fill_{};
    std::optional<std::uint32_t> fill_index_{};  // once it is used
    std::map<std::array<double, 8>, std::uint32_t> surfaces_{};
    std::uint64_t value_bytes_ = 0;

    std::vector<Vec3> points_{};  // for the triangulator
    PolygonTriangulator triangulator_{};
};

}  // namespace lray::scene::nff
