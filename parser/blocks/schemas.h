// The tables of all blocks: property, type, default, range, one line of documentation. Pure data.
#pragma once

#include <array>

#include "parser/blocks/schema.h"

namespace lray::parser::schemas {

using enum PropertyType;

inline constexpr std::array<std::string_view, 5> kModels = {"lambert", "phong", "blinn_phong",
                                                            "cook_torrance", "ward"};
inline constexpr std::array<std::string_view, 3> kProjections = {"perspective", "orthographic",
                                                                 "panorama"};
// In the order of scene::BumpUnit.
inline constexpr std::array<std::string_view, 2> kBumpUnits = {"metre", "uv"};
inline constexpr std::array<std::string_view, 2> kUpAxes = {"y", "z"};
// In the order of scene::TerrainMethod.
inline constexpr std::array<std::string_view, 3> kTerrainMethods = {"diamond_square", "fbm",
                                                                    "ridged"};

/// Of a side of a height mesh: scene::kMaxHeightVertices is the square of the most.
inline constexpr Range kGridSize{2.0, 32768.0};
inline constexpr std::array<std::string_view, 3> kSpaces = {"uv", "object", "world"};
inline constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
inline constexpr std::array<std::string_view, 3> kWraps = {"repeat", "mirror", "clamp"};
inline constexpr std::array<std::string_view, 2> kFilters = {"nearest", "bilinear"};
inline constexpr std::array<std::string_view, 3> kFalloffs = {"quadratic", "linear", "none"};
inline constexpr std::array<std::string_view, 3> kToneMaps = {"none", "reinhard", "aces"};
inline constexpr std::array<std::string_view, 2> kGammas = {"srgb", "linear"};
inline constexpr std::array<std::string_view, 2> kIntegrators = {"whitted", "path"};
inline constexpr std::array<std::string_view, 2> kSamplers = {"sobol", "random"};

inline constexpr Range kSmoothAngle{0.0, 180.0, false};
inline constexpr Range kOctaves{1.0, 16.0, false};
inline constexpr Range kLightSamples{1.0, 4096.0, false};

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

inline constexpr std::array<PropertySchema, 10> kMesh = {{
    {"file", file, "", "an OBJ, PLY or other mesh file", kAnyNumber, {}, true, Form::first},
    {"part", string, "", "only the group or object of that name", kAnyNumber, {}, false, Form::first},
    {"up", option, "\"y\"", "the axis that points up in the file", kAnyNumber, {}, false, Form::any, kUpAxes},
    {"positions", points, "", "the vertices", kAnyNumber, {}, true, Form::second},
    {"triangles", index_triples, "", "three vertex indices each, from 0", kAnyNumber, {}, true, Form::second},
    {"normals", points, "", "a normal for each vertex", kAnyNumber, {}, false, Form::second},
    {"uvs", uvs, "", "texture coordinates for each vertex", kAnyNumber, {}, false, Form::second},
    {"colors", colors, "", "a colour for each vertex", kUnit, {}, false, Form::second},
    {"smooth", number, "", "faces that meet at less than so many degrees are smooth; 0: all are flat", kSmoothAngle},
    {"use_mtl", boolean, "true", "the materials that the file names, unless there is a `material`", kAnyNumber, {1}, false, Form::first},
}};

inline constexpr std::array<PropertySchema, 6> kHeightfield = {{
    {"size", size2, "[1, 1]", "width along X and depth along Z, about the origin", kPositive, {1, 1}},
    {"resolution", integer, "128", "heights along each side", kGridSize, {128}, false, Form::first},
    {"height", function, "", "`fn(x, z)`: the height at a point, x and z from -size/2 to size/2", kAnyNumber, {}, true, Form::first},
    {"heights", height_rows, "", "the heights: a row along X for each Z, the farthest (-Z) first", kAnyNumber, {}, true, Form::second},
    {"image", file, "", "a picture file: a height for each pixel, black 0 and white `scale_y`, its top at -Z", kAnyNumber, {}, true, Form::third},
    {"scale_y", number, "1", "the height of white in the picture", kAnyNumber, {1}, false, Form::third},
}};

inline constexpr std::array<PropertySchema, 6> kTerrain = {{
    {"size", size2, "[100, 100]", "width along X and depth along Z, about the origin", kPositive, {100, 100}},
    {"height", number, "10", "how far its farthest point is above or below 0", kNotNegative, {10}},
    {"resolution", integer, "257", "heights along each side; `diamond_square` suits 2^k + 1", kGridSize, {257}},
    {"method", option, "\"diamond_square\"", "how it is made", kAnyNumber, {}, false, Form::any, kTerrainMethods},
    {"roughness", number, "0.5", "how much of its height each finer detail keeps, half the size", kUnit, {0.5}},
    {"seed", number, "", "which landscape: another number, another one", kAnyNumber, {}, true},
}};

inline constexpr std::array<PropertySchema, 18> kMaterial = {{
    {"model", option, "\"blinn_phong\"", "the reflection model", kAnyNumber, {}, false, Form::any, kModels},
    or_texture({"ambient", color, "", "reflected ambient light; without it as `diffuse`", kNotNegative}),
    or_texture({"diffuse", color, "0.8", "matt colour; the colour of flat painting", kNotNegative, {0.8, 0.8, 0.8}}),
    or_texture({"specular", color, "", "highlight colour; 0.2, or 1 for cook_torrance and ward", kNotNegative}),
    or_texture({"shininess", number, "32", "highlight exponent of phong and blinn_phong", {0.0, 10000.0}, {32}}),
    or_texture({"roughness", roughness, "0.3", "of cook_torrance, and of ward along u and v", kUnit, {0.3, 0.3}}),
    or_texture({"fresnel", color, "0.04", "reflectance of cook_torrance at normal incidence", kNotNegative, {0.04, 0.04, 0.04}}),
    or_texture({"reflect", color, "0", "mirror colour", kNotNegative}),
    or_texture({"transmit", color, "0", "colour of light let through", kNotNegative}),
    {"ior", number, "1.5", "index of refraction", kPositive, {1.5}},
    or_texture({"absorption", color, "[0, 0, 0]", "lost per metre inside (Beer-Lambert)", kNotNegative}),
    or_texture({"emission", color, "0", "light given off", kNotNegative}),
    or_texture({"opacity", number, "1", "0 cuts out, without refraction", kUnit, {1}}),
    {"bump", texture, "", "height of the surface along its normal"},
    {"bump_height", number, "1", "how high 1 in `bump` is; below 0 it is a hollow", kAnyNumber, {1}},
    {"bump_unit", option, "\"metre\"", "of `bump_height`; \"uv\": the width of u from 0 to 1", kAnyNumber, {}, false, Form::any, kBumpUnits},
    {"normal_map", texture, "", "normals in tangent space, coded as colours"},
    {"two_sided", boolean, "true", "lit from both sides", kAnyNumber, {1}},
}};

inline constexpr std::array<PropertySchema, 11> kCamera = {{
    {"position", point, "[0, 0, 5]", "where the eye is", kAnyNumber, {0, 0, 5}},
    {"look_at", point, "[0, 0, 0]", "what is in the middle of the picture"},
    {"up", direction, "[0, 1, 0]", "what is up in the picture", kAnyNumber, {0, 1, 0}},
    {"fov", angle, "45", "vertical field of view, degrees", {0.0, 179.0, true}, {45}},
    {"projection", option, "\"perspective\"", "how directions become pixels; \"panorama\" is all around", kAnyNumber, {}, false, Form::any, kProjections},
    {"height", number, "2", "height of the orthographic view", kPositive, {2}},
    {"aperture", number, "0", "diameter of the lens; 0: all is sharp", kNotNegative},
    {"focus", focus, "", "what is sharp, a point or a distance; without it `look_at`", kPositive},
    {"resolution", resolution, "", "as in `render`, for this view", {1.0, 1048576.0}},
    {"samples", integer, "", "as in `render`, for this view", {1.0, 32768.0}},
    {"background", color, "", "as in `render`, for this view", kNotNegative},
}};

inline constexpr std::array<PropertySchema, 12> kRender = {{
    {"resolution", resolution, "[800, 600]", "width and height in pixels", {1.0, 1048576.0}, {800, 600}},
    {"samples", integer, "1", "rays per pixel", {1.0, 32768.0}, {1}},
    {"max_depth", integer, "8", "reflections and refractions one after the other", {0.0, 256.0}, {8}},
    {"background", color, "#000000", "the colour where nothing is hit", kNotNegative},
    {"ambient", color, "0", "light from everywhere, times `ambient` of the material", kNotNegative},
    {"exposure", number, "0", "in stops: 1 makes the picture twice as bright", {-64.0, 64.0}},
    {"tonemap", option, "\"none\"", "how bright colours are brought into the picture", kAnyNumber, {}, false, Form::any, kToneMaps},
    {"gamma", option, "\"srgb\"", "how colours are coded in the file", kAnyNumber, {}, false, Form::any, kGammas},
    {"seed", integer, "0", "of all that is chosen at random", {0.0, 9007199254740992.0}},
    {"integrator", option, "\"whitted\"", "how light is followed", kAnyNumber, {}, false, Form::any, kIntegrators},
    {"sampler", option, "\"sobol\"", "where in a pixel the rays go", kAnyNumber, {}, false, Form::any, kSamplers},
    {"transparent_shadows", boolean, "false", "what lets light through casts a coloured shadow", kAnyNumber, {0}},
}};

inline constexpr std::array<PropertySchema, 3> kAnimation = {{
    {"frames", integer, "1", "how many pictures", {1.0, 1000000.0}, {1}},
    {"fps", number, "24", "pictures per second", kPositive, {24}},
    {"start", number, "0", "the time of the first picture, seconds"},
}};

// Textures

inline constexpr std::array<PropertySchema, 5> kImage = {{
    {"file", file, "", "a picture file", kAnyNumber, {}, true},
    {"wrap", option, "\"repeat\"", "what is outside of the picture", kAnyNumber, {}, false, Form::any, kWraps},
    {"filter", option, "\"bilinear\"", "what is between pixels", kAnyNumber, {}, false, Form::any, kFilters},
    {"srgb", boolean, "true", "false: the file holds data, not colours", kAnyNumber, {1}},
    {"space", option, "\"uv\"", "what is looked up; of points x and y", kAnyNumber, {}, false, Form::any, kSpaces},
}};

inline constexpr std::array<PropertySchema, 4> kChecker = {{
    {"a", color, "0.8", "a colour; that of the cube from 0 to `size`", kNotNegative, {0.8, 0.8, 0.8}},
    {"b", color, "0.2", "the other colour", kNotNegative, {0.2, 0.2, 0.2}},
    {"size", number, "1", "side of a cube", kPositive, {1}},
    {"space", option, "\"object\"", "what is looked up", kAnyNumber, {}, false, Form::any, kSpaces},
}};

inline constexpr std::array<PropertySchema, 5> kStripes = {{
    {"a", color, "0.8", "a colour; that of the stripe from 0 to `size`", kNotNegative, {0.8, 0.8, 0.8}},
    {"b", color, "0.2", "the other colour", kNotNegative, {0.2, 0.2, 0.2}},
    {"size", number, "1", "width of a stripe", kPositive, {1}},
    {"axis", option, "\"x\"", "across the stripes", kAnyNumber, {}, false, Form::any, kAxes},
    {"space", option, "\"object\"", "what is looked up", kAnyNumber, {}, false, Form::any, kSpaces},
}};

inline constexpr std::array<PropertySchema, 3> kGradient = {{
    {"axis", option, "\"x\"", "along which the colour changes", kAnyNumber, {}, false, Form::any, kAxes},
    {"stops", stops, "[[0, black], [1, white]]", "colours from 0 to 1, which come again in each unit", kUnit},
    {"space", option, "\"object\"", "what is looked up", kAnyNumber, {}, false, Form::any, kSpaces},
}};

inline constexpr std::array<PropertySchema, 3> kRamp = {{
    {"axis", option, "\"y\"", "along which the colour changes", kAnyNumber, {}, false, Form::any, kAxes},
    {"stops", stops, "[[0, black], [1, white]]", "colours at places; beyond the last ones it stays"},
    {"space", option, "\"object\"", "what is looked up", kAnyNumber, {}, false, Form::any, kSpaces},
}};

inline constexpr std::array<PropertySchema, 6> kNoiseTexture = {{
    {"octaves", integer, "5", "how many layers of detail", kOctaves, {5}},
    {"lacunarity", number, "2", "how much finer each layer is", {1.0, 16.0}, {2}},
    {"gain", number, "0.5", "how much weaker each layer is", kUnit, {0.5}},
    {"seed", number, "0", "another one, another pattern"},
    {"stops", stops, "[[0, black], [1, white]]", "colours from least to most noise", kUnit},
    {"space", option, "\"object\"", "what is looked up", kAnyNumber, {}, false, Form::any, kSpaces},
}};

inline constexpr std::array<PropertySchema, 8> kMarble = {{
    {"a", color, "0.8", "the stone", kNotNegative, {0.8, 0.8, 0.8}},
    {"b", color, "0.25", "the veins", kNotNegative, {0.25, 0.25, 0.25}},
    {"size", number, "1", "from vein to vein", kPositive, {1}},
    {"turbulence", number, "2", "how far the veins stray, in sizes", kNotNegative, {2}},
    {"octaves", integer, "5", "how many layers of detail", kOctaves, {5}},
    {"axis", option, "\"x\"", "across the veins", kAnyNumber, {}, false, Form::any, kAxes},
    {"seed", number, "0", "another one, another pattern"},
    {"space", option, "\"object\"", "what is looked up", kAnyNumber, {}, false, Form::any, kSpaces},
}};

inline constexpr std::array<PropertySchema, 8> kWood = {{
    {"a", color, "[0.42, 0.22, 0.09]", "early wood", kNotNegative, {0.42, 0.22, 0.09}},
    {"b", color, "[0.18, 0.075, 0.025]", "late wood", kNotNegative, {0.18, 0.075, 0.025}},
    {"size", number, "0.1", "width of a ring", kPositive, {0.1}},
    {"turbulence", number, "0.3", "how far the rings stray, in sizes", kNotNegative, {0.3}},
    {"octaves", integer, "3", "how many layers of detail", kOctaves, {3}},
    {"axis", option, "\"y\"", "of the trunk", kAnyNumber, {}, false, Form::any, kAxes},
    {"seed", number, "0", "another one, another pattern"},
    {"space", option, "\"object\"", "what is looked up", kAnyNumber, {}, false, Form::any, kSpaces},
}};

// Lights

inline constexpr std::array<PropertySchema, 6> kPointLight = {{
    {"position", point, "[0, 0, 0]", "where it is"},
    {"color", color, "1", "its colour", kNotNegative, {1, 1, 1}},
    {"intensity", number, "500", "L in L / (4 pi d^2), the light at the distance d", kNotNegative, {500}},
    {"falloff", option, "\"quadratic\"", "\"linear\": d, \"none\": 1 in the place of d^2", kAnyNumber, {}, false, Form::any, kFalloffs},
    {"radius", number, "0", "of the ball that shines; more than 0: soft shadows", kNotNegative},
    {"samples", integer, "1", "shadow rays to a ball", kLightSamples, {1}},
}};

inline constexpr std::array<PropertySchema, 10> kSpotLight = {{
    {"position", point, "[0, 0, 0]", "where it is"},
    {"direction", direction, "[0, 0, -1]", "the way it shines; `look_at` turns it", kAnyNumber, {0, 0, -1}, false, Form::first},
    {"target", point, "", "the point it shines at", kAnyNumber, {}, true, Form::second},
    {"angle", angle, "40", "of the full cone, degrees", {0.0, 180.0, true}, {40}},
    {"softness", number, "0.2", "the share of the cone that fades to its rim", kUnit, {0.2}},
    {"color", color, "1", "its colour", kNotNegative, {1, 1, 1}},
    {"intensity", number, "500", "L in L / (4 pi d^2), the light at the distance d", kNotNegative, {500}},
    {"falloff", option, "\"quadratic\"", "\"linear\": d, \"none\": 1 in the place of d^2", kAnyNumber, {}, false, Form::any, kFalloffs},
    {"radius", number, "0", "of the ball that shines; more than 0: soft shadows", kNotNegative},
    {"samples", integer, "1", "shadow rays to a ball", kLightSamples, {1}},
}};

inline constexpr std::array<PropertySchema, 5> kDirectionalLight = {{
    {"direction", direction, "[0, 0, -1]", "the way the light goes; `look_at` turns it", kAnyNumber, {0, 0, -1}},
    {"color", color, "1", "its colour", kNotNegative, {1, 1, 1}},
    {"intensity", number, "1", "the light on a surface that faces it", kNotNegative, {1}},
    {"angle", angle, "0", "diameter of the sun as seen, degrees; more than 0: soft shadows", {0.0, 180.0}},
    {"samples", integer, "1", "shadow rays to a sun that is wider than 0", kLightSamples, {1}},
}};

inline constexpr std::array<PropertySchema, 9> kAreaLight = {{
    {"center", point, "[0, 0, 0]", "the middle", kAnyNumber, {}, false, Form::first},
    {"size", size2, "[1, 1]", "width and depth", kPositive, {1, 1}, false, Form::first},
    {"normal", direction, "[0, -1, 0]", "the side that shines", kAnyNumber, {0, -1, 0}, false, Form::first},
    {"corner", point, "", "a corner", kAnyNumber, {}, true, Form::second},
    {"edge_u", direction, "", "from the corner along u", kAnyNumber, {}, true, Form::second},
    {"edge_v", direction, "", "from the corner along v", kAnyNumber, {}, true, Form::second},
    {"color", color, "1", "its colour", kNotNegative, {1, 1, 1}},
    {"intensity", number, "500", "its power in all, however large it is", kNotNegative, {500}},
    {"samples", integer, "16", "shadow rays to it", kLightSamples, {16}},
}};

inline constexpr std::array<PropertySchema, 4> kEnvironment = {{
    {"color", color, "1", "light from everywhere", kNotNegative, {1, 1, 1}, false, Form::first},
    or_texture({"image", file, "", "a picture of all around, as `panorama` makes it, or a texture", kAnyNumber, {}, false, Form::second}),
    {"intensity", number, "1", "times the colour or picture: its radiance", kNotNegative, {1}},
    {"samples", integer, "16", "shadow rays to it", kLightSamples, {16}},
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
    {BlockKind::image, "image", "a picture from a file", kImage},
    {BlockKind::checker, "checker", "cubes of two colours", kChecker},
    {BlockKind::stripes, "stripes", "stripes of two colours", kStripes},
    {BlockKind::gradient, "gradient", "colours that run and start again", kGradient},
    {BlockKind::ramp, "ramp", "colours by height, or along another axis", kRamp},
    {BlockKind::noise_texture, "noise_texture", "clouds", kNoiseTexture},
    {BlockKind::marble, "marble", "veined stone", kMarble},
    {BlockKind::wood, "wood", "rings of a tree", kWood},
    {BlockKind::vertex_colors, "vertex_colors", "the colours that a mesh has at its vertices", {}},
    {BlockKind::point_light, "point_light", "a light in one point, or a small ball", kPointLight, true},
    {BlockKind::spot_light, "spot_light", "a light that shines in a cone", kSpotLight, true},
    {BlockKind::directional_light, "directional_light", "a light from far away, like the sun", kDirectionalLight, true},
    {BlockKind::area_light, "area_light", "a rectangle that shines to one side", kAreaLight, true},
    {BlockKind::environment, "environment", "light from all around, like the sky", kEnvironment, true},
    {BlockKind::animation, "animation", "how many pictures a film has", kAnimation},
    {BlockKind::record, "record", "values under names of their own", {}, false, false, false, true},
}};
// clang-format on

/// Index of a property of that name, found while compiling.
consteval std::size_t slot(std::span<const PropertySchema> properties, std::string_view name) {
    const std::size_t found = find_property(properties, name);
    if (found == properties.size()) throw "no such property";
    return found;
}

}  // namespace lray::parser::schemas
