// Textures and materials in a dump: equal ones are one definition.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "parser/tools/dump_plan.h"

namespace lray::parser {

/// Names the textures and materials that the nodes of a plan use, and writes their definitions.
class DumpSurfaces {
 public:
    DumpSurfaces(const scene::Scene& scene, const DumpPlan& plan);

    /// A line or more for each definition, textures first.
    const std::string& definitions() const { return definitions_; }

    std::string material(scene::MaterialId id) const { return material_names_[id.index()]; }
    std::string texture(scene::TextureId id) const { return texture_names_[id.index()]; }

 private:
    std::string texture_text(const scene::Texture& texture, std::size_t before) const;
    std::string material_text(const scene::Material& material, std::size_t before) const;

    const scene::Scene& scene_;
    std::string definitions_;
    std::vector<std::string> texture_names_;   // by TextureId; empty: not used
    std::vector<std::string> material_names_;  // by MaterialId; likewise
};

}  // namespace lray::parser
