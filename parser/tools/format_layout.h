// Where the formatter breaks lines, and how far they are indented.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "parser/tools/format_pieces.h"

namespace lray::parser {

enum class LayoutEnd : std::uint8_t { done, failed, too_large };

/// Lays out pieces in one pass. Looks ahead by one line of text, so that time is linear, and memory
/// is that of the text and of the nesting.
class Layout {
 public:
    static constexpr std::uint32_t kMaxWidth = 100;  // columns

    Layout(std::string_view source, PieceReader& reader, std::uint64_t max_size)
        : source_(source), reader_(reader), max_size_(max_size) {}

    /// Reads to the end, or to where the reader fails, or the text is longer than allowed.
    LayoutEnd run();

    std::string take_text() { return std::move(text_); }

 private:
    struct Frame {
        TokenKind opener = TokenKind::left_brace;
        std::int32_t indent = 0;  // of the line of the opening bracket
        bool is_flat = false;     // on one line
        bool is_first = true;     // nothing was placed yet
        bool fills = false;       // a list: breaks where a line is full
        bool is_broken = false;   // of a list: its brackets stand on lines of their own
        bool is_behind_comma = false;
        std::uint32_t element_line = 0;  // where the element at hand begins
    };
    enum class Fit : std::uint8_t { fits, too_wide, has_line_end };

    /// The i-th piece that is not placed yet; the reference is valid until the next call.
    const Piece& peek(std::size_t i) {
        while (head_ + i >= pieces_.size()) reader_.read(pieces_);
        return pieces_[head_ + i];
    }

    void place(const Piece& piece);
    bool breaks_before(const Piece& piece);
    bool is_trailing(const Piece& piece);
    void break_line(const Piece& piece);
    void append_gap(const Piece& piece);
    void append(const Piece& piece);
    void open(const Piece& piece);
    Fit measure_brackets();
    bool fits_element(const Piece& first);

    std::string_view source_;
    PieceReader& reader_;
    std::uint64_t max_size_;

    std::vector<Piece> pieces_;  // read, from head_ on not yet placed
    std::size_t head_ = 0;
    std::vector<Frame> frames_;
    std::string text_;
    std::uint32_t column_ = 0;
    std::uint32_t line_ = 0;
    std::int32_t line_indent_ = 0;
    bool is_behind_line_comment_ = false;
    bool is_behind_opener_ = false;
};

}  // namespace lray::parser
