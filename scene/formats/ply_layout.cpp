#include "scene/formats/ply_layout.h"

#include <algorithm>
#include <span>
#include <string_view>

#include <fmt/format.h>

namespace lray::scene::ply {

namespace {

std::size_t find_property(const Element& element, std::string_view name, bool is_list) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const Property& property = element.properties[i];
        if (property.name == name && property.is_list == is_list) return i;
    }
    return Layout::kNone;
}

/// Gives slots from `first` on the properties of these names, if all are there.
bool find_slots(const Element& vertex, Slot first, std::span<const std::string_view> names,
                Layout& layout) {
    const std::size_t begin = static_cast<std::size_t>(first);
    for (std::size_t i = 0; i < names.size(); ++i) {
        layout.properties[begin + i] = find_property(vertex, names[i], false);
    }
    const auto slots = std::span(layout.properties).subspan(begin, names.size());
    if (std::find(slots.begin(), slots.end(), Layout::kNone) == slots.end()) return true;
    std::fill(slots.begin(), slots.end(), Layout::kNone);
    return false;
}

double full_brightness(Type type) {
    if (type == Type::float32 || type == Type::float64) return 1.0;
    return type == Type::uint16 ? 65535.0 : 255.0;
}

void find_attributes(const Element& vertex, Layout& layout) {
    using Names = std::array<std::string_view, 3>;
    using Pair = std::array<std::string_view, 2>;
    (void)find_slots(vertex, Slot::nx, Names{"nx", "ny", "nz"}, layout);
    const bool has_colors =
        find_slots(vertex, Slot::red, Names{"red", "green", "blue"}, layout) ||
        find_slots(vertex, Slot::red, Names{"diffuse_red", "diffuse_green", "diffuse_blue"},
                   layout);
    if (has_colors) {
        const std::size_t red = layout.properties[static_cast<std::size_t>(Slot::red)];
        layout.color_scale = full_brightness(vertex.properties[red].type);
    }
    for (const Pair& names : {Pair{"u", "v"}, Pair{"s", "t"}, Pair{"texture_u", "texture_v"},
                              Pair{"texture_s", "texture_t"}}) {
        if (find_slots(vertex, Slot::u, names, layout)) break;
    }
}

/// Returns false when a mistake was told.
bool find_positions(const Element& vertex, Layout& layout, Mistakes& mistakes) {
    constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
    if (find_slots(vertex, Slot::x, kNames, layout)) return true;
    for (const std::string_view name : kNames) {
        if (find_property(vertex, name, false) != Layout::kNone) continue;
        mistakes.in_text(Code::E0701, vertex.line,
                         fmt::format("a vertex has the properties `x`, `y` and `z`; here is no "
                                     "`{}`",
                                     name));
        break;
    }
    return false;
}

/// Returns false when a mistake was told.
bool find_indices(const Header& header, std::size_t element_index, bool are_strips, Layout& layout,
                  Mistakes& mistakes) {
    const Element& element = header.elements[element_index];
    std::size_t property = find_property(element, "vertex_indices", true);
    if (property == Layout::kNone) property = find_property(element, "vertex_index", true);
    if (property == Layout::kNone) {
        if (element.count == 0) return true;
        mistakes.in_text(Code::E0701, element.line,
                         fmt::format("a {} has a list `vertex_indices`; here is none",
                                     are_strips ? "strip" : "face"));
        return false;
    }
    if (!is_whole(element.properties[property].type)) {
        mistakes.in_text(Code::E0701, element.properties[property].line,
                         "the numbers of vertices are whole: `int`, not `float`");
        return false;
    }
    layout.index_lists.push_back({element_index, property, are_strips});
    return true;
}

}  // namespace

std::optional<Layout> find_layout(const Header& header, Mistakes& mistakes) {
    Layout layout;
    layout.properties.fill(Layout::kNone);
    const auto vertex = std::find_if(header.elements.begin(), header.elements.end(),
                                     [](const Element& e) { return e.name == "vertex"; });
    if (vertex == header.elements.end()) {
        mistakes.in_text(Code::E0701, header.end_line, "this file has no element `vertex`");
        return {};
    }
    layout.vertex_element = static_cast<std::size_t>(vertex - header.elements.begin());
    if (!find_positions(*vertex, layout, mistakes)) return {};
    find_attributes(*vertex, layout);
    for (std::size_t i = 0; i < header.elements.size(); ++i) {
        const std::string_view name = header.elements[i].name;
        const bool are_strips = name == "tristrips";
        if (name != "face" && !are_strips) continue;
        if (!find_indices(header, i, are_strips, layout, mistakes)) return {};
    }
    if (layout.index_lists.empty()) {
        mistakes.in_text(Code::E0704, header.end_line,
                         "this file has points only: no element `face` or `tristrips`");
        return {};
    }
    return layout;
}

}  // namespace lray::scene::ply
