// Worlds that hold nothing but one texture, and its lookup.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "scene/average_color.h"
#include "scene/world.h"
#include "shade/textures/texture_set.h"
#include "tests/support/random.h"

namespace lray::test {

/// Shape: the picture is that of an ImageTexture, or none.
inline scene::World world_with(scene::TexturePattern pattern,
                               scene::TextureSpace space = scene::TextureSpace::object,
                               const Transform& space_from_texture = {},
                               std::span<const scene::Picture> pictures = {}) {
    scene::World world;
    scene::Texture texture;
    texture.pattern = std::move(pattern);
    texture.space = space;
    texture.space_from_texture = space_from_texture;
    texture.texture_from_space = *space_from_texture.inverse();
    texture.average = scene::average_color(texture.pattern, pictures);
    world.textures.push_back(std::move(texture));
    world.pictures = pictures;
    return world;
}

/// A point of all three spaces at once, with the footprint in each.
inline shade::TexturePoint point_at(DVec3 p, double width = 0.0, DVec3 normal = DVec3{0.0}) {
    shade::TexturePoint point;
    point.uv = {p.x, p.y};
    point.object = point.world = p;
    point.uv_width = point.object_width = point.world_width = width;
    point.object_normal = point.world_normal = normal;
    return point;
}

template <class Pattern>
Color color_of(const Pattern& pattern, DVec3 p, const shade::Footprint& footprint) {
    return Color{pattern.color(p, footprint)};
}

inline DVec3 point_in_box(Random& random, double size) {
    const double x = random.uniform(-size, size);
    const double y = random.uniform(-size, size);
    return {x, y, random.uniform(-size, size)};
}

inline image::CodedImage random_codes(std::uint32_t width, std::uint32_t height,
                                      std::uint64_t seed) {
    Random random(seed);
    image::CodedImage picture{width, height, {}};
    picture.rgb.resize(std::size_t{3} * width * height);
    for (std::uint8_t& code : picture.rgb) code = static_cast<std::uint8_t>(random.below(256));
    return picture;
}

inline scene::Picture picture_of(image::Pixels pixels) {
    scene::Picture picture;
    picture.srgb_mean = image::mean_color(pixels, true);
    picture.linear_mean = image::mean_color(pixels, false);
    picture.pixels = std::move(pixels);
    return picture;
}

}  // namespace lray::test
