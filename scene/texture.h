// Textures: colours that vary over a surface or through space, as they are authored. How they are
// looked up is in shade/. Defaults are those of the language.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "base/transform.h"
#include "base/vec.h"
#include "image/pixels.h"
#include "scene/ids.h"

namespace lray::scene {

/// What a texture is a function of.
enum class TextureSpace : std::uint8_t {
    uv,      // (u, v, 0) of the surface
    object,  // the point in the space of the shape, before its own steps
    world,
    vertex_colors,  // the colours of the mesh there: not of the language
};

enum class Axis : std::uint8_t { x, y, z };

/// A colour at a place. In a list the places never decrease; two at one place are a hard edge.
struct ColorStop {
    double at = 0.0;
    Color color{0.0f};
    friend bool operator==(const ColorStop&, const ColorStop&) = default;
};

/// A picture file that was read, kept as codes or as light.
struct Picture {
    std::string file{};  // the path from the directory of the scene
    image::Pixels pixels{};
    Color srgb_mean{0.0f};  // of its linear pixels, the codes read as sRGB
    Color linear_mean{0.0f};
};

enum class ImageWrap : std::uint8_t { repeat, mirror, clamp };
enum class ImageFilter : std::uint8_t { nearest, bilinear };

/// The picture fills 0 to 1 in the first two coordinates, (0, 0) its bottom left corner.
struct ImageTexture {
    PictureId picture_id{};
    ImageWrap wrap = ImageWrap::repeat;
    ImageFilter filter = ImageFilter::bilinear;
    bool is_srgb = true;  // false: the codes are linear data; of light it means nothing
};

/// Cubes of side `size` in turn `a` and `b`, `a` at the first one in positive direction.
struct CheckerTexture {
    Color a{0.8f};
    Color b{0.2f};
    double size = 1.0;
};

/// Slabs of thickness `size` in turn `a` and `b`.
struct StripesTexture {
    Color a{0.8f};
    Color b{0.2f};
    double size = 1.0;
    Axis axis = Axis::x;
};

/// Runs through its stops, which lie in 0 to 1, once in each unit along the axis.
struct GradientTexture {
    Axis axis = Axis::x;
    std::vector<ColorStop> stops{{0.0, Color{0.0f}}, {1.0, Color{1.0f}}};
};

/// Runs through its stops along the axis; before the first and behind the last it stays as there.
struct RampTexture {
    Axis axis = Axis::y;
    std::vector<ColorStop> stops{{0.0, Color{0.0f}}, {1.0, Color{1.0f}}};
};

/// Fractal noise, mapped from -1 to 1 onto 0 to 1, through its stops.
struct NoiseTexture {
    std::uint32_t octaves = 5;
    double lacunarity = 2.0;
    double gain = 0.5;
    double seed = 0.0;
    std::vector<ColorStop> stops{{0.0, Color{0.0f}}, {1.0, Color{1.0f}}};
};

/// Veins `b` in `a`, `size` apart along the axis, displaced by noise.
struct MarbleTexture {
    Color a{0.8f};
    Color b{0.25f};
    double size = 1.0;
    double turbulence = 2.0;  // of the displacement, in sizes
    std::uint32_t octaves = 5;
    Axis axis = Axis::x;
    double seed = 0.0;
};

/// Rings around the axis, `size` wide, from early wood `a` to late wood `b`, displaced by noise.
struct WoodTexture {
    Color a{0.42f, 0.22f, 0.09f};
    Color b{0.18f, 0.075f, 0.025f};
    double size = 0.1;
    double turbulence = 0.3;  // of the displacement, in sizes
    std::uint32_t octaves = 3;
    Axis axis = Axis::y;
    double seed = 0.0;
};

/// The colours of the vertices of the mesh it is on, between corners in proportion; white where
/// there are none.
struct VertexColorsTexture {};

using TexturePattern =
    std::variant<ImageTexture, CheckerTexture, StripesTexture, GradientTexture, RampTexture,
                 NoiseTexture, MarbleTexture, WoodTexture, VertexColorsTexture>;

struct Texture {
    TexturePattern pattern{};
    TextureSpace space = TextureSpace::object;
    Transform space_from_texture{};  // the steps of its block
    Transform texture_from_space{};  // its inverse: where a point of the space is looked up
    Color average{0.0f};             // by average_color(): what flat painting shows
};

}  // namespace lray::scene
