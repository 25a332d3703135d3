// Fuzzes the NFF reader; whatever it accepts must be a scene that refers to what is there, and can
// be flattened or is told why not.
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "base/assert.h"
#include "base/diagnostic_printer.h"
#include "base/diagnostics.h"
#include "base/source.h"
#include "scene/flatten.h"
#include "scene/formats/nff_nodes.h"
#include "scene/formats/nff_reader.h"
#include "scene/scene.h"

namespace {

using lray::scene::NffScene;
using lray::scene::NffShape;
using lray::scene::NodeKind;
using lray::scene::Scene;

void check(const NffScene& nff) {
    for (const NffShape& shape : nff.shapes) {
        const std::size_t count = shape.kind == NodeKind::sphere     ? nff.spheres.size()
                                  : shape.kind == NodeKind::cylinder ? nff.cylinders.size()
                                                                     : nff.triangles.size();
        LRAY_ASSERT(shape.index < count);
        LRAY_ASSERT(shape.surface < nff.surfaces.size());
    }
    for (const lray::scene::TriangleShape& triangle : nff.triangles) {
        LRAY_ASSERT(triangle.attributes == lray::scene::TriangleShape::kNoAttributes ||
                    triangle.attributes < nff.triangle_attributes.size());
    }
}

void place(NffScene&& nff, Scene& scene) {
    const lray::scene::NffNodes nodes = lray::scene::add_nff(std::move(nff), scene);
    lray::scene::Group root;
    for (std::size_t i = nodes.first; i < scene.nodes.size(); ++i) root.children.emplace_back(i);
    scene.groups.push_back(std::move(root));
    scene.root = lray::scene::NodeId(scene.nodes.size());
    scene.nodes.emplace_back();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    lray::Sources sources;
    lray::Diagnostics diagnostics;
    const lray::SourceId file = sources.add(
        "fuzz.nff", lray::Text(std::string_view(reinterpret_cast<const char*>(data), size)));
    const lray::scene::NffLimits limits{10'000, 0, std::uint64_t{1} << 22};
    auto nff = lray::scene::read_nff(sources, file, limits, diagnostics);
    LRAY_ASSERT(nff.has_value() == !diagnostics.has_errors());
    if (nff) {
        check(*nff);
        if (nff->view) LRAY_ASSERT(lray::scene::camera_of(*nff->view).fov > 0.0);
        Scene scene;
        place(std::move(*nff), scene);
        const auto world = lray::scene::flatten(scene, {.primitives = 10'000}, diagnostics);
        LRAY_ASSERT(world.has_value() == !diagnostics.has_errors());
    }
    const std::string text = lray::format_diagnostics(diagnostics, sources, {.max_errors = 0});
    for (const char c : text) LRAY_ASSERT(c == '\n' || static_cast<unsigned char>(c) >= 0x20);
    return 0;
}
