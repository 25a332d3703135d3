// Reads MTL, the materials of OBJ files. What they mean is scene/formats/mtl_material.h.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "base/diagnostics.h"
#include "base/source.h"
#include "base/vec.h"

namespace lray::scene {

/// A picture that an MTL file names.
struct MtlMap {
    std::string file{};  // as written
    Span span{};         // of that
    bool is_clamped = false;
    DVec2 scale{1.0};  // of uv: a picture at `scale * uv + offset`
    DVec2 offset{0.0};
    double bump_multiplier = 1.0;  // -bm
};

/// What `newmtl` and the statements after it say; empty where there is none.
/// Space/units: colours are linear and 0 or more, numbers finite.
struct MtlMaterial {
    std::string name{};
    std::optional<Color> diffuse{};        // Kd
    std::optional<Color> specular{};       // Ks
    std::optional<Color> emission{};       // Ke
    std::optional<Color> filter{};         // Tf
    std::optional<float> exponent{};       // Ns
    std::optional<float> ior{};            // Ni
    std::optional<float> dissolve{};       // d, in [0, 1]
    std::optional<float> transparency{};   // Tr, in [0, 1]
    std::optional<std::uint32_t> model{};  // illum, 0 to 10
    std::optional<MtlMap> diffuse_map{};
    std::optional<MtlMap> specular_map{};
    std::optional<MtlMap> emission_map{};
    std::optional<MtlMap> opacity_map{};  // map_d
    std::optional<MtlMap> normal_map{};   // norm
    std::optional<MtlMap> bump_map{};     // map_bump, bump
};

/// Returns the materials of an MTL file held in `sources` whose names are wanted, each at its
/// first definition.
/// Errors: empty when an error was reported at its place in the file (E0003 binary, E0701), with a
/// label at `loaded_at` unless that is nowhere; likewise W1704, what is not read.
std::optional<std::vector<MtlMaterial>> read_mtl(const Sources& sources, SourceId file,
                                                 Span loaded_at,
                                                 const std::unordered_set<std::string>& wanted,
                                                 Diagnostics& diagnostics);

}  // namespace lray::scene
