#include "parser/tools/format_layout.h"

#include "base/assert.h"
#include "parser/tools/format_spelling.h"

namespace lray::parser {

namespace {

constexpr std::int32_t kIndent = 2;

}  // namespace

LayoutEnd Layout::run() {
    constexpr std::size_t kMaxPlaced = 4096;  // kept before the buffer is moved down
    text_.reserve(source_.size() + source_.size() / 16 + 64);
    Frame file;
    file.indent = -kIndent;
    frames_.push_back(file);
    for (;;) {
        const Piece piece = peek(0);
        if (piece.is_end()) break;
        place(piece);
        if (text_.size() > max_size_) return LayoutEnd::too_large;
        ++head_;
        if (head_ > kMaxPlaced) {
            pieces_.erase(pieces_.begin(), pieces_.begin() + static_cast<std::ptrdiff_t>(head_));
            head_ = 0;
        }
    }
    if (reader_.has_failed()) return LayoutEnd::failed;
    if (!text_.empty()) text_ += '\n';
    return LayoutEnd::done;
}

void Layout::place(const Piece& piece) {
    if (text_.empty()) {
        line_indent_ = 0;
    } else if (!frames_.back().is_flat && breaks_before(piece)) {
        break_line(piece);
    } else {
        append_gap(piece);
    }
    Frame& frame = frames_.back();
    if (frame.is_first || frame.is_behind_comma) frame.element_line = line_;
    frame.is_first = false;
    frame.is_behind_comma = piece.token == TokenKind::comma;
    append(piece);
    is_behind_line_comment_ = piece.kind == PieceKind::line_comment;
    is_behind_opener_ = piece.opens();
    if (piece.opens()) {
        open(piece);
    } else if (piece.closes()) {
        LRAY_ASSERT(frames_.size() > 1);
        frames_.pop_back();
    }
}

void Layout::append_gap(const Piece& piece) {
    if (piece.gap == 0) return;
    // Between the items of a block on one line; any other item has its own line.
    const bool ends_item = piece.gap == 2 && piece.kind != PieceKind::line_comment;
    if (!ends_item) {
        text_.append(piece.gap, ' ');
    } else {
        text_ += frames_.back().is_flat ? ", " : " ";
    }
    column_ += piece.gap;
}

bool Layout::breaks_before(const Piece& piece) {
    const Frame& frame = frames_.back();
    if (is_behind_line_comment_) return true;
    if (frame.opener == TokenKind::left_brace) {
        if (piece.closes()) return true;
        if (!frame.is_first && piece.lines_before == 0 && !piece.is_separated) return false;
        return !is_trailing(piece);
    }
    if (piece.closes()) return frame.is_broken || piece.lines_before > 0;
    if (frame.is_first) return (frame.is_broken || piece.lines_before > 0) && !is_trailing(piece);
    if (piece.lines_before > 0) return true;
    if (!frame.fills || !frame.is_behind_comma || is_trailing(piece)) return false;
    return (frame.is_broken && frame.element_line != line_) || !fits_element(piece);
}

// True for a comment behind which its line ends.
bool Layout::is_trailing(const Piece& piece) {
    if (!piece.is_comment() || piece.lines_before > 0) return false;
    if (piece.kind == PieceKind::line_comment) return true;
    for (std::size_t i = 1;; ++i) {
        const Piece& next = peek(i);
        if (next.lines_before > 0 || next.is_end()) return true;
        if (next.kind == PieceKind::line_comment) return true;
        if (next.kind == PieceKind::token) return next.token == TokenKind::right_brace;
    }
}

void Layout::break_line(const Piece& piece) {
    const Frame& frame = frames_.back();
    const bool keeps_blank_line =
        piece.lines_before > 1 && !is_behind_opener_ && !piece.closes() && !piece.continues;
    text_ += keeps_blank_line ? "\n\n" : "\n";
    line_indent_ = frame.indent;
    if (!piece.closes()) line_indent_ += kIndent;
    if (piece.continues) line_indent_ += kIndent;
    LRAY_ASSERT(line_indent_ >= 0);
    text_.append(static_cast<std::size_t>(line_indent_), ' ');
    column_ = static_cast<std::uint32_t>(line_indent_);
    ++line_;
}

void Layout::append(const Piece& piece) {
    const std::string_view text = source_.substr(piece.offset, piece.length);
    if (!piece.is_respelled) {
        text_ += text;
    } else if (piece.token == TokenKind::number) {
        append_number(text_, text);
    } else if (piece.token == TokenKind::color) {
        append_color(text_, text);
    } else {
        append_comment(text_, text);
        column_ = 0;
        ++line_;
    }
    column_ += piece.width;
}

// Decides how what an opening bracket begins is laid out.
void Layout::open(const Piece& piece) {
    Frame frame;
    frame.opener = piece.token;
    frame.indent = line_indent_;
    frame.is_flat = frames_.back().is_flat;
    if (!frame.is_flat) {
        const Fit fit = measure_brackets();
        const bool is_list =
            (piece.role == BracketRole::list && peek(1).token != TokenKind::kw_for) ||
            piece.role == BracketRole::call;
        frame.is_flat = fit == Fit::fits;
        frame.fills = is_list;
        frame.is_broken = is_list && fit == Fit::too_wide;
    }
    frames_.push_back(frame);
}

// The brackets that the piece at hand opens, and what is glued to them. Whatever is wider than a
// line when first written is wider when it is read again, for all that is left out here only makes
// it narrower: so the second run over a text changes nothing.
Layout::Fit Layout::measure_brackets() {
    std::uint32_t column = column_;
    std::size_t i = 1;
    if (peek(1).closes()) return Fit::fits;
    for (std::uint32_t depth = 1; depth > 0; ++i) {
        const Piece& piece = peek(i);
        if (piece.is_end()) return Fit::has_line_end;
        const bool is_empty = piece.closes() && pieces_[head_ + i - 1].opens();
        const bool ends_line = (piece.lines_before > 0 && !is_empty) || piece.is_statement ||
                               piece.has_line_end || piece.kind == PieceKind::line_comment;
        if (ends_line) return Fit::has_line_end;
        column += piece.gap + piece.width;
        if (column > kMaxWidth) return Fit::too_wide;
        if (piece.opens()) ++depth;
        if (piece.closes()) --depth;
    }
    for (;; ++i) {
        const Piece& piece = peek(i);
        if (piece.lines_before > 0 || piece.is_comment()) break;
        const bool is_closer = piece.closes() && piece.token != TokenKind::right_brace;
        if (!is_closer && piece.token != TokenKind::comma && piece.token != TokenKind::left_brace) {
            break;
        }
        column += piece.gap + piece.width;
        if (!is_closer) break;
        if (column > kMaxWidth) break;
    }
    return column > kMaxWidth ? Fit::too_wide : Fit::fits;
}

// True if an element of a list can stand on the line at hand, or its first line can.
bool Layout::fits_element(const Piece& first) {
    std::uint32_t column = column_ + first.gap;
    std::uint32_t depth = 0;
    for (std::size_t i = 0;; ++i) {
        const Piece& piece = peek(i);
        const bool is_empty = i > 0 && piece.closes() && pieces_[head_ + i - 1].opens();
        const bool ends_line = (i > 0 && piece.lines_before > 0 && !is_empty) ||
                               piece.is_statement || piece.kind == PieceKind::line_comment;
        if (ends_line || piece.is_end()) return true;
        column += (i > 0 ? piece.gap : 0u) + piece.width;
        if (column > kMaxWidth) return false;
        if (piece.has_line_end) return true;
        if (depth == 0 && (piece.closes() || piece.token == TokenKind::comma)) return true;
        if (piece.opens()) ++depth;
        if (piece.closes()) --depth;
    }
}

}  // namespace lray::parser
