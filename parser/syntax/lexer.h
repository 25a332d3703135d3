// Text to tokens, one at a time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/source.h"
#include "parser/symbols.h"
#include "parser/syntax/characters.h"
#include "parser/syntax/token.h"

namespace lray::parser {

/// Scans one source. Reports lexical errors (E00..) at their place and goes on with the token the
/// user most likely meant.
class Lexer {
 public:
    Lexer(const Sources& sources, SourceId source, Symbols& symbols, Diagnostics& diagnostics);

    Token next();

    /// Goes on at this offset.
    void seek(std::uint32_t offset) { at_ = begin_ + offset; }

    /// Returns the `///` lines, each the first on its line, that stand before this offset with
    /// nothing in between; the last such lines that were passed are known. Empty when there are
    /// none.
    std::string_view doc_lines_before(std::uint32_t offset) const;

    /// The source's bytes, followed by Text::kPadding NULs.
    const char* begin() const { return begin_; }
    const char* end() const { return end_; }

    Span span(std::uint32_t begin, std::uint32_t end) const {
        return Span::make(source_, begin, end);
    }

 private:
    Token scan();
    static Token nothing();
    bool skip_blanks();
    void skip_line_comment();
    void note_doc_line(const char* from);
    void skip_block_comment();
    void check_code_point();
    Token identifier();
    Token number();
    void number_suffix(Token& token);
    Token string();
    const char* unclosed_string_end(const char* opening) const;
    Token quoted_otherwise(std::size_t opening_size, std::string_view closing);
    Token punctuation_lookalike(const Lookalike& lookalike, std::size_t size);
    Token hash();
    Token punctuation();
    Token operator_token();
    Token foreign_character();
    Token finish(TokenKind kind, const char* token_end);
    Span span_from(const char* from, const char* to) const;

    const char* begin_;
    const char* end_;
    const char* at_;
    const char* token_begin_;
    const char* doc_begin_ = nullptr;  // of the last `///` lines
    const char* doc_end_ = nullptr;
    const char* end_of_search_;  // up to here no string in quotes of another kind is closed
    SourceId source_;
    Symbols& symbols_;
    Diagnostics& diagnostics_;
    bool is_after_let_ = false;
    bool has_invalid_utf8_ = false;
};

/// True for a name with characters beyond ASCII, which the lexer has reported.
inline bool was_reported(std::string_view name) {
    return std::any_of(name.begin(), name.end(),
                       [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
}

/// Returns what to write instead of an operator of another language: "use `and`".
std::string_view foreign_operator_fix(std::string_view text);

/// Returns what a string literal says, between its quotes, with escapes resolved into `buffer`
/// when there are any.
/// Errors: E0009 at each bad escape.
std::string_view unescape(std::string_view inner, Span inner_span, std::string& buffer,
                          Diagnostics& diagnostics);

}  // namespace lray::parser
