// The materials of a world, ready to be asked for at a hit.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/world.h"
#include "shade/material_point.h"
#include "shade/textures/texture_set.h"

namespace lray::shade {

/// Const calls are thread-safe. The textures must outlive it.
class MaterialTable {
 public:
    MaterialTable(const scene::World& world, const TextureSet& textures);

    /// True if the material is not the same everywhere: at() has to be asked.
    bool is_textured(std::uint32_t material) const { return materials_[material].is_textured; }

    /// True if hits need the shape's own coordinates: for a texture, a bump or a direction along
    /// the surface.
    bool needs_detail(std::uint32_t material) const { return materials_[material].needs_detail; }

    /// Its coefficients; of a texture the average.
    const MaterialPoint& average(std::uint32_t material) const {
        return materials_[material].average;
    }

    /// Returns its coefficients in a point.
    MaterialPoint at(std::uint32_t material, const TexturePoint& point) const;

    /// As authored.
    const scene::Material& authored(std::uint32_t material) const {
        return *materials_[material].authored;
    }

    /// True if some material lets light through (transmit).
    bool has_transmission() const { return has_transmission_; }
    /// True if some material looks textures up: then it matters how wide rays are.
    bool has_textures() const { return has_textures_; }
    /// True if some material has holes (opacity).
    bool has_cut_outs() const { return has_cut_outs_; }

 private:
    struct Entry {
        const scene::Material* authored = nullptr;
        MaterialPoint average{};
        bool is_textured = false;
        bool needs_detail = false;
    };

    const TextureSet& textures_;
    std::vector<Entry> materials_{};
    bool has_textures_ = false;
    bool has_transmission_ = false;
    bool has_cut_outs_ = false;
};

}  // namespace lray::shade
