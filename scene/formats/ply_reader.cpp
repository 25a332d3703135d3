#include "scene/formats/ply_reader.h"

#include <algorithm>
#include <vector>

#include "base/assert.h"
#include "scene/formats/ply_ascii.h"
#include "scene/formats/ply_binary.h"
#include "scene/formats/ply_header.h"
#include "scene/formats/ply_layout.h"
#include "scene/formats/ply_mesh_builder.h"
#include "scene/formats/ply_mistakes.h"

namespace lray::scene {

namespace ply {

namespace {

/// Reads all elements; those that name vertices before these are read when they are there.
/// Returns false when a mistake was told.
template <class Rows>
bool read_elements(const Header& header, const Layout& layout, Rows rows) {
    struct Late {
        const IndexLists* lists = nullptr;
        const char* begin = nullptr;
    };
    std::vector<Late> late;
    const char* at = header.body;
    for (std::size_t i = 0; i < header.elements.size() && at != nullptr; ++i) {
        const auto lists = std::find_if(layout.index_lists.begin(), layout.index_lists.end(),
                                        [&](const IndexLists& l) { return l.element == i; });
        if (i == layout.vertex_element) {
            at = rows.read_vertices(at);
        } else if (lists == layout.index_lists.end()) {
            at = rows.skip(i, at);
        } else if (i < layout.vertex_element) {
            late.push_back({&*lists, at});
            at = rows.skip(i, at);
        } else {
            at = rows.read_indices(*lists, at);
        }
    }
    if (at == nullptr) return false;
    return std::all_of(late.begin(), late.end(), [&](const Late& element) {
        return rows.read_indices(*element.lists, element.begin) != nullptr;
    });
}

std::optional<Mesh> read(const Text& text, Mistakes& mistakes) {
    const std::optional<Header> header = read_header(text, mistakes);
    if (!header) return {};
    const std::optional<Layout> layout = find_layout(*header, mistakes);
    if (!layout) return {};
    MeshBuilder builder(*layout);
    const bool is_read =
        header->coding == Coding::ascii
            ? read_elements(*header, *layout, AsciiRows(text, *header, *layout, builder, mistakes))
            : read_elements(*header, *layout,
                            BinaryRows(text, *header, *layout, builder, mistakes));
    if (!is_read) return {};
    std::optional<Mesh> mesh = builder.finish();
    if (!mesh) {
        const Element& faces = header->elements[layout->index_lists[0].element];
        mistakes.in_text(Code::E0704, faces.line, "this file has no faces");
    }
    return mesh;
}

}  // namespace

}  // namespace ply

std::optional<Mesh> read_ply(const Sources& sources, SourceId file, Span loaded_at,
                             Diagnostics& diagnostics) {
    const Text& text = sources[file].text;
    ply::Mistakes mistakes(text, file, loaded_at, diagnostics);
    std::optional<Mesh> mesh = ply::read(text, mistakes);
    LRAY_ASSERT(mesh.has_value() != mistakes.are_any());
    return mesh;
}

}  // namespace lray::scene
