// Strings, and characters beyond ASCII where none belong.
#include <fmt/format.h>

#include <string>

#include "parser/syntax/characters.h"
#include "parser/syntax/lexer.h"

namespace lray::parser {

void Lexer::skip_line_comment() {
    const char* const from = at_;
    while (at_ < end_ && *at_ != '\n' && *at_ != '\r') check_code_point();
    if (from[0] == '/' && from[2] == '/' && from[3] != '/') note_doc_line(from);
}

// A doc comment goes on with the one on the line before; behind code it is an ordinary comment.
void Lexer::note_doc_line(const char* from) {
    const char* line = from;
    while (line > begin_ && is_a(line[-1], kBlank)) --line;
    if (line > begin_ && line[-1] != '\n' && line[-1] != '\r') return;
    const auto offset = static_cast<std::uint32_t>(from - begin_);
    if (doc_lines_before(offset).empty()) doc_begin_ = from;
    doc_end_ = at_;
}

std::string_view Lexer::doc_lines_before(std::uint32_t offset) const {
    if (doc_end_ == nullptr || doc_end_ > begin_ + offset) return {};
    const char* at = doc_end_;
    while (is_a(*at, kBlank) || *at == '\n' || *at == '\r') ++at;
    if (at != begin_ + offset) return {};
    return {doc_begin_, static_cast<std::size_t>(doc_end_ - doc_begin_)};
}

void Lexer::skip_block_comment() {
    const char* const opening = at_;
    unsigned depth = 1;
    at_ += 2;
    while (at_ < end_) {
        if (at_[0] == '*' && at_[1] == '/') {
            at_ += 2;
            if (--depth == 0) return;
        } else if (at_[0] == '/' && at_[1] == '*') {
            at_ += 2;
            ++depth;
        } else {
            check_code_point();
        }
    }
    diagnostics_.error(Code::E0011, span_from(opening, opening + 2), "this comment is never closed")
        .with_help("close it with `*/`; comments may be nested, each needs its own");
}

// Steps over one code point of text that is not looked at: a comment or a string.
void Lexer::check_code_point() {
    const auto byte = static_cast<unsigned char>(*at_);
    if (byte < 0x80) {
        ++at_;
        return;
    }
    const CodePoint point = decode_utf8({at_, static_cast<std::size_t>(end_ - at_)});
    if (point.length > 0) {
        at_ += point.length;
        return;
    }
    if (!has_invalid_utf8_) {  // once per file: the encoding is wrong, not the byte
        diagnostics_
            .error(Code::E0002, span_from(at_, at_ + 1),
                   fmt::format("the byte 0x{:02x} is not UTF-8", byte))
            .with_help("save the file with the encoding UTF-8");
        has_invalid_utf8_ = true;
    }
    ++at_;
}

// A name with letters beyond ASCII: reported, then read as the name it looks like.
Token Lexer::foreign_character() {
    const CodePoint here = decode_utf8({at_, static_cast<std::size_t>(end_ - at_)});
    if (const Lookalike* lookalike = find_lookalike(here.value)) {
        return punctuation_lookalike(*lookalike, here.length);
    }
    std::string name;
    const char* to = at_;
    const char* first_foreign = nullptr;
    bool looks_like_ascii = true;
    CodePoint foreign;
    while (to < end_) {
        if (is_a(*to, kLetter | kDigit)) {
            name += *to++;
            continue;
        }
        if (static_cast<unsigned char>(*to) < 0x80) break;
        const CodePoint point = decode_utf8({to, static_cast<std::size_t>(end_ - to)});
        if (point.length == 0 || find_lookalike(point.value) != nullptr) break;
        if (first_foreign == nullptr) {
            first_foreign = to;
            foreign = point;
        }
        const Confusable* confusable = find_confusable(point.value);
        looks_like_ascii = looks_like_ascii && confusable != nullptr;
        if (confusable != nullptr) name += confusable->looks_like;
        to += point.length;
    }
    if (first_foreign == nullptr && to > at_) {  // a plain name, with something else behind it
        Token token = finish(TokenKind::identifier, to);
        token.symbol = symbols_.intern({token_begin_, token.length});
        if (token.symbol < kKeywords.size()) token.kind = static_cast<TokenKind>(token.symbol);
        return token;
    }
    if (first_foreign == nullptr) {  // not UTF-8
        check_code_point();
        return nothing();
    }
    const Span place = span_from(first_foreign, first_foreign + foreign.length);
    const std::string_view shown(first_foreign, foreign.length);
    if (const Confusable* confusable = find_confusable(foreign.value)) {
        diagnostics_.error(Code::E0004, place,
                           fmt::format("`{}` is {}; did you mean Latin `{}`?", shown,
                                       confusable->name, confusable->looks_like));
    } else {
        diagnostics_.error(Code::E0004, place, fmt::format("`{}` cannot be part of a name", shown))
            .with_help("names are made of the letters a to z, digits and `_`");
    }
    Token token = finish(TokenKind::identifier, to);
    // A name that looks like no other keeps its bytes beyond ASCII: it is silent from here on.
    token.symbol = symbols_.intern(looks_like_ascii ? std::string_view(name)
                                                    : std::string_view(token_begin_, token.length));
    if (token.symbol < kKeywords.size()) token.kind = static_cast<TokenKind>(token.symbol);
    return token;
}

// Text after a blank or closing bracket at the end of an unclosed string: `"abc }` most likely lost
// its quote before the brace.
const char* Lexer::unclosed_string_end(const char* opening) const {
    const char* to = at_;
    const auto is_closer = [](char c) {
        return is_a(c, kBlank) || c == '}' || c == ']' || c == ')' || c == ',' || c == ';';
    };
    while (to > opening + 1 && is_closer(to[-1])) --to;
    return to;
}

Token Lexer::string() {
    const char* const opening = at_;
    ++at_;
    while (at_ < end_ && *at_ != '"' && *at_ != '\n' && *at_ != '\r') {
        if (*at_ == '\\' && at_ + 1 < end_ && at_[1] != '\n' && at_[1] != '\r') ++at_;
        check_code_point();
    }
    if (at_ < end_ && *at_ == '"') return finish(TokenKind::string, at_ + 1);
    diagnostics_
        .error(Code::E0005, span_from(opening, at_), "this string is not closed on its line")
        .with_help("end it with `\"`");
    return finish(TokenKind::string, unclosed_string_end(opening));
}

// A string in quotes of another kind: reported, then read as the string it is meant to be.
Token Lexer::quoted_otherwise(std::size_t opening_size, std::string_view closing) {
    const char* const opening = at_;
    const char* const inner = opening + opening_size;
    diagnostics_.error(Code::E0001, span_from(opening, inner), "strings are written with `\"`");
    const auto closes = [&](const char* at) {
        return std::string_view(at, static_cast<std::size_t>(end_ - at)).starts_with(closing);
    };
    const char* close = inner;
    // A line without an end to its string is searched once: it may be as long as the file.
    const bool is_searched = opening >= end_of_search_;
    while (is_searched && close < end_ && *close != '\n' && *close != '\r' && !closes(close)) {
        ++close;
    }
    if (!is_searched || close == end_ || !closes(close)) {
        if (is_searched) end_of_search_ = close;
        at_ = inner;
        return nothing();
    }
    at_ = close + closing.size();
    Token token = finish(TokenKind::string, at_);
    token.quote_size = static_cast<std::uint8_t>(opening_size);
    return token;
}

// A dash, quote or blank that is not the ASCII one: reported, then read as what it looks like.
Token Lexer::punctuation_lookalike(const Lookalike& lookalike, std::size_t size) {
    if (lookalike.looks_like == '"') return quoted_otherwise(size, lookalike.closing);
    diagnostics_.error(
        Code::E0001, span_from(at_, at_ + size),
        lookalike.looks_like == ' '
            ? fmt::format("this is {}, not a space", lookalike.name)
            : fmt::format("this is {}, not `{}`", lookalike.name, lookalike.looks_like));
    at_ += size;
    if (lookalike.looks_like == ' ') return nothing();
    const TokenKind kind = lookalike.looks_like == '-'   ? TokenKind::minus
                           : lookalike.looks_like == '*' ? TokenKind::star
                                                         : TokenKind::comma;
    return finish(kind, at_);
}

std::string_view unescape(std::string_view inner, Span inner_span, std::string& buffer,
                          Diagnostics& diagnostics) {
    if (inner.find('\\') == std::string_view::npos) return inner;
    buffer.clear();
    for (std::size_t i = 0; i < inner.size(); ++i) {
        if (inner[i] != '\\' || i + 1 == inner.size()) {
            buffer += inner[i];
            continue;
        }
        const std::size_t escape = i++;
        const auto bad = [&](std::size_t to, std::string message) {
            diagnostics.error(
                Code::E0009,
                Span::make(inner_span.source, inner_span.offset + escape, inner_span.offset + to),
                std::move(message));
        };
        switch (inner[i]) {
            case 'n':
                buffer += '\n';
                break;
            case 't':
                buffer += '\t';
                break;
            case '"':
            case '\\':
                buffer += inner[i];
                break;
            case 'u': {
                const std::size_t close = inner.find('}', i);
                std::uint32_t value = 0;
                const bool has_braces =
                    i + 1 < inner.size() && inner[i + 1] == '{' && close != std::string_view::npos;
                const std::string_view digits =
                    has_braces ? inner.substr(i + 2, close - i - 2) : std::string_view{};
                bool is_valid = !digits.empty() && digits.size() <= 6;
                for (const char c : digits) {
                    is_valid = is_valid && is_a(c, kHex);
                    const int digit = c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10;
                    value = value * 16 + static_cast<std::uint32_t>(digit & 15);
                }
                is_valid = is_valid && value <= 0x10FFFF && !(value >= 0xD800 && value <= 0xDFFF);
                if (!is_valid) {
                    bad(has_braces ? close + 1 : i + 1,
                        "a code point is written `\\u{1F600}`: 1 to 6 hex digits, at most 10FFFF");
                    i = has_braces ? close : i;
                    break;
                }
                i = close;
                if (value < 0x80) {
                    buffer += static_cast<char>(value);
                } else if (value < 0x800) {
                    buffer += static_cast<char>(0xC0 | value >> 6);
                    buffer += static_cast<char>(0x80 | (value & 0x3F));
                } else if (value < 0x10000) {
                    buffer += static_cast<char>(0xE0 | value >> 12);
                    buffer += static_cast<char>(0x80 | (value >> 6 & 0x3F));
                    buffer += static_cast<char>(0x80 | (value & 0x3F));
                } else {
                    buffer += static_cast<char>(0xF0 | value >> 18);
                    buffer += static_cast<char>(0x80 | (value >> 12 & 0x3F));
                    buffer += static_cast<char>(0x80 | (value >> 6 & 0x3F));
                    buffer += static_cast<char>(0x80 | (value & 0x3F));
                }
                break;
            }
            default:
                bad(i + 1,
                    fmt::format("`\\{}` is no escape; there are \\n \\t \\\" \\\\ \\u{{...}}",
                                inner[i]));
                break;
        }
    }
    return buffer;
}

}  // namespace lray::parser
