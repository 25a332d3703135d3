// What the formatter lays out: tokens and comments, one at a time, each with what the text before
// it says about where it may stand. Separators between items are gone; they are a flag of what
// follows.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/source.h"
#include "parser/symbols.h"
#include "parser/syntax/lexer.h"
#include "parser/syntax/token.h"

namespace lray::parser {

enum class PieceKind : std::uint8_t { token, line_comment, block_comment };

/// What an opening bracket begins.
enum class BracketRole : std::uint8_t { none, block, list, call, other };

struct Piece {
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
    std::uint32_t width = 0;  // columns, as it will be spelled
    PieceKind kind = PieceKind::token;
    TokenKind token = TokenKind::end;
    BracketRole role = BracketRole::none;
    std::uint8_t lines_before =
        0;                      // line ends between it and the piece before: 0, 1, or 2 for more
    std::uint8_t gap = 0;       // blanks before it when it stands on a line with that piece
    bool is_separated = false;  // an item ends before it
    bool is_statement = false;  // begins a statement inside braces, which has its own line
    bool continues = false;     // begins a line that goes on with an item
    bool has_line_end = false;  // a block comment over several lines
    bool is_respelled = false;  // written otherwise than in the source

    bool is_comment() const { return kind != PieceKind::token; }
    bool is_end() const { return kind == PieceKind::token && token == TokenKind::end; }
    bool opens() const { return kind == PieceKind::token && is_opening(token); }
    bool closes() const { return kind == PieceKind::token && is_closing(token); }
};

/// Reads the pieces of a source. Stops with an `end` when the text has a lexical error, or brackets
/// that do not match or are nested too deep.
class PieceReader {
 public:
    PieceReader(const Sources& sources, SourceId source, std::uint32_t max_nesting);

    /// Reads one token and appends what is decided by it, which may be nothing. Behind the last one
    /// it appends `end` again and again.
    void read(std::vector<Piece>& pieces);

    bool has_failed() const { return has_failed_; }

    /// Where brackets do not match, or are nested too deep.
    std::uint32_t failure_offset() const { return previous_end_; }

 private:
    struct Frame {
        TokenKind opener = TokenKind::left_brace;
        BracketRole role = BracketRole::block;
        bool is_if = false;    // the item at hand is a statement `if`
        bool has_for = false;  // of a comprehension
    };
    struct Comma {
        std::uint32_t offset = 0;
        TokenKind kind = TokenKind::comma;
        std::uint8_t lines_before = 0;
        TokenKind previous = TokenKind::nothing;  // the token before it
    };

    bool is_in_braces() const { return frames_.back().opener == TokenKind::left_brace; }
    void fail(std::vector<Piece>& pieces);
    void scan_gap(std::uint32_t begin, std::uint32_t end);
    void add_comment(PieceKind kind, std::uint32_t begin, std::uint32_t end);
    bool takes_separator(const Token& token);
    void place_separator(const Token& token, std::vector<Piece>& pieces);
    void place_comma(const Token& token, std::vector<Piece>& pieces);
    void place_comments(bool continues, std::vector<Piece>& pieces);
    void place_token(const Token& token, std::vector<Piece>& pieces);
    bool track_brackets(const Token& token, BracketRole role);

    Diagnostics diagnostics_;
    Symbols symbols_;
    Lexer lexer_;
    std::string_view text_;
    std::uint32_t max_nesting_;

    std::vector<Frame> frames_{Frame{}};  // the file is the outermost
    std::vector<Piece> comments_;         // of the gap before the token at hand
    std::optional<Comma> separator_;      // between items, not yet placed
    std::optional<Comma> comma_;          // of a list, not yet placed
    std::uint8_t lines_ = 0;              // since the last piece
    std::uint32_t previous_end_ = 0;
    TokenKind previous_ = TokenKind::nothing;
    TokenKind before_previous_ = TokenKind::nothing;
    bool is_previous_sign_ = false;
    bool is_previous_comment_ = false;
    bool is_previous_line_comment_ = false;
    bool is_separated_ = false;  // the next piece begins an item
    bool is_version_next_ = false;
    bool is_step_ = false;  // the next token is the second sign of `i++`
    bool has_failed_ = false;
};

}  // namespace lray::parser
