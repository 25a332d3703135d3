#include "shade/textures/texture_set.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assert.h"

namespace lray::shade {

namespace {

DVec3 row(const DMat3& matrix, int i) {
    return {matrix[0][i], matrix[1][i], matrix[2][i]};
}

double length_of(DVec3 v) {
    return std::sqrt(dot(v, v));
}

/// How far a disc across `normal` reaches along each axis of the texture.
DVec3 reach_of_disc(const DMat3& texture_from_space, DVec3 normal, double width) {
    const auto reach = [&](int axis) {
        const DVec3 direction = row(texture_from_space, axis);
        return width * length_of(direction - dot(direction, normal) * normal);
    };
    return {reach(0), reach(1), reach(2)};
}

}  // namespace

TextureSet::TextureSet(const scene::World& world)
    : chains_(2 * world.pictures.size()), light_chains_(world.pictures.size()) {
    entries_.reserve(world.textures.size());
    for (const scene::Texture& texture : world.textures) {
        entries_.push_back(entry_of(texture, world));
    }
}

TextureSet::Entry TextureSet::entry_of(const scene::Texture& texture, const scene::World& world) {
    const auto pattern_of = [&](const auto& pattern) -> Pattern {
        using T = std::decay_t<decltype(pattern)>;
        if constexpr (std::is_same_v<T, scene::ImageTexture>) {
            return lookup_of(pattern, world);
        } else if constexpr (std::is_same_v<T, scene::CheckerTexture>) {
            return Checker(pattern);
        } else if constexpr (std::is_same_v<T, scene::StripesTexture>) {
            return Stripes(pattern);
        } else if constexpr (std::is_same_v<T, scene::GradientTexture>) {
            return Gradient(pattern);
        } else if constexpr (std::is_same_v<T, scene::RampTexture>) {
            return Ramp(pattern);
        } else if constexpr (std::is_same_v<T, scene::NoiseTexture>) {
            return Noise(pattern);
        } else if constexpr (std::is_same_v<T, scene::MarbleTexture>) {
            return Marble(pattern);
        } else if constexpr (std::is_same_v<T, scene::WoodTexture>) {
            return Wood(pattern);
        } else {
            static_assert(std::is_same_v<T, scene::VertexColorsTexture>);
            return VertexColors();
        }
    };
    const DMat3& linear = texture.texture_from_space.linear();
    const DVec3 stretch{length_of(row(linear, 0)), length_of(row(linear, 1)),
                        length_of(row(linear, 2))};
    return {std::visit(pattern_of, texture.pattern), texture.space, linear,
            texture.texture_from_space.offset(),     stretch,       texture.average};
}

TextureSet::Pattern TextureSet::lookup_of(const scene::ImageTexture& image,
                                          const scene::World& world) {
    const std::size_t id = image.picture_id.index();
    LRAY_ASSERT(id < world.pictures.size());
    const image::Pixels& pixels = world.pictures[id].pixels;
    if (const auto* const light = std::get_if<image::Image>(&pixels)) {
        std::unique_ptr<LightMipChain>& chain = light_chains_[id];
        if (!chain) chain = std::make_unique<LightMipChain>(*light, false);
        return LightLookup(image, *chain);
    }
    std::unique_ptr<MipChain>& chain = chains_[2 * id + (image.is_srgb ? 1 : 0)];
    if (!chain) {
        chain = std::make_unique<MipChain>(std::get<image::CodedImage>(pixels), image.is_srgb);
    }
    return ImageLookup(image, *chain);
}

Color TextureSet::color(scene::TextureId id, const TexturePoint& point) const {
    LRAY_DCHECK(id.index() < entries_.size());
    const Entry& entry = entries_[id.index()];
    DVec3 p{0.0};
    DVec3 normal{0.0};
    double width = 0.0;
    switch (entry.space) {
        case scene::TextureSpace::uv:
            p = {point.uv, 0.0};
            normal = {0.0, 0.0, 1.0};
            width = point.uv_width;
            break;
        case scene::TextureSpace::object:
            p = point.object;
            normal = point.object_normal;
            width = point.object_width;
            break;
        case scene::TextureSpace::world:
            p = point.world;
            normal = point.world_normal;
            width = point.world_width;
            break;
        case scene::TextureSpace::vertex_colors:
            p = point.vertex_color;
            break;
    }
    p = entry.linear * p + entry.offset;
    constexpr double kFar = 0x1p500;
    if (!(std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z) < kFar)) return entry.average;

    Footprint footprint;
    if (width > 0.0) {
        const double reach = std::max(std::max(entry.stretch.x, entry.stretch.y), entry.stretch.z);
        if (!(width * reach < kFar)) return entry.average;
        if (normal == DVec3{0.0}) {
            footprint.across = width * reach;
        } else {
            footprint.extent = reach_of_disc(entry.linear, normal, width);
        }
    }
    return Color{std::visit([&](const auto& pattern) { return pattern.color(p, footprint); },
                            entry.pattern)};
}

float TextureSet::number(scene::TextureId id, const TexturePoint& point) const {
    const Color c = color(id, point);
    return (c.r + c.g + c.b) / 3.0f;
}

}  // namespace lray::shade
