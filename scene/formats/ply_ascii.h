// The rows of a PLY file in text: one on a line.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/source.h"
#include "scene/formats/ply_header.h"
#include "scene/formats/ply_layout.h"
#include "scene/formats/ply_mesh_builder.h"
#include "scene/formats/ply_mistakes.h"

namespace lray::scene::ply {

/// Each function takes where the rows of an element begin and returns where they end; null when a
/// mistake was told. Lines without anything are skipped, and so is what follows on a line behind
/// its values.
class AsciiRows {
 public:
    AsciiRows(const Text& text, const Header& header, const Layout& layout, MeshBuilder& builder,
              Mistakes& mistakes)
        : end_(text.data() + text.size()),
          header_(header),
          layout_(layout),
          builder_(builder),
          mistakes_(mistakes) {}

    const char* skip(std::size_t element, const char* at);
    const char* read_vertices(const char* at);
    const char* read_indices(const IndexLists& lists, const char* at);

 private:
    const Element& element() const { return header_.elements[element_]; }

    bool begin_row();
    bool begin_value();
    void end_row();
    std::optional<double> read_number();
    std::optional<std::int64_t> read_whole();
    std::optional<std::uint64_t> read_count(const Property& property);
    bool skip_list(const Property& property);
    bool read_index_list(bool are_strips, const Property& property);
    bool add_vertices(VertexBlock& block);
    std::string_view word() const;
    bool wrong(std::string_view place, std::string message, Code code = Code::E0701);

    const char* const end_;
    const Header& header_;
    const Layout& layout_;
    MeshBuilder& builder_;
    Mistakes& mistakes_;

    const char* at_ = nullptr;
    std::size_t element_ = 0;  // the one that is read
    std::uint64_t row_ = 0;    // of the element
    const char* row_begin_ = nullptr;
    std::size_t value_count_ = 0;  // read in the row
    std::vector<std::uint32_t> corners_{};
    std::array<std::string_view, VertexBlock::kCapacity> lines_{};  // of a block
};

}  // namespace lray::scene::ply
