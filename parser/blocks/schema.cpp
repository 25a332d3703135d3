#include "parser/blocks/schema.h"

#include <algorithm>

#include "base/assert.h"
#include "parser/blocks/schemas.h"
#include "parser/syntax/token.h"

namespace lray::parser {

namespace {

/// A name from other tools, and ours.
struct Habit {
    std::string_view name{};
    std::string_view ours{};
};

constexpr bool kinds_are_in_order() {
    for (std::size_t i = 0; i < schemas::kBlocks.size(); ++i) {
        if (static_cast<std::size_t>(schemas::kBlocks[i].kind) != i) return false;
        if (schemas::kBlocks[i].properties.size() > kMaxProperties) return false;
    }
    return true;
}
static_assert(kinds_are_in_order());

constexpr std::array<Habit, 66> kPropertyHabits = {{
    {"color", "diffuse"},
    {"colour", "diffuse"},
    {"pigment", "diffuse"},
    {"albedo", "diffuse"},
    {"pos", "position"},
    {"location", "position"},
    {"eye", "position"},
    {"origin", "position"},
    {"target", "look_at"},
    {"lookat", "look_at"},
    {"r", "radius"},
    {"rad", "radius"},
    {"diameter", "radius"},
    {"c", "center"},
    {"centre", "center"},
    {"rotation", "rotate"},
    {"rotateX", "rotate_x"},
    {"rotateY", "rotate_y"},
    {"rotateZ", "rotate_z"},
    {"translation", "translate"},
    {"move", "translate"},
    {"height", "to"},
    {"src", "file"},
    {"filename", "file"},
    {"path", "file"},
    {"vertices", "positions"},
    {"faces", "triangles"},
    {"indices", "triangles"},
    {"texcoords", "uvs"},
    {"phong_size", "shininess"},
    {"reflection", "reflect"},
    {"size", "resolution"},
    {"angle", "fov"},
    {"colour", "color"},
    {"power", "intensity"},
    {"brightness", "intensity"},
    {"strength", "intensity"},
    {"energy", "intensity"},
    {"watts", "intensity"},
    {"emit", "emission"},
    {"emissive", "emission"},
    {"transparency", "transmit"},
    {"transmission", "transmit"},
    {"refraction_index", "ior"},
    {"metalness", "fresnel"},
    {"alpha", "opacity"},
    {"bump_map", "bump"},
    {"normalmap", "normal_map"},
    {"cone_angle", "angle"},
    {"cutoff", "angle"},
    {"blend", "softness"},
    {"point_at", "target"},
    {"shadow", "casts_shadow"},
    {"shadows", "casts_shadow"},
    {"dir", "direction"},
    {"color1", "a"},
    {"color2", "b"},
    {"map", "image"},
    {"fstop", "aperture"},
    {"focal_point", "focus"},
    {"focus_distance", "focus"},
    {"focal_distance", "focus"},
    {"spp", "samples"},
    {"depth", "max_depth"},
    {"max_bounces", "max_depth"},
    {"tone_mapping", "tonemap"},
}};

constexpr std::array<Habit, 31> kBlockHabits = {{
    {"light", "point_light`, `spot_light`, `directional_light` or `area_light"},
    {"texture",
     "image`, `checker`, `stripes`, `gradient`, `ramp`, `noise_texture`, `marble`, `wood` or "
     "`vertex_colors"},
    {"quad", "rectangle"},
    {"square", "rectangle"},
    {"ball", "sphere"},
    {"cube", "box"},
    {"cone", "cylinder"},
    {"circle", "disk"},
    {"disc", "disk"},
    {"object", "group"},
    {"obj", "mesh"},
    {"view", "camera"},
    {"settings", "render"},
    {"finish", "material"},
    {"pointlight", "point_light"},
    {"bulb", "point_light"},
    {"spotlight", "spot_light"},
    {"spot", "spot_light"},
    {"sun", "directional_light"},
    {"distant_light", "directional_light"},
    {"arealight", "area_light"},
    {"rect_light", "area_light"},
    {"sky", "environment"},
    {"skybox", "environment"},
    {"sky_sphere", "environment"},
    {"background", "environment"},
    {"image_map", "image"},
    {"checkerboard", "checker"},
    {"struct", "record"},
    {"dict", "record"},
    {"pigment", "material"},
}};

/// A property of the language that this version does not have.
struct FutureProperty {
    BlockKind block{};
    std::string_view name{};
};

constexpr std::array<FutureProperty, 1> kPropertiesNotYet = {{
    {BlockKind::camera, "exposure"},
}};

// clang-format off
constexpr std::array<std::string_view, 4> kNotYet = {{
    "union", "intersection", "difference", "text",
}};
// clang-format on

std::string_view find_habit(std::span<const Habit> habits, std::string_view name) {
    for (const Habit& habit : habits) {
        if (habit.name == name) return habit.ours;
    }
    return {};
}

}  // namespace

std::span<const PropertySchema> common_properties() {
    return schemas::kCommon;
}

std::span<const BlockSchema> block_schemas() {
    return schemas::kBlocks;
}

const BlockSchema& block_schema(BlockKind kind) {
    return schemas::kBlocks[static_cast<std::size_t>(kind)];
}

const BlockSchema* find_block(Symbol symbol) {
    const std::size_t kind = std::size_t{symbol} - kKeywords.size();
    return kind < kBlockKindCount ? &schemas::kBlocks[kind] : nullptr;
}

const BlockSchema* find_block(std::string_view name) {
    for (const BlockSchema& schema : schemas::kBlocks) {
        if (schema.name == name) return &schema;
    }
    return nullptr;
}

std::string_view property_habit(std::string_view name, const BlockSchema& schema) {
    for (const Habit& habit : kPropertyHabits) {
        const std::span<const PropertySchema> properties = schema.properties;
        if (habit.name == name && find_property(properties, habit.ours) < properties.size()) {
            return habit.ours;
        }
    }
    return find_habit(kPropertyHabits, name);
}

std::string_view block_habit(std::string_view name) {
    return find_habit(kBlockHabits, name);
}

bool is_not_yet_available(BlockKind block, std::string_view property) {
    return std::any_of(kPropertiesNotYet.begin(), kPropertiesNotYet.end(),
                       [&](const FutureProperty& future) {
                           return future.block == block && future.name == property;
                       });
}

bool is_not_yet_available(std::string_view name) {
    return std::find(kNotYet.begin(), kNotYet.end(), name) != kNotYet.end();
}

}  // namespace lray::parser
