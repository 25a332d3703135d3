// Text to tokens, one at a time.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/source.h"
#include "parser/symbols.h"
#include "parser/token.h"

namespace lray::parser {

/// Scans one source. Reports lexical errors (E00..) at their place and goes on with the token the
/// user most likely meant.
class Lexer {
 public:
    Lexer(const Sources& sources, SourceId source, Symbols& symbols, Diagnostics& diagnostics);

    Token next();

    /// Goes on at this offset.
    void seek(std::uint32_t offset) { at_ = begin_ + offset; }

    /// The source's bytes, followed by Text::kPadding NULs.
    const char* begin() const { return begin_; }
    const char* end() const { return end_; }

    Span span(std::uint32_t begin, std::uint32_t end) const {
        return Span::make(source_, begin, end);
    }

    /// True when the file turned out not to be text: there is no point in going on.
    bool is_binary() const { return is_binary_; }

 private:
    bool skip_blanks();
    void skip_line_comment();
    void skip_block_comment();
    void check_code_point();
    Token identifier();
    Token number();
    void number_suffix(Token& token);
    Token string();
    Token hash();
    Token punctuation();
    Token foreign_character();
    Token finish(TokenKind kind, const char* token_end);
    Span span_from(const char* from, const char* to) const;

    const char* begin_;
    const char* end_;
    const char* at_;
    const char* token_begin_;
    SourceId source_;
    Symbols& symbols_;
    Diagnostics& diagnostics_;
    bool is_binary_ = false;
    bool has_invalid_utf8_ = false;
};

/// Returns what to write instead of an operator of another language: "use `and`".
std::string_view foreign_operator_fix(std::string_view text);

/// Returns what a string literal says, between its quotes, with escapes resolved into `buffer`
/// when there are any.
/// Errors: E0009 at each bad escape.
std::string_view unescape(std::string_view inner, Span inner_span, std::string& buffer,
                          Diagnostics& diagnostics);

}  // namespace lray::parser
