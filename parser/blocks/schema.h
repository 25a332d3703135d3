// What blocks there are and what may stand in each: one table per block type, which feeds the
// checker, suggestions, defaults and documentation. The tables are in parser/schemas.h.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "parser/symbols.h"

namespace lray::parser {

enum class PropertyType : std::uint8_t {
    number,
    integer,
    boolean,
    string,
    option,         // one of a list of strings
    point,          // three numbers; a colour is not a point
    direction,      // three numbers, not all 0
    vec2,           // two numbers
    size2,          // two numbers greater than 0
    size3,          // three numbers greater than 0
    color,          // colour, number or three numbers
    angle,          // degrees
    scale,          // number or three numbers, none 0
    rotation,       // three angles or a transform
    matrix,         // three or four rows of four numbers
    transform,      // a transform or a list of them
    material,       // a material
    roughness,      // number or two numbers, 0 to 1
    resolution,     // two whole numbers
    file,           // a string that names a file
    points,         // rows of three numbers
    colors,         // a list of colours, or rows of three numbers
    uvs,            // rows of two numbers
    index_triples,  // rows of three whole numbers
    any,            // parameters of components
    function,       // a function
    height_rows,    // two or more rows of numbers, all of one width
    texture,        // a texture
    stops,          // pairs of a place and a colour, the places in order
    focus           // a distance or a point
};

/// Bounds of a number, or of each number of a vector.
struct Range {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool min_is_open = false;

    constexpr bool contains(double x) const {
        return (min_is_open ? x > min : x >= min) && x <= max;
    }
};

inline constexpr Range kAnyNumber{};
inline constexpr Range kPositive{0.0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range kNotNegative{0.0, std::numeric_limits<double>::infinity(), false};
inline constexpr Range kUnit{0.0, 1.0, false};

/// How a block is written: `rectangle` by its centre and size, or by a corner and two edges. A
/// property of one form excludes those of the others. Without any of them a block has its first
/// form.
enum class Form : std::uint8_t { any, first, second, third };
inline constexpr std::size_t kFormCount = 4;

struct PropertySchema {
    std::string_view name{};
    PropertyType type{};
    std::string_view default_text{};  // as it would be written; empty: none
    std::string_view doc{};
    Range range = kAnyNumber;
    std::array<double, 3> default_value{};  // of a number, boolean or vector with a default_text
    bool is_required = false;               // in its form
    Form form = Form::any;
    std::span<const std::string_view> options{};
    bool takes_texture = false;  // in the place of a value of its type
};

/// True for a property that a block of a form (any: of none yet, so of its first) must have.
constexpr bool is_needed(const PropertySchema& property, Form form) {
    const Form meant = form == Form::any ? Form::first : form;
    return property.is_required && (property.form == Form::any || property.form == meant);
}

/// The property, which takes a texture as well.
constexpr PropertySchema or_texture(PropertySchema property) {
    property.takes_texture = true;
    return property;
}

enum class BlockKind : std::uint8_t {
    group,
    sphere,
    rectangle,
    triangle,
    cylinder,
    disk,
    box,
    plane,
    torus,
    mesh,
    heightfield,
    terrain,
    material,
    camera,
    render,
    info,
    image,
    checker,
    stripes,
    gradient,
    ramp,
    noise_texture,
    marble,
    wood,
    vertex_colors,
    point_light,
    spot_light,
    directional_light,
    area_light,
    environment,
    animation,
    record,
    component,  // of the scene; has no table of its own
};
inline constexpr std::size_t kBlockKindCount = static_cast<std::size_t>(BlockKind::component);

constexpr bool is_texture(BlockKind kind) {
    return kind >= BlockKind::image && kind <= BlockKind::vertex_colors;
}
/// A texture that lies in a space, where steps move it.
constexpr bool has_space(BlockKind kind) {
    return is_texture(kind) && kind != BlockKind::vertex_colors;
}
constexpr bool is_light(BlockKind kind) {
    return kind >= BlockKind::point_light && kind <= BlockKind::environment;
}
/// A value of its own kind, which is used and cannot be placed.
constexpr bool is_surface(BlockKind kind) {
    return kind == BlockKind::material || is_texture(kind);
}

/// The most properties a block has: the size of the evaluator's slot array.
inline constexpr std::size_t kMaxProperties = 32;

struct BlockSchema {
    BlockKind kind{};
    std::string_view name{};
    std::string_view doc{};
    std::span<const PropertySchema> properties{};

    bool is_placeable = false;  // a shape, a group or a light
    bool has_children = false;
    bool takes_any_string = false;  // `info`: any name, a string each
    bool takes_any_value = false;   // `record`: any name, any value
};

/// Properties that every placeable block has besides its own. Transform steps are the only ones
/// that may be repeated, and the only ones whose order matters.
enum class CommonProperty : std::uint8_t {
    translate,
    scale,
    rotate_x,
    rotate_y,
    rotate_z,
    rotate,
    matrix,
    transform,
    look_at,
    material,
    visible,
    casts_shadow,
};
inline constexpr std::size_t kCommonPropertyCount = 12;

constexpr bool is_transform_step(CommonProperty property) {
    return property <= CommonProperty::look_at;
}

/// True for the common properties that a block has: shapes and groups all of them, lights no
/// material, and only those that shine one way `look_at`, textures that lie in a space the
/// transform steps.
constexpr bool takes(const BlockSchema& schema, CommonProperty property) {
    if (is_texture(schema.kind)) {
        return has_space(schema.kind) && is_transform_step(property) &&
               property != CommonProperty::look_at;
    }
    if (is_light(schema.kind)) {
        const bool has_direction =
            schema.kind == BlockKind::spot_light || schema.kind == BlockKind::directional_light;
        return property != CommonProperty::material &&
               (property != CommonProperty::look_at || has_direction);
    }
    return schema.is_placeable;
}

/// Shape: in the order of CommonProperty.
std::span<const PropertySchema> common_properties();

inline const PropertySchema& common_schema(CommonProperty property) {
    return common_properties()[static_cast<std::size_t>(property)];
}

/// Shape: in the order of BlockKind.
std::span<const BlockSchema> block_schemas();

const BlockSchema& block_schema(BlockKind kind);

/// Returns the schema of the built-in block that a symbol names; null if it names none.
const BlockSchema* find_block(Symbol symbol);

/// Returns the schema of a built-in block; null if there is none of that name.
const BlockSchema* find_block(std::string_view name);

/// Index of a property in a block's own table; its size if there is none of that name.
constexpr std::size_t find_property(std::span<const PropertySchema> properties,
                                    std::string_view name) {
    // Size and first letter tell almost all apart without a call.
    const auto is_it = [name](std::string_view known) {
        return known.size() == name.size() && known.front() == name.front() && known == name;
    };
    std::size_t slot = 0;
    while (slot < properties.size() && !is_it(properties[slot].name)) ++slot;
    return slot;
}

/// Returns what other tools' users mean by a property name (`color` -> `diffuse`), one of the
/// block's own properties first; empty if nothing is known.
std::string_view property_habit(std::string_view name, const BlockSchema& schema);

/// Returns what a block name from other tools is called here, to stand between back quotes; empty
/// if nothing is known.
std::string_view block_habit(std::string_view name);

/// True for a block or function of the language that this version does not have.
bool is_not_yet_available(std::string_view name);

/// True for a property of the language that this version does not have in this block.
bool is_not_yet_available(BlockKind block, std::string_view property);

}  // namespace lray::parser
