#include "parser/reference.h"

#include <fmt/format.h>

#include <cmath>

#include "base/assert.h"
#include "parser/blocks/schema.h"
#include "parser/builtins/builtins.h"

namespace lray::parser {

namespace {

/// "greater than 0", "0 to 1"; empty where any number will do.
std::string in_words(const Range& range) {
    const bool has_min = std::isfinite(range.min);
    const bool has_max = std::isfinite(range.max);
    if (has_min && has_max) {
        return fmt::format("{}{} to {}", range.min_is_open ? "above " : "", range.min, range.max);
    }
    if (has_min)
        return fmt::format("{} {}", range.min_is_open ? "greater than" : "at least", range.min);
    return has_max ? fmt::format("at most {}", range.max) : std::string();
}

std::string type_of(const PropertySchema& property) {
    std::string text(type_name(property.type));
    for (std::size_t i = 0; i < property.options.size(); ++i) {
        text += fmt::format("{} \"{}\"", i == 0 ? "" : ",", property.options[i]);
    }
    const std::string range = in_words(property.range);
    if (!range.empty()) text += fmt::format(", {}", range);
    return text;
}

std::string default_of(const PropertySchema& property, bool has_forms) {
    if (!property.default_text.empty()) return fmt::format("default {}", property.default_text);
    if (!property.is_required) return {};
    return has_forms && property.form != Form::any ? "required in its form" : "required";
}

bool has_forms(const BlockSchema& block) {
    for (const PropertySchema& property : block.properties) {
        if (property.form == Form::second) return true;
    }
    return false;
}

std::string describe_property(const PropertySchema& property, bool has_forms) {
    const std::string given = default_of(property, has_forms);
    return fmt::format("  {:<14} {}\n{:17}{}{}{}\n", property.name, property.doc, "",
                       type_of(property), given.empty() ? "" : "; ", given);
}

/// The ways to write a block, as the names that go together.
std::string describe_forms(const BlockSchema& block) {
    std::string first;
    std::string second;
    for (const PropertySchema& property : block.properties) {
        if (property.form == Form::any) continue;
        std::string& names = property.form == Form::first ? first : second;
        names += fmt::format("{}`{}`", names.empty() ? "" : ", ", property.name);
    }
    return fmt::format("Either {}, or {}.\n", first, second);
}

}  // namespace

std::string_view type_name(PropertyType type) {
    switch (type) {
        case PropertyType::number:
            return "number";
        case PropertyType::integer:
            return "whole number";
        case PropertyType::boolean:
            return "`true` or `false`";
        case PropertyType::string:
            return "string";
        case PropertyType::option:
            return "one of";
        case PropertyType::point:
            return "point";
        case PropertyType::direction:
            return "direction";
        case PropertyType::vec2:
        case PropertyType::size2:
            return "2 numbers";
        case PropertyType::size3:
            return "3 numbers";
        case PropertyType::color:
            return "colour";
        case PropertyType::angle:
            return "degrees";
        case PropertyType::scale:
            return "number or 3 numbers, none 0";
        case PropertyType::rotation:
            return "3 angles, or a transform";
        case PropertyType::matrix:
            return "3 or 4 rows of 4 numbers";
        case PropertyType::transform:
            return "transform, or a list of them";
        case PropertyType::material:
            return "material";
        case PropertyType::roughness:
            return "number or 2 numbers";
        case PropertyType::resolution:
            return "2 whole numbers";
        case PropertyType::file:
            return "path";
        case PropertyType::points:
            return "rows of 3 numbers";
        case PropertyType::colors:
            return "list of colours";
        case PropertyType::uvs:
            return "rows of 2 numbers";
        case PropertyType::any:
            return "any value";
        case PropertyType::index_triples:
            return "rows of 3 whole numbers";
        case PropertyType::function:
            return "function";
        case PropertyType::height_rows:
            return "rows of numbers";
        case PropertyType::texture:
            return "texture";
        case PropertyType::stops:
            return "pairs of place and colour";
        case PropertyType::focus:
            return "distance or point";
    }
    LRAY_ASSERT(false);
}

std::string_view type_name(ParameterType type) {
    switch (type) {
        case ParameterType::number:
            return "number";
        case ParameterType::elements:
            return "number or vector";
        case ParameterType::vector:
            return "vector";
        case ParameterType::vec3:
            return "3 numbers";
        case ParameterType::color:
            return "colour";
        case ParameterType::transform:
            return "transform";
        case ParameterType::rows:
            return "3 or 4 rows of 4 numbers";
        case ParameterType::any_scale:
            return "number or 3 numbers";
        case ParameterType::any:
            return "any value";
        case ParameterType::integer:
            return "whole number";
        case ParameterType::string:
            return "string";
        case ParameterType::list:
            return "list";
        case ParameterType::numbers:
            return "list of numbers";
        case ParameterType::function:
            return "function";
        case ParameterType::node:
            return "node";
        case ParameterType::position:
            return "number or 2 or 3 numbers";
        case ParameterType::key:
            return "number or string";
        case ParameterType::boolean:
            return "`true` or `false`";
        case ParameterType::blendable:
            return "number, vector or colour";
        case ParameterType::points:
            return "rows of 3 numbers";
    }
    LRAY_ASSERT(false);
}

std::optional<std::string> describe_block(std::string_view name) {
    const BlockSchema* const block = find_block(name);
    if (block == nullptr) return std::nullopt;
    std::string text = fmt::format("{} {{ ... }}: {}\n", block->name, block->doc);
    const bool is_either_or = has_forms(*block);
    if (is_either_or) text += fmt::format("\n{}", describe_forms(*block));
    if (!block->properties.empty()) text += "\nProperties:\n\n";
    for (const PropertySchema& property : block->properties) {
        text += describe_property(property, is_either_or);
    }
    if (block->takes_any_string) text += "\nAny property of any name, a string each.\n";
    if (block->is_placeable) {
        text +=
            "\nProperties of everything that is placed; steps are done in the order written:\n\n";
        for (const PropertySchema& property : common_properties()) {
            text += describe_property(property, false);
        }
    }
    if (block->has_children) text += "\nOther things may stand inside.\n";
    return text;
}

std::optional<std::string> describe_function(std::string_view name) {
    const auto index = find_builtin(name);
    if (!index) return std::nullopt;
    const Builtin& builtin = builtins()[*index];
    std::string signature;
    std::string parameters;
    for (std::size_t i = 0; i < builtin.parameter_count(); ++i) {
        const Parameter& parameter = builtin.parameters[i];
        signature += fmt::format("{}{}", i == 0 ? "" : ", ", parameter.name);
        parameters += fmt::format("  {:<14} {}{}\n", parameter.name, type_name(parameter.type),
                                  parameter.is_optional ? "; may be left out" : "");
    }
    if (builtin.is_variadic) {
        signature += fmt::format("{}...", signature.empty() ? "" : ", ");
        parameters +=
            fmt::format("  {:<14} {}; any number of them\n", "...", type_name(builtin.rest_type));
    }
    return fmt::format("{}({}): {}\n{}{}", builtin.name, signature, builtin.doc,
                       parameters.empty() ? "" : "\n", parameters);
}

}  // namespace lray::parser
