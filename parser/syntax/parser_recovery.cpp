// How the parser moves over tokens, and how it finds its way after a mistake.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "parser/syntax/characters.h"
#include "parser/syntax/parser_state.h"

namespace lray::parser {

namespace {

/// How far the rest of a line is looked at to understand a mistake: it may be as long as the file.
constexpr std::uint32_t kMaxLookAhead = 4096;

/// True for ` name :`.
bool begins_property(const char* at) {
    while (is_a(*at, kBlank)) ++at;
    if (!is_a(*at, kLetter)) return false;
    while (is_a(*at, kLetter | kDigit)) ++at;
    while (is_a(*at, kBlank)) ++at;
    return *at == ':';
}

/// True for ` name :`, ` name =` and the words that begin a definition or statement.
bool begins_definition(const char* at) {
    if (begins_property(at)) return true;
    if (!is_a(*at, kLetter)) return false;
    const char* const begin = at;
    while (is_a(*at, kLetter | kDigit)) ++at;
    const std::string_view word(begin, static_cast<std::size_t>(at - begin));
    for (const std::string_view known : {"let", "var", "param", "fn", "component", "import",
                                         "include", "for", "while", "return"}) {
        if (word == known) return true;
    }
    while (is_a(*at, kBlank)) ++at;
    return at[0] == '=' && at[1] != '=';
}

}  // namespace

void Parser::advance() {
    previous_end_ = token_.end();
    if (has_ahead_) {
        token_ = ahead_;
        has_ahead_ = false;
    } else {
        token_ = lexer_.next();
    }
}

const Token& Parser::ahead() {
    if (!has_ahead_) {
        ahead_ = lexer_.next();
        has_ahead_ = true;
    }
    return ahead_;
}

// Goes on at this offset, behind something that was read without tokens.
void Parser::seek(std::uint32_t offset) {
    lexer_.seek(offset);
    has_ahead_ = false;
    token_.offset = offset;
    token_.length = 0;
    advance();
}

Diagnostic& Parser::error(Code code, Span span, std::string message) {
    is_panicking_ = true;
    return diagnostics_.error(code, span, std::move(message));
}

Expr* Parser::error_expr(Span span) {
    return make<Expr>(ExprKind::error, span);
}

bool Parser::fits_nesting(std::uint32_t depth, Span span) {
    if (depth <= context_.max_nesting) return !is_ended_;
    too_deep(span);
    return false;
}

void Parser::too_deep(Span span) {
    if (!is_ended_) {
        error(Code::E0115, span,
              fmt::format("nested more than {} levels deep", context_.max_nesting))
            .with_help("raise the limit with `--max-nesting N`, or name parts with `let`");
    }
    is_ended_ = true;
    is_panicking_ = true;
    token_ = Token{};
    token_.offset = previous_end_;
    has_ahead_ = false;
    lexer_.seek(static_cast<std::uint32_t>(lexer_.end() - lexer_.begin()));
}

// Skips to where the next item may begin: a `}`, a `;`, a line that starts like an item, or behind
// a comma. With brackets intact every line begins an item, and every comma ends one.
void Parser::synchronize() {
    is_panicking_ = false;
    if (is_separated_) return;  // the next item is known already
    const bool are_brackets_broken = std::exchange(has_broken_brackets_, false);
    if (are_brackets_broken) skip_to_last_unopened_closer();
    bool is_first = true;
    while (token_.kind != TokenKind::end) {
        using enum TokenKind;
        if (is_one_of(token_.kind, right_brace, semicolon)) return;
        const bool may_start = token_.newline_before && !(is_first && is_opening(token_.kind));
        if (may_start && (!are_brackets_broken || starts_item(token_, ahead()))) {
            is_separated_ = true;
            return;
        }
        if (token_.kind == comma) {
            if (!are_brackets_broken) return;
            advance();
            is_separated_ = starts_item(token_, ahead());
            if (is_separated_) return;
        } else if (is_opening(token_.kind) && (!are_brackets_broken || token_.kind == left_brace)) {
            skip_balanced();
        } else {
            advance();
        }
        is_first = false;
    }
}

// Skips the rest of the line, but not a `}` that closes the block around it.
void Parser::skip_line() {
    int depth = 0;
    bool is_first = true;
    while (token_.kind != TokenKind::end) {
        if (token_.newline_before && !is_first && depth == 0) return;
        if (token_.kind == TokenKind::left_brace) ++depth;
        if (token_.kind == TokenKind::right_brace && depth-- == 0) return;
        is_first = false;
        advance();
    }
}

// Skips the statement at hand with its brackets, however many lines they span.
void Parser::skip_balanced() {
    int depth = 0;
    bool is_first = true;
    while (token_.kind != TokenKind::end) {
        if (token_.newline_before && !is_first && depth == 0) return;
        if (is_opening(token_.kind)) {
            ++depth;
        } else if (is_closing(token_.kind)) {
            if (depth == 0) return;
            --depth;
            if (depth == 0 && token_.kind == TokenKind::right_brace) {
                advance();
                return;
            }
        }
        is_first = false;
        advance();
    }
}

// Skips the statement at hand, and the lines below that stand further in than its head.
void Parser::skip_with_lines_below(const Token& head) {
    const std::uint32_t indent = line_indent(head.offset);
    do {
        skip_balanced();
    } while (token_.newline_before && !is_closing(token_.kind) && token_.kind != TokenKind::end &&
             line_indent(token_.offset) > indent);
    is_panicking_ = false;
}

// True for a token that can only be the begin of an item, when it stands first on a line.
bool Parser::starts_item(const Token& token, const Token& after) const {
    if (token.kind == TokenKind::kw_fn) return after.kind == TokenKind::identifier;
    if (is_item_keyword(token.kind)) return true;
    if (token.kind != TokenKind::identifier) return false;
    return after.kind == TokenKind::colon || after.kind == TokenKind::left_brace ||
           after.kind == TokenKind::equal || after.kind == TokenKind::string;
}

bool Parser::starts_item_on_new_line() {
    return token_.newline_before && starts_item(token_, ahead());
}

// Width of the blanks at the begin of the line that holds this offset.
// Lines may be as long as the file: of the last one what was found out is kept.
std::uint32_t Parser::line_begin(std::uint32_t offset) {
    if (offset >= last_line_begin_ && offset <= last_line_seen_) return last_line_begin_;
    const char* const begin = lexer_.begin();
    const std::uint32_t stop = offset > last_line_seen_ ? last_line_seen_ : 0;
    std::uint32_t line = offset;
    while (line > stop && begin[line - 1] != '\n' && begin[line - 1] != '\r') --line;
    last_line_begin_ = line == stop && stop > 0 ? last_line_begin_ : line;
    last_line_seen_ = offset;
    return last_line_begin_;
}

std::uint32_t Parser::line_indent(std::uint32_t offset) {
    const char* const line = lexer_.begin() + line_begin(offset);
    const char* to = line;
    while (is_a(*to, kBlank)) ++to;
    return static_cast<std::uint32_t>(to - line);
}

// In the second run: a line that starts no further in than the line of the innermost `{` is not
// in its block.
bool Parser::is_dedented(const Token& token) {
    if (structure_ == Structure::braces || openers_.empty() || !token.newline_before) return false;
    const std::uint32_t indent = line_indent(token.offset);
    if (token.kind == TokenKind::right_brace) return false;
    return indent <= openers_.back().indent;
}

// Likewise: a `}` below the line of an outer `{` closes that one.
bool Parser::closes_outer_block(const Token& token) {
    if (structure_ == Structure::braces || openers_.empty() || !token.newline_before) return false;
    const std::uint32_t indent = line_indent(token.offset);
    if (indent >= openers_.back().indent) return false;
    return std::any_of(openers_.begin(), openers_.end() - 1,
                       [&](const Opener& outer) { return outer.indent == indent; });
}

std::string Parser::position(const Token& token) const {
    const Position at = context_.sources.position(span_of(token));
    return fmt::format("{}:{}", at.line, at.column);
}

std::string Parser::describe(const Token& token) const {
    if (token.kind == TokenKind::end) return "the end of the file";
    if (token.kind == TokenKind::number) return fmt::format("the number `{}`", text_of(token));
    if (token.kind == TokenKind::string) return "a string";
    if (token.kind == TokenKind::color) return fmt::format("the colour `{}`", text_of(token));
    return fmt::format("`{}`", text_of(token));
}

// Expects the closing bracket. Returns false if what the brackets hold is not to be trusted: then
// the item they stand in is skipped.
bool Parser::close(TokenKind closer, const Token& opener) {
    has_broken_brackets_ = has_broken_brackets_ || is_panicking_;
    if (is_ended_ || is_panicking_) return false;
    if (token_.kind == closer) {
        advance();
        return true;
    }
    const std::string_view wanted = closer == TokenKind::right_bracket ? "]" : ")";
    const std::string missing =
        fmt::format("expected `{}` to close `{}` at {}", wanted, text_of(opener), position(opener));
    const bool is_other_closer =
        token_.kind == TokenKind::right_bracket || token_.kind == TokenKind::right_paren;
    const bool is_next_item = token_.kind == TokenKind::end ||
                              token_.kind == TokenKind::right_brace || is_separated_ ||
                              starts_item_on_new_line();
    if (is_other_closer) {
        error(Code::E0101, span_of(token_), fmt::format("{}, found `{}`", missing, text_of(token_)))
            .with_label(span_of(opener), "opened here");
    } else if (is_next_item || token_.kind == TokenKind::left_brace) {
        error(Code::E0101, here(), missing).with_label(span_of(opener), "opened here");
    } else if (token_.kind == TokenKind::comma) {  // of the list around `(a + b`, or of an index
        error(Code::E0101, here(), missing).with_label(span_of(opener), "opened here");
        is_panicking_ = bracket_depth_ == 0 || opener.kind == TokenKind::left_bracket;
    } else if (token_.kind == TokenKind::foreign) {
        foreign_operator(nullptr);
    } else {
        error(Code::E0106, span_of(token_),
              fmt::format("expected `,` or `{}`, found {}", wanted, describe(token_)));
    }
    has_broken_brackets_ = is_panicking_;
    return false;
}

// True if a `)` or `]` further on in this line, but before the next property, has no opening one
// from this token on.
bool Parser::line_has_unopened_closer(const Token& from) const {
    int brackets = 0;
    int braces = 0;
    bool is_string = false;
    const char* const begin = lexer_.begin() + from.offset;
    for (const char* at = begin; at < lexer_.end() && at < begin + kMaxLookAhead; ++at) {
        if (*at == '\n' || *at == '\r' || (!is_string && at[0] == '/' && at[1] == '/')) break;
        if (*at == '"') is_string = !is_string;
        if (is_string) continue;
        if (*at == '(' || *at == '[') ++brackets;
        if ((*at == ')' || *at == ']') && --brackets < 0) return true;
        if (*at == '{') ++braces;
        if (*at == '}' && --braces < 0) return false;
        if (*at == ',' && brackets == 0 && begins_property(at + 1)) return false;
    }
    return false;
}

// Skips what is left of a list or call whose brackets do not match: up to the last `)` or `]` of
// this line that has no opening one. Names with colons in it are arguments, not properties.
void Parser::skip_to_last_unopened_closer() {
    if (token_.newline_before || token_.kind == TokenKind::end) return;
    int brackets = 0;
    int braces = 0;
    bool is_string = false;
    const char* last = nullptr;
    const char* const begin = lexer_.begin() + token_.offset;
    for (const char* at = begin; at < lexer_.end() && at < begin + kMaxLookAhead; ++at) {
        if (*at == '\n' || *at == '\r' || (!is_string && at[0] == '/' && at[1] == '/')) break;
        if (*at == '"') is_string = !is_string;
        if (is_string) continue;
        if (*at == '(' || *at == '[') ++brackets;
        if (*at == '{') ++braces;
        if (*at == '}' && --braces < 0) break;
        const bool is_unopened = (*at == ')' || *at == ']') && --brackets < 0;
        if (!is_unopened) continue;
        brackets = 0;
        last = at;
    }
    if (last == nullptr) return;
    const auto end = static_cast<std::uint32_t>(last - lexer_.begin());
    while (token_.kind != TokenKind::end && token_.offset <= end) advance();
}

// Skips what is left of a list whose elements stand on lines of their own, further in than the line
// of its `[`: the first line that does not is where it ends, whatever brackets are missing in it.
void Parser::skip_to_closing_line(const Token& opener) {
    const std::uint32_t indent = line_indent(opener.offset);
    while (token_.kind != TokenKind::end &&
           !(token_.newline_before && line_indent(token_.offset) <= indent)) {
        is_separated_ = false;
        advance();
    }
    if (token_.kind != TokenKind::right_bracket) return;
    advance();
    is_panicking_ = false;
    has_broken_brackets_ = false;
}

// True if a `]` or `)` below this line closes a list whose opening bracket is missing: what stands
// between are elements, not items.
bool Parser::list_is_closed_below() const {
    int brackets = 0;
    int braces = 0;
    bool is_string = false;
    bool is_line_begin = false;
    const char* const begin = lexer_.begin() + token_.offset;
    for (const char* at = begin; at < lexer_.end() && at < begin + kMaxLookAhead; ++at) {
        if (*at == '\n') {
            is_string = false;
            is_line_begin = true;
            continue;
        }
        if (!is_string && at[0] == '/' && at[1] == '/') {
            while (at + 1 < lexer_.end() && at[1] != '\n') ++at;
            continue;
        }
        if (*at == '"') is_string = !is_string;
        if (is_string || is_a(*at, kBlank)) continue;
        const bool is_outermost = brackets == 0 && braces == 0;
        if (is_line_begin && is_outermost && begins_definition(at)) return false;
        is_line_begin = false;
        if (*at == '(' || *at == '[') ++brackets;
        if ((*at == ')' || *at == ']') && --brackets < 0) return braces == 0;
        if (*at == '{') ++braces;
        if (*at == '}' && --braces < 0) return false;
    }
    return false;
}

// True if this line closes more braces behind the token than were opened in it: one was lost.
bool Parser::line_closes_too_many_braces(const Token& from) {
    int braces = 0;
    const std::uint32_t line = line_begin(from.offset);
    for (const Opener& opener : openers_) braces += opener.offset >= line ? 1 : 0;
    bool is_string = false;
    for (const char* at = lexer_.begin() + from.offset;; ++at) {
        if (at == lexer_.end()) break;
        if (at == lexer_.begin() + from.offset + kMaxLookAhead) return false;
        if (*at == '\n' || *at == '\r' || (!is_string && at[0] == '/' && at[1] == '/')) break;
        if (*at == '"') is_string = !is_string;
        if (!is_string && *at == '{') ++braces;
        if (!is_string && *at == '}') --braces;
    }
    return braces < 0;
}

// After a value: `8, 8]`, whose `[` is missing, or `0, 1, 0`, which has no brackets at all. Returns
// true when that was reported, and the rest of it skipped.
bool Parser::skip_list_without_opener(const Expr& value) {
    if (is_panicking_ || is_ended_) return false;
    using enum TokenKind;
    if (token_.newline_before && !is_one_of(token_.kind, right_bracket, right_paren)) return false;
    if (is_one_of(token_.kind, right_brace, semicolon, end)) return false;
    if (token_.kind == comma && ahead().newline_before && list_is_closed_below()) {
        for (int depth = 0;
             depth > 0 || !is_one_of(token_.kind, right_bracket, right_paren, end);) {
            if (is_opening(token_.kind)) ++depth;
            if (is_closing(token_.kind)) --depth;
            advance();
        }
        error(Code::E0104, span_of(token_), fmt::format("`{}` closes nothing", text_of(token_)))
            .with_label(value.span, "perhaps an opening one is missing here");
        advance();
        is_panicking_ = false;
        return true;
    }
    const bool has_closer = line_has_unopened_closer(token_);
    const TokenKind next = token_.kind == comma ? ahead().kind : end;
    const bool has_element = is_one_of(next, number, minus, plus, left_bracket, left_paren, string,
                                       color, kw_true, kw_false);
    if (!has_closer && !has_element) return false;
    int depth = 0;
    bool is_behind_comma = false;
    while (!is_one_of(token_.kind, right_brace, semicolon, end)) {
        const bool may_start_item = token_.newline_before || (is_behind_comma && !has_closer);
        if (may_start_item && starts_item(token_, ahead())) break;
        if (is_condition_ && token_.kind == left_brace && depth == 0) break;
        const bool is_closer = is_one_of(token_.kind, right_bracket, right_paren);
        const bool is_complete = depth == 0 && !has_closer && !is_behind_comma && !is_closer;
        if (is_complete && token_.newline_before) break;
        if (is_one_of(token_.kind, left_bracket, left_paren)) ++depth;
        if (is_closer && depth-- == 0) {
            error(Code::E0104, span_of(token_), fmt::format("`{}` closes nothing", text_of(token_)))
                .with_label(value.span, "perhaps an opening one is missing here");
            advance();
            is_panicking_ = false;
            return true;
        }
        is_behind_comma = token_.kind == comma;
        advance();
    }
    const Span written = span_from(value.span.offset);
    std::string_view text = context_.sources.text(written);
    while (!text.empty() && (text.back() == ',' || is_a(text.back(), kBlank)))
        text.remove_suffix(1);
    error(Code::E0109, written, "a list stands in brackets")
        .with_hint(text.size() <= 40 ? fmt::format("write `[{}]`", text) : std::string());
    is_separated_ = is_behind_comma;
    is_panicking_ = false;
    return true;
}

// After a name: the items of a block whose `{` is missing. Returns true when that was reported, and
// the items read.
bool Parser::read_block_without_brace(Span head) {
    if (is_panicking_ || is_ended_ || token_.kind != TokenKind::identifier) return false;
    const bool is_below = token_.newline_before && starts_item(token_, ahead()) &&
                          line_indent(token_.offset) > line_indent(head.offset);
    const bool is_beside = !token_.newline_before && ahead().kind == TokenKind::colon;
    if (!is_below && !is_beside) return false;
    error(Code::E0107, here(),
          fmt::format("expected `{{` after `{}`", context_.sources.text(head)));
    is_panicking_ = false;
    is_structure_known_ = false;
    openers_.push_back({head.offset, line_indent(head.offset)});
    items(false);
    openers_.pop_back();
    if (token_.kind == TokenKind::right_brace) advance();
    return true;
}

}  // namespace lray::parser
