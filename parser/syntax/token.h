// The tokens of the language.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "parser/symbols.h"

namespace lray::parser {

enum class TokenKind : std::uint8_t {
    // Keywords, in the order of kKeywords: those that begin an item first. The contextual `lrs` is
    // an
    // identifier.
    kw_let,
    kw_var,
    kw_param,
    kw_fn,
    kw_component,
    kw_include,
    kw_import,
    kw_if,
    kw_for,
    kw_while,
    kw_break,
    kw_continue,
    kw_return,
    kw_else,
    kw_then,
    kw_as,
    kw_in,
    kw_and,
    kw_or,
    kw_not,
    kw_true,
    kw_false,
    // Words kept for later.
    kw_match,
    kw_struct,
    kw_type,
    kw_use,
    kw_export,
    kw_enum,
    kw_class,
    kw_with,
    kw_yield,
    identifier,
    number,
    string,
    color,
    left_brace,
    right_brace,
    left_bracket,
    right_bracket,
    left_paren,
    right_paren,
    comma,
    semicolon,
    colon,
    dot,
    equal,
    plus,
    minus,
    star,
    slash,
    percent,
    caret,
    equal_equal,
    not_equal,
    less,
    less_equal,
    greater,
    greater_equal,
    foreign,  // an operator of another language: `&&`, `+=`, `..`
    end,
    nothing,  // text that was reported and is left out; the lexer keeps it to itself
};

inline constexpr std::array<std::string_view, 31> kKeywords = {
    "let",  "var",   "param",  "fn",       "component", "include", "import", "if",
    "for",  "while", "break",  "continue", "return",    "else",    "then",   "as",
    "in",   "and",   "or",     "not",      "true",      "false",   "match",  "struct",
    "type", "use",   "export", "enum",     "class",     "with",    "yield"};
static_assert(kKeywords.size() == static_cast<std::size_t>(TokenKind::identifier));

template <class... Kinds>
constexpr bool is_one_of(TokenKind kind, Kinds... kinds) {
    return ((kind == kinds) || ...);
}

constexpr bool is_opening(TokenKind kind) {
    return is_one_of(kind, TokenKind::left_brace, TokenKind::left_bracket, TokenKind::left_paren);
}

constexpr bool is_closing(TokenKind kind) {
    return is_one_of(kind, TokenKind::right_brace, TokenKind::right_bracket,
                     TokenKind::right_paren);
}

constexpr bool is_keyword(TokenKind kind) {
    return kind < TokenKind::identifier;
}

/// A keyword that has no meaning yet.
constexpr bool is_reserved_word(TokenKind kind) {
    return kind >= TokenKind::kw_match && kind < TokenKind::identifier;
}

/// A keyword with which an item begins.
constexpr bool is_item_keyword(TokenKind kind) {
    return kind <= TokenKind::kw_return;
}

/// One token: 24 bytes. Its text is source[offset, offset + length).
struct Token {
    TokenKind kind = TokenKind::end;
    bool newline_before = false;  // a line end stands between it and the token before
    bool has_unit = false;        // a number with a suffix
    std::uint8_t quote_size =
        1;  // bytes of a string's opening quote; each of its quotes has as many
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
    double number = 0.0;        // of a number, in degrees or metres where it has a unit
    Symbol symbol = kNoSymbol;  // of an identifier or keyword

    std::uint32_t end() const { return offset + length; }
};

}  // namespace lray::parser
