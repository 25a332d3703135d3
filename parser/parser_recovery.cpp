// How the parser moves over tokens, and how it finds its way after a mistake.
#include <fmt/format.h>

#include <algorithm>

#include "parser/characters.h"
#include "parser/parser_state.h"

namespace lray::parser {

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

// Skips to where the next item may begin: a separator, a `}`, or a line that starts like an item.
void Parser::synchronize() {
    is_panicking_ = false;
    bool is_first = true;
    while (token_.kind != TokenKind::end) {
        using enum TokenKind;
        if (is_one_of(token_.kind, right_brace, comma, semicolon)) return;
        if (is_opening(token_.kind)) {
            if (token_.newline_before && !is_first) return;
            skip_balanced();
            is_first = false;
            continue;
        }
        if (token_.newline_before) {
            is_separated_ = true;
            return;
        }
        is_first = false;
        advance();
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

// True for a token that can only be the begin of an item, when it stands first on a line.
bool Parser::starts_item(const Token& token, const Token& after) const {
    if (token.kind == TokenKind::kw_let || token.kind == TokenKind::kw_include) return true;
    if (token.kind >= TokenKind::kw_var && token.kind <= TokenKind::kw_return) return true;
    if (token.kind != TokenKind::identifier) return false;
    return after.kind == TokenKind::colon || after.kind == TokenKind::left_brace ||
           after.kind == TokenKind::equal || after.kind == TokenKind::string;
}

bool Parser::starts_item_on_new_line() {
    return token_.newline_before && starts_item(token_, ahead());
}

// Width of the blanks at the begin of the line that holds this offset.
std::uint32_t Parser::line_indent(std::uint32_t offset) const {
    const char* const begin = lexer_.begin();
    const char* line = begin + offset;
    while (line > begin && line[-1] != '\n' && line[-1] != '\r') --line;
    const char* to = line;
    while (is_a(*to, kBlank)) ++to;
    return static_cast<std::uint32_t>(to - line);
}

// In the second run: a line that starts no further in than the line of the innermost `{` is not
// in its block.
bool Parser::is_dedented(const Token& token) const {
    if (structure_ == Structure::braces || openers_.empty() || !token.newline_before) return false;
    const std::uint32_t indent = line_indent(token.offset);
    if (token.kind == TokenKind::right_brace) return false;
    return indent <= openers_.back().indent;
}

// Likewise: a `}` below the line of an outer `{` closes that one.
bool Parser::closes_outer_block(const Token& token) const {
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

// Expects the closing bracket; whatever stands there instead, the bracket counts as closed. Returns
// false if what the brackets hold is not to be trusted.
bool Parser::close(TokenKind closer, const Token& opener) {
    if (is_ended_) return false;
    if (token_.kind == closer && !is_panicking_) {
        advance();
        return true;
    }
    if (is_panicking_) {  // skip to the closer, if it is on this line
        int depth = 0;
        while (token_.kind != TokenKind::end && !token_.newline_before) {
            if (token_.kind == closer && depth == 0) {
                advance();
                is_panicking_ = false;
                return false;
            }
            if (token_.kind == TokenKind::left_bracket || token_.kind == TokenKind::left_paren) {
                ++depth;
            } else if (token_.kind == TokenKind::right_bracket ||
                       token_.kind == TokenKind::right_paren) {
                if (depth-- == 0) return false;
            } else if (token_.kind == TokenKind::left_brace ||
                       token_.kind == TokenKind::right_brace) {
                return false;
            }
            advance();
        }
        return false;
    }
    const std::string_view wanted = closer == TokenKind::right_bracket ? "]" : ")";
    const bool is_other_closer =
        token_.kind == TokenKind::right_bracket || token_.kind == TokenKind::right_paren;
    const bool is_next_item = token_.kind == TokenKind::end ||
                              token_.kind == TokenKind::right_brace || is_separated_ ||
                              starts_item_on_new_line();
    if (is_other_closer) {
        error(Code::E0101, span_of(token_),
              fmt::format("expected `{}` to close `{}` at {}, found `{}`", wanted, text_of(opener),
                          position(opener), text_of(token_)))
            .with_label(span_of(opener), "opened here");
        advance();
        is_panicking_ = false;
    } else if (is_next_item) {
        error(Code::E0101, here(),
              fmt::format("expected `{}` to close `{}` at {}", wanted, text_of(opener),
                          position(opener)))
            .with_label(span_of(opener), "opened here");
        is_panicking_ = false;
    } else if (token_.kind == TokenKind::foreign) {
        foreign_operator(nullptr);
    } else {
        error(Code::E0106, span_of(token_),
              fmt::format("expected `,` or `{}`, found {}", wanted, describe(token_)));
        close(closer, opener);
    }
    return false;
}

}  // namespace lray::parser
