// The tables of all blocks: property, type, default, range, one line of documentation. Pure data.
#pragma once

#include <array>

#include "parser/blocks/schema.h"

namespace lray::parser::schemas {

using enum PropertyType;

inline constexpr std::array<std::string_view, 5> kModels = {"lambert", "phong", "blinn_phong",
                                                            "cook_torrance", "ward"};
inline constexpr std::array<std::string_view, 2> kProjections = {"perspective", "orthographic"};
inline constexpr std::array<std::string_view, 2> kUpAxes = {"y", "z"};
// In the order of scene::TerrainMethod.
inline constexpr std::array<std::string_view, 3> kTerrainMethods = {"diamond_square", "fbm",
                                                                    "ridged"};

/// Of a side of a height mesh: scene::kMaxHeightVertices is the square of the most.
inline constexpr Range kResolution{2.0, 32768.0};

// clang-format off
inline constexpr std::array<PropertySchema, kCommonPropertyCount> kCommon = {{
    {"translate", point, "[0, 0, 0]", "moves"},
    {"scale", scale, "1", "scales about the origin, by one factor or one per axis"},
    {"rotate_x", angle, "0", "turns about the X axis"},
    {"rotate_y", angle, "0", "turns about the Y axis"},
    {"rotate_z", angle, "0", "turns about the Z axis"},
    {"rotate", rotation, "[0, 0, 0]", "turns about X, then Y, then Z, or by a rotation(...)"},
    {"matrix", matrix, "", "3 or 4 rows of 4 numbers, translation in the last column"},
    {"transform", transform, "", "a transform, or a list of them, the first one done first"},
    {"look_at", point, "", "turns the local -Z axis towards a point"},
    {"material", material, "", "the surface; without it the parent's"},
    {"visible", boolean, "true", "false: not in the picture, nor what is below", kAnyNumber, {1}},
    {"casts_shadow", boolean, "true", "false: lets light through", kAnyNumber, {1}},
}};

inline constexpr std::array<PropertySchema, 2> kSphere = {{
    {"center", point, "[0, 0, 0]", "the middle"},
    {"radius", number, "1", "the radius", kPositive, {1}},
}};

inline constexpr std::array<PropertySchema, 6> kRectangle = {{
    {"center", point, "[0, 0, 0]", "the middle", kAnyNumber, {}, false, Form::first},
    {"size", size2, "[1, 1]", "width and depth", kPositive, {1, 1}, false, Form::first},
    {"normal", direction, "[0, 1, 0]", "the side it faces", kAnyNumber, {0, 1, 0}, false, Form::first},
    {"corner", point, "", "a corner", kAnyNumber, {}, true, Form::second},
    {"edge_u", direction, "", "from the corner along u", kAnyNumber, {}, true, Form::second},
    {"edge_v", direction, "", "from the corner along v", kAnyNumber, {}, true, Form::second},
}};

inline constexpr std::array<PropertySchema, 5> kTriangle = {{
    {"a", point, "", "a corner; the order a, b, c is counter-clockwise from the front", kAnyNumber, {}, true},
    {"b", point, "", "a corner", kAnyNumber, {}, true},
    {"c", point, "", "a corner", kAnyNumber, {}, true},
    {"normals", points, "", "a normal for each corner"},
    {"uvs", uvs, "", "texture coordinates for each corner"},
}};

inline constexpr std::array<PropertySchema, 5> kCylinder = {{
    {"from", point, "[0, 0, 0]", "the middle of one end"},
    {"to", point, "[0, 1, 0]", "the middle of the other end", kAnyNumber, {0, 1, 0}},
    {"radius", number, "0.5", "the radius at `from`", kNotNegative, {0.5}},
    {"radius_to", number, "", "the radius at `to`, which makes a cone; without it `radius`", kNotNegative},
    {"caps", boolean, "true", "closed at both ends", kAnyNumber, {1}},
}};

inline constexpr std::array<PropertySchema, 4> kDisk = {{
    {"center", point, "[0, 0, 0]", "the middle"},
    {"normal", direction, "[0, 1, 0]", "the side it faces", kAnyNumber, {0, 1, 0}},
    {"radius", number, "1", "the radius", kPositive, {1}},
    {"hole", number, "0", "the radius of the hole in the middle", kNotNegative, {0}},
}};

inline constexpr std::array<PropertySchema, 4> kBox = {{
    {"center", point, "[0, 0, 0]", "the middle", kAnyNumber, {}, false, Form::first},
    {"size", size3, "[1, 1, 1]", "width, height and depth", kPositive, {1, 1, 1}, false, Form::first},
    {"min", point, "", "the least corner", kAnyNumber, {}, true, Form::second},
    {"max", point, "", "the greatest corner", kAnyNumber, {}, true, Form::second},
}};

inline constexpr std::array<PropertySchema, 2> kPlane = {{
    {"point", point, "[0, 0, 0]", "a point on it"},
    {"normal", direction, "[0, 1, 0]", "the side it faces", kAnyNumber, {0, 1, 0}},
}};

inline constexpr std::array<PropertySchema, 2> kTorus = {{
    {"radius", number, "1", "from the centre to the middle of the tube", kPositive, {1}},
    {"tube", number, "0.25", "the radius of the tube", kPositive, {0.25}},
}};

inline constexpr std::array<PropertySchema, 7> kMesh = {{
    {"file", file, "", "an OBJ file", kAnyNumber, {}, true, Form::first},
    {"part", string, "", "only the group or object of that name", kAnyNumber, {}, false, Form::first},
    {"up", option, "\"y\"", "the axis that points up in the file", kAnyNumber, {}, false, Form::any, kUpAxes},
    {"positions", points, "", "the vertices", kAnyNumber, {}, true, Form::second},
    {"triangles", index_triples, "", "three vertex indices each, from 0", kAnyNumber, {}, true, Form::second},
    {"normals", points, "", "a normal for each vertex", kAnyNumber, {}, false, Form::second},
    {"uvs", uvs, "", "texture coordinates for each vertex", kAnyNumber, {}, false, Form::second},
}};

inline constexpr std::array<PropertySchema, 6> kHeightfield = {{
    {"size", size2, "[1, 1]", "width along X and depth along Z, about the origin", kPositive, {1, 1}},
    {"resolution", integer, "128", "heights along each side", kResolution, {128}, false, Form::first},
    {"height", function, "", "`fn(x, z)`: the height at a point, x and z from -size/2 to size/2", kAnyNumber, {}, true, Form::first},
    {"heights", height_rows, "", "the heights: a row along X for each Z, the farthest (-Z) first", kAnyNumber, {}, true, Form::second},
    {"image", file, "", "a PNG or PPM file: a height for each pixel, black 0 and white `scale_y`, its top at -Z", kAnyNumber, {}, true, Form::third},
    {"scale_y", number, "1", "the height of white in the picture", kAnyNumber, {1}, false, Form::third},
}};

inline constexpr std::array<PropertySchema, 6> kTerrain = {{
    {"size", size2, "[100, 100]", "width along X and depth along Z, about the origin", kPositive, {100, 100}},
    {"height", number, "10", "how far its farthest point is above or below 0", kNotNegative, {10}},
    {"resolution", integer, "257", "heights along each side; `diamond_square` suits 2^k + 1", kResolution, {257}},
    {"method", option, "\"diamond_square\"", "how it is made", kAnyNumber, {}, false, Form::any, kTerrainMethods},
    {"roughness", number, "0.5", "how much of its height each finer detail keeps, half the size", kUnit, {0.5}},
    {"seed", number, "", "which landscape: another number, another one", kAnyNumber, {}, true},
}};

inline constexpr std::array<PropertySchema, 14> kMaterial = {{
    {"model", option, "\"blinn_phong\"", "the reflection model", kAnyNumber, {}, false, Form::any, kModels},
    {"ambient", color, "", "reflected ambient light; without it as `diffuse`", kNotNegative},
    {"diffuse", color, "0.8", "matt colour; the colour of flat painting", kNotNegative, {0.8, 0.8, 0.8}},
    {"specular", color, "", "highlight colour; 0.2, or 1 for cook_torrance and ward", kNotNegative},
    {"shininess", number, "32", "highlight exponent of phong and blinn_phong", {0.0, 10000.0}, {32}},
    {"roughness", roughness, "0.3", "of cook_torrance, and of ward along u and v", kUnit, {0.3, 0.3}},
    {"fresnel", color, "0.04", "reflectance of cook_torrance at normal incidence", kNotNegative, {0.04, 0.04, 0.04}},
    {"reflect", color, "0", "mirror colour", kNotNegative},
    {"transmit", color, "0", "colour of light let through", kNotNegative},
    {"ior", number, "1.5", "index of refraction", kPositive, {1.5}},
    {"absorption", color, "[0, 0, 0]", "lost per metre inside (Beer-Lambert)", kNotNegative},
    {"emission", color, "0", "light given off", kNotNegative},
    {"opacity", number, "1", "0 cuts out, without refraction", kUnit, {1}},
    {"two_sided", boolean, "true", "lit from both sides", kAnyNumber, {1}},
}};

inline constexpr std::array<PropertySchema, 8> kCamera = {{
    {"position", point, "[0, 0, 5]", "where the eye is", kAnyNumber, {0, 0, 5}},
    {"look_at", point, "[0, 0, 0]", "what is in the middle of the picture"},
    {"up", direction, "[0, 1, 0]", "what is up in the picture", kAnyNumber, {0, 1, 0}},
    {"fov", angle, "45", "vertical field of view, degrees", {0.0, 179.0, true}, {45}},
    {"projection", option, "\"perspective\"", "or \"orthographic\"", kAnyNumber, {}, false, Form::any, kProjections},
    {"height", number, "2", "height of the orthographic view", kPositive, {2}},
    {"resolution", resolution, "", "as in `render`, for this view", {1.0, 1048576.0}},
    {"background", color, "", "as in `render`, for this view", kNotNegative},
}};

inline constexpr std::array<PropertySchema, 2> kRender = {{
    {"resolution", resolution, "[800, 600]", "width and height in pixels", {1.0, 1048576.0}, {800, 600}},
    {"background", color, "#000000", "the colour where nothing is hit", kNotNegative},
}};

inline constexpr std::array<BlockSchema, kBlockKindCount> kBlocks = {{
    {BlockKind::group, "group", "puts things together, to be moved and painted as one", {}, true, true},
    {BlockKind::sphere, "sphere", "a ball", kSphere, true},
    {BlockKind::rectangle, "rectangle", "a flat rectangle; lies on the floor by default", kRectangle, true},
    {BlockKind::triangle, "triangle", "a flat triangle", kTriangle, true},
    {BlockKind::cylinder, "cylinder", "a cylinder or a cone", kCylinder, true},
    {BlockKind::disk, "disk", "a flat disk, with a hole if wanted", kDisk, true},
    {BlockKind::box, "box", "a box along the axes", kBox, true},
    {BlockKind::plane, "plane", "an infinite plane", kPlane, true},
    {BlockKind::torus, "torus", "a ring with a round section, around the Y axis", kTorus, true},
    {BlockKind::mesh, "mesh", "triangles from a file or from lists", kMesh, true},
    {BlockKind::heightfield, "heightfield", "hills: a height for each point of a grid", kHeightfield, true},
    {BlockKind::terrain, "terrain", "a landscape made up from a seed", kTerrain, true},
    {BlockKind::material, "material", "a surface", kMaterial},
    {BlockKind::camera, "camera", "a view; the first one is the default", kCamera},
    {BlockKind::render, "render", "settings of the picture", kRender},
    {BlockKind::info, "info", "title, author, license: copied into the picture", {}, false, false, true},
    {BlockKind::record, "record", "values put together under names of your own", {}, false, false, false, true},
}};
// clang-format on

/// Index of a property of that name, found while compiling.
consteval std::size_t slot(std::span<const PropertySchema> properties, std::string_view name) {
    const std::size_t found = find_property(properties, name);
    if (found == properties.size()) throw "no such property";
    return found;
}

}  // namespace lray::parser::schemas
