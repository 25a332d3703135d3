#include "parser/tools/format_pieces.h"

#include <algorithm>
#include <utility>

#include "parser/syntax/characters.h"
#include "parser/tools/format_spelling.h"

namespace lray::parser {

namespace {

using enum TokenKind;

constexpr std::uint8_t kMaxLines = 2;  // more blank lines are one

/// What an expression may end with.
constexpr bool ends_operand(TokenKind kind) {
    return is_one_of(kind, identifier, number, string, color, kw_true, kw_false, right_brace,
                     right_bracket, right_paren);
}

constexpr bool ends_item(TokenKind kind) {
    return ends_operand(kind) || is_one_of(kind, kw_break, kw_continue, kw_return);
}

constexpr bool starts_item(TokenKind kind) {
    return kind == identifier ||
           (is_keyword(kind) && !is_one_of(kind, kw_then, kw_else, kw_and, kw_or, kw_not, kw_true,
                                           kw_false, kw_as, kw_in));
}

constexpr bool starts_operand(TokenKind kind) {
    return is_one_of(kind, identifier, number, string, color, kw_true, kw_false, left_paren,
                     left_bracket);
}

/// The item goes on behind it, also on the next line.
constexpr bool continues_behind(TokenKind kind) {
    return (kind >= colon && kind <= foreign && kind != dot) || kind == comma ||
           is_one_of(kind, kw_then, kw_else, kw_and, kw_or, kw_not, kw_as, kw_in);
}

/// What calls and indices stand behind.
constexpr bool ends_head(TokenKind kind) {
    return is_one_of(kind, identifier, right_brace, right_bracket, right_paren);
}

BracketRole role_of(TokenKind kind, TokenKind previous) {
    if (kind == left_brace) return BracketRole::block;
    if (kind == left_bracket) return ends_head(previous) ? BracketRole::other : BracketRole::list;
    if (kind != left_paren) return BracketRole::none;
    return ends_head(previous) || previous == kw_fn ? BracketRole::call : BracketRole::other;
}

/// Blanks between two tokens on one line. What would be another token when glued is not.
std::uint8_t gap_between(TokenKind previous, bool is_sign, TokenKind next, BracketRole role) {
    if (is_one_of(previous, left_paren, left_bracket)) return 0;
    if (is_one_of(next, right_paren, right_bracket, comma, semicolon, colon)) return 0;
    if (next == dot) return ends_head(previous) ? 0 : 1;
    if (previous == dot) return next == identifier || is_keyword(next) ? 0 : 1;
    if (is_sign) return starts_operand(next) ? 0 : 1;
    if (next == left_paren) return role == BracketRole::call ? 0 : 1;
    if (next == left_bracket) return role == BracketRole::list ? 1 : 0;
    return 1;
}

}  // namespace

PieceReader::PieceReader(const Sources& sources, SourceId source, std::uint32_t max_nesting)
    : lexer_(sources, source, symbols_, diagnostics_),
      text_(sources[source].text.view()),
      max_nesting_(max_nesting) {
    if (text_.starts_with("\xEF\xBB\xBF")) previous_end_ = 3;
}

void PieceReader::fail(std::vector<Piece>& pieces) {
    has_failed_ = true;
    pieces.emplace_back();
}

void PieceReader::read(std::vector<Piece>& pieces) {
    if (has_failed_) return fail(pieces);
    const Token token = lexer_.next();
    if (diagnostics_.has_errors()) return fail(pieces);
    scan_gap(previous_end_, token.offset);
    previous_end_ = token.end();
    if (takes_separator(token)) {
        // What is written between two separators is the begin of an item.
        if (!comments_.empty() && separator_) place_separator(Token{}, pieces);
        if (comma_) place_comma(token, pieces);  // of `for i,`, before what separates
        place_comments(false, pieces);
        if (!separator_) {
            separator_ = Comma{token.offset, token.kind, lines_, previous_};
        } else {
            separator_->lines_before = std::max(separator_->lines_before, lines_);
        }
        lines_ = 0;
        return;
    }
    place_token(token, pieces);
}

// Splits what stands between two tokens into comments and line ends.
void PieceReader::scan_gap(std::uint32_t begin, std::uint32_t end) {
    comments_.clear();
    const char* const text = text_.data();
    std::uint32_t at = begin;
    while (at < end) {
        const char c = text[at];
        if (c == '\n' || c == '\r') {
            at += c == '\r' && at + 1 < end && text[at + 1] == '\n' ? 2 : 1;
            if (lines_ < kMaxLines) ++lines_;
        } else if (c == '/' && at + 1 < end && text[at + 1] == '/') {
            const std::uint32_t from = at;
            while (at < end && text[at] != '\n' && text[at] != '\r') ++at;
            std::uint32_t to = at;
            while (is_a(text[to - 1], kBlank)) --to;
            add_comment(PieceKind::line_comment, from, to);
        } else if (c == '/' && at + 1 < end && text[at + 1] == '*') {
            const std::uint32_t from = at;
            unsigned depth = 0;
            do {
                const bool is_mark = at + 1 < end;
                if (is_mark && text[at] == '/' && text[at + 1] == '*') {
                    ++depth;
                    at += 2;
                } else if (is_mark && text[at] == '*' && text[at + 1] == '/') {
                    --depth;
                    at += 2;
                } else {
                    ++at;
                }
            } while (depth > 0 && at < end);
            add_comment(PieceKind::block_comment, from, at);
        } else {
            ++at;
        }
    }
}

void PieceReader::add_comment(PieceKind kind, std::uint32_t begin, std::uint32_t end) {
    const std::string_view text = text_.substr(begin, end - begin);
    Piece piece;
    piece.kind = kind;
    piece.token = nothing;
    piece.offset = begin;
    piece.length = end - begin;
    piece.has_line_end = text.find_first_of("\r\n") != text.npos;
    piece.is_respelled = piece.has_line_end;
    // Of several lines the last one is what the rest of the line stands behind.
    piece.width = text_width(text.substr(text.find_last_of("\r\n") + 1));
    piece.lines_before = lines_;
    lines_ = 0;
    comments_.push_back(piece);
}

// True for a `,` or `;` between items; not for the comma of `for i, x in`.
bool PieceReader::takes_separator(const Token& token) {
    if (!is_one_of(token.kind, comma, semicolon) || !is_in_braces()) return false;
    return !(previous_ == identifier && before_previous_ == kw_for && !separator_);
}

// Decides about the separators before this token. Where a line end would not do the same, as in
// `a: 1, 2`, one of them stays.
void PieceReader::place_separator(const Token& token, std::vector<Piece>& pieces) {
    const Comma separator = *separator_;
    separator_.reset();
    const bool begins_block = is_one_of(previous_, left_brace, nothing);
    const bool precedes_item = starts_item(token.kind) || is_one_of(token.kind, right_brace, end);
    const bool is_implied = begins_block || ends_item(previous_);
    if (is_implied && precedes_item) {
        is_separated_ = !begins_block;
        std::uint8_t& lines = comments_.empty() ? lines_ : comments_.front().lines_before;
        lines = std::max(lines, separator.lines_before);
        return;
    }
    Piece piece;
    piece.token = separator.kind;
    piece.offset = separator.offset;
    piece.length = 1;
    piece.width = 1;
    piece.lines_before = separator.lines_before;
    pieces.push_back(piece);
    before_previous_ = previous_;
    previous_ = separator.kind;
    is_previous_sign_ = false;
    is_previous_comment_ = false;
    is_previous_line_comment_ = false;
}

// Places the comma of a list, but not one before the closing bracket.
void PieceReader::place_comma(const Token& token, std::vector<Piece>& pieces) {
    const Comma comma_here = *comma_;
    comma_.reset();
    const Frame& frame = frames_.back();
    const bool takes_trailing =
        frame.role == BracketRole::call || (frame.role == BracketRole::list && !frame.has_for);
    const bool is_trailing = is_closing(token.kind) && takes_trailing &&
                             ends_operand(comma_here.previous) && comma_here.kind == comma;
    std::uint8_t& lines = comments_.empty() ? lines_ : comments_.front().lines_before;
    if (is_trailing) {
        lines = std::max(lines, comma_here.lines_before);
        previous_ = comma_here.previous;
        return;
    }
    Piece piece;
    piece.token = comma_here.kind;
    piece.offset = comma_here.offset;
    piece.length = 1;
    piece.width = 1;
    if (is_previous_line_comment_) {
        piece.lines_before = comma_here.lines_before;
    } else {  // a comma ends a line, it does not begin one
        lines = std::max(lines, comma_here.lines_before);
    }
    pieces.push_back(piece);
    is_previous_comment_ = false;
    is_previous_line_comment_ = false;
}

void PieceReader::place_comments(bool continues, std::vector<Piece>& pieces) {
    for (Piece& comment : comments_) {
        const bool is_behind_opener = is_one_of(previous_, left_paren, left_bracket);
        comment.gap = comment.kind == PieceKind::line_comment     ? 2
                      : is_behind_opener && !is_previous_comment_ ? 0
                                                                  : 1;
        comment.continues = continues;
        comment.is_separated = is_separated_;
        if (is_separated_ && comment.kind == PieceKind::block_comment) comment.gap = 2;
        is_separated_ = false;
        is_previous_comment_ = true;
        is_previous_line_comment_ = comment.kind == PieceKind::line_comment;
        pieces.push_back(comment);
    }
    comments_.clear();
}

void PieceReader::place_token(const Token& token, std::vector<Piece>& pieces) {
    if (separator_) place_separator(token, pieces);
    if (comma_) place_comma(token, pieces);
    const bool is_file_begin = previous_ == nothing;
    Frame& frame = frames_.back();
    if (is_one_of(token.kind, comma, semicolon)) {  // of a list: the next token decides
        place_comments(false, pieces);
        comma_ = Comma{token.offset, token.kind, lines_, previous_};
        lines_ = 0;
        before_previous_ = previous_;
        previous_ = token.kind;
        is_previous_sign_ = false;
        return;
    }

    const bool has_line_before =
        lines_ > 0 || std::any_of(comments_.begin(), comments_.end(),
                                  [](const Piece& comment) { return comment.lines_before > 0; });
    const bool goes_on = continues_behind(previous_) || is_one_of(token.kind, kw_then, kw_else);
    const bool is_behind_block = previous_ == right_brace && starts_item(token.kind);
    const bool is_statement_else =
        token.kind == kw_else && previous_ == right_brace && frame.is_if && is_in_braces();
    bool begins_item = false;
    if (is_in_braces() && token.kind != right_brace && token.kind != end) {
        const bool is_separated_here = previous_ == semicolon || (has_line_before && !goes_on);
        begins_item = is_one_of(previous_, left_brace, nothing) || is_separated_ ||
                      is_separated_here || is_behind_block;
        if (is_behind_block) is_separated_ = true;
        if (begins_item) frame.is_if = token.kind == kw_if;
    }
    Piece piece;
    piece.continues = is_in_braces() && !begins_item && !is_statement_else &&
                      !is_one_of(token.kind, right_brace, end);
    // `} else if` stands on one line.
    const bool is_else_if = token.kind == kw_if && previous_ == kw_else && frame.is_if;
    if ((is_statement_else || (is_else_if && is_in_braces())) && comments_.empty()) lines_ = 0;
    if (frame.opener == left_bracket && token.kind == kw_for && previous_ == left_bracket) {
        frame.has_for = true;
    }
    if (!comments_.empty()) place_comments(piece.continues, pieces);

    const TokenKind before = begins_item ? nothing : previous_;
    const std::string_view text = text_.substr(token.offset, token.length);
    piece.token = token.kind;
    piece.offset = token.offset;
    piece.length = token.length;
    piece.width = token.length;
    if (token.kind == string) piece.width = text_width(text);
    const bool is_version = is_version_next_ && token.kind == number;  // text: 1.10 is not 1.1
    if (token.kind == number && !is_version && is_respelled(text)) {
        piece.is_respelled = true;
        piece.width = number_width(text);
    }
    piece.is_respelled = piece.is_respelled || token.kind == color;
    piece.role = role_of(token.kind, before);
    piece.lines_before = lines_;
    piece.is_separated = is_separated_ && !is_one_of(token.kind, right_brace, end);
    const bool is_glued_to_comment = is_one_of(token.kind, right_paren, right_bracket);
    piece.gap = piece.is_separated ? 2
                : is_previous_comment_
                    ? (is_glued_to_comment ? 0 : 1)
                    : gap_between(previous_, is_previous_sign_, token.kind, piece.role);
    const bool is_step_end = std::exchange(is_step_, false);
    if (is_step_end) piece.gap = 0;
    // `i++` is a mistake that is told as such; in a value, `a--b` are two signs.
    is_step_ = is_one_of(token.kind, plus, minus) && previous_ == identifier &&
               before_previous_ == nothing && is_in_braces() && token.end() < text_.size() &&
               text_[token.end()] == text_[token.offset];
    // `if n <= 1 { return 1 }` may stay on its line.
    const bool is_short =
        is_one_of(token.kind, TokenKind::kw_return, TokenKind::kw_break, TokenKind::kw_continue);
    piece.is_statement = begins_item && frames_.size() > 1 && is_keyword(token.kind) && !is_short;
    if (!track_brackets(token, piece.role)) return fail(pieces);
    pieces.push_back(piece);

    is_version_next_ = is_file_begin && token.kind == identifier && text == "lrs";
    is_previous_sign_ = is_one_of(token.kind, plus, minus) && !ends_operand(before);
    is_previous_comment_ = false;
    is_previous_line_comment_ = false;
    is_separated_ = false;
    lines_ = 0;
    before_previous_ = begins_item ? nothing : previous_;
    previous_ = is_step_end ? identifier : token.kind;
}

// Returns false where brackets do not match, or are nested too deep.
bool PieceReader::track_brackets(const Token& token, BracketRole role) {
    if (is_opening(token.kind)) {
        if (frames_.size() > max_nesting_) return false;
        frames_.push_back({token.kind, role});
    } else if (is_closing(token.kind)) {
        const auto opener = static_cast<TokenKind>(static_cast<unsigned>(token.kind) - 1);
        if (frames_.size() == 1 || frames_.back().opener != opener) return false;
        frames_.pop_back();
    } else if (token.kind == end) {
        return frames_.size() == 1;
    }
    return true;
}

}  // namespace lray::parser
