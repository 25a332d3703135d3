// Fuzzes the MTL reader; whatever it accepts must be materials that can be rendered.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>

#include "base/assert.h"
#include "base/diagnostics.h"
#include "base/source.h"
#include "scene/formats/mtl_material.h"
#include "scene/formats/mtl_reader.h"

namespace {

using namespace lray;

bool is_color(const scene::Coefficient& coefficient) {
    const Color c = coefficient.constant;
    return c.r >= 0.0f && c.g >= 0.0f && c.b >= 0.0f && std::isfinite(c.r) && std::isfinite(c.g) &&
           std::isfinite(c.b);
}

void check(const scene::Material& material) {
    LRAY_ASSERT(is_color(material.diffuse) && is_color(*material.specular));
    LRAY_ASSERT(is_color(material.reflect) && is_color(material.transmit));
    LRAY_ASSERT(is_color(material.emission));
    LRAY_ASSERT(material.ior > 0.0f && std::isfinite(material.ior));
    LRAY_ASSERT(material.shininess.constant >= 0.0f && material.shininess.constant <= 10000.0f);
    LRAY_ASSERT(material.opacity.constant >= 0.0f && material.opacity.constant <= 1.0f);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Sources sources;
    Diagnostics diagnostics;
    const SourceId file =
        sources.add("fuzz.mtl", Text(std::string_view(reinterpret_cast<const char*>(data), size)));
    const std::unordered_set<std::string> wanted = {"a", "b", "red"};
    const auto materials = scene::read_mtl(sources, file, Span{}, wanted, diagnostics);
    LRAY_ASSERT(materials.has_value() == !diagnostics.has_errors());
    if (!materials) return 0;
    LRAY_ASSERT(materials->size() <= wanted.size());
    for (const scene::MtlMaterial& mtl : *materials) {
        LRAY_ASSERT(wanted.contains(mtl.name));
        check(scene::material_of(mtl, {}, {}));
        for (const auto& map : {mtl.diffuse_map, mtl.specular_map, mtl.emission_map,
                                mtl.opacity_map, mtl.normal_map}) {
            if (!map) continue;
            LRAY_ASSERT(!map->file.empty() && map->span.end() <= size);
            LRAY_ASSERT(scene::uv_from_picture(*map).inverse().has_value());
        }
    }
    return 0;
}
