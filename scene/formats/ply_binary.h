// The rows of a PLY file in binary.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/source.h"
#include "scene/formats/ply_header.h"
#include "scene/formats/ply_layout.h"
#include "scene/formats/ply_mesh_builder.h"
#include "scene/formats/ply_mistakes.h"
#include "scene/formats/ply_row.h"

namespace lray::scene::ply {

/// Each function takes where the rows of an element begin and returns where they end; null when a
/// mistake was told.
class BinaryRows {
 public:
    BinaryRows(const Text& text, const Header& header, const Layout& layout, MeshBuilder& builder,
               Mistakes& mistakes)
        : end_(text.data() + text.size()),
          header_(header),
          layout_(layout),
          is_swapped_(header.coding == Coding::big_endian),
          builder_(builder),
          mistakes_(mistakes) {}

    const char* skip(std::size_t element, const char* at);
    const char* read_vertices(const char* at);
    const char* read_indices(const IndexLists& lists, const char* at);

 private:
    struct List {
        const char* begin = nullptr;  // of the items; null when a mistake was told
        std::size_t count = 0;
        const char* end = nullptr;
    };

    std::size_t left(const char* at) const { return static_cast<std::size_t>(end_ - at); }
    const Element& element() const { return header_.elements[element_]; }

    void begin_element(std::size_t element);
    const char* skip_row(const char* at, char* packed);
    const char* read_index_row(const IndexLists& lists, const char* at);
    List find_list(const RowStep& step, const char* at);
    bool add_list(bool are_strips, Type type, const List& list);
    template <class Count, bool is_swapped>
    const char* read_triangles(const char* at);
    std::size_t count_triangles(const char* at) const;

    void fill(VertexBlock& block, const char* rows, std::size_t row_size) const;

    const char* ends_early(const char* at);
    const char* wrong_vertex(const char* at, std::size_t number);

    const char* const end_;
    const Header& header_;
    const Layout& layout_;
    const bool is_swapped_;
    MeshBuilder& builder_;
    Mistakes& mistakes_;

    std::size_t element_ = 0;  // the one that is read
    RowPlan plan_{};
    std::uint64_t row_ = 0;  // of the element
    std::vector<std::uint32_t> corners_{};
};

}  // namespace lray::scene::ply
