// Blanks, names, numbers and punctuation; comments and strings are in lexer_text.cpp.
#include "parser/syntax/lexer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

#include "base/parse_number.h"
#include "parser/syntax/characters.h"

namespace lray::parser {

namespace {

struct Unit {
    std::string_view name{};
    double factor = 1.0;  // to degrees or metres
};

constexpr std::array<Unit, 7> kUnits = {{
    {"deg", 1.0},
    {"rad", 180.0 / std::numbers::pi},
    {"turn", 360.0},
    {"m", 1.0},
    {"cm", 1e-2},
    {"mm", 1e-3},
    {"km", 1e3},
}};

// Operators of other languages, longest first, and what they are here.
struct Foreign {
    std::string_view text{};
    std::string_view fix{};
};

constexpr std::array<Foreign, 11> kForeign = {{
    {"...", "ranges are written `range(0, 10)`"},
    {"&&", "use `and`"},
    {"||", "use `or`"},
    {"**", "powers are written `a ^ b`"},
    {"++", "write `i = i + 1`"},
    {"--", "write `i = i - 1`"},
    {"..", "ranges are written `range(0, 10)`"},
    {"->", "properties are written `name: value`"},
    {"=>", "properties are written `name: value`"},
    {"!", "use `not`"},
    {"?", "write `if a then b else c`"},
}};

}  // namespace

Lexer::Lexer(const Sources& sources, SourceId source, Symbols& symbols, Diagnostics& diagnostics)
    : begin_(sources[source].text.data()),
      end_(begin_ + sources[source].text.size()),
      at_(begin_),
      token_begin_(begin_),
      end_of_search_(begin_),
      source_(source),
      symbols_(symbols),
      diagnostics_(diagnostics) {
    const std::string_view text(begin_, static_cast<std::size_t>(end_ - begin_));
    if (text.starts_with("\xEF\xBB\xBF")) at_ += 3;
    // A file that is not text is told so once, not character by character.
    const void* const nul = std::memchr(begin_, '\0', text.size());
    const bool is_utf16 = text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE");
    if (is_utf16) {
        diagnostics_.error(Code::E0003, span(0, 2), "this file is UTF-16; save it as UTF-8");
    } else if (nul != nullptr) {
        const auto offset = static_cast<std::uint32_t>(static_cast<const char*>(nul) - begin_);
        diagnostics_.error(Code::E0003, span(offset, offset + 1),
                           "this is not a text file: it contains a NUL byte");
    }
    if (is_utf16 || nul != nullptr) at_ = end_;
}

Span Lexer::span_from(const char* from, const char* to) const {
    return span(static_cast<std::uint32_t>(from - begin_), static_cast<std::uint32_t>(to - begin_));
}

Token Lexer::finish(TokenKind kind, const char* token_end) {
    Token token;
    token.kind = kind;
    token.offset = static_cast<std::uint32_t>(token_begin_ - begin_);
    token.length = static_cast<std::uint32_t>(token_end - token_begin_);
    at_ = token_end;
    return token;
}

Token Lexer::next() {
    bool newline_before = false;
    Token token;
    do {  // text that means nothing may be as long as the file: no recursion
        newline_before = skip_blanks() || newline_before;
        token = scan();
    } while (token.kind == TokenKind::nothing);
    is_after_let_ =
        is_one_of(token.kind, TokenKind::kw_let, TokenKind::kw_var, TokenKind::kw_param);
    token.newline_before = newline_before;
    return token;
}

Token Lexer::nothing() {
    Token token;
    token.kind = TokenKind::nothing;
    return token;
}

Token Lexer::scan() {
    token_begin_ = at_;
    const char c = *at_;
    Token token;
    if (is_a(c, kLetter)) {
        token = identifier();
    } else if (is_a(c, kDigit) || (c == '.' && is_a(at_[1], kDigit))) {
        token = number();
    } else if (c == '"') {
        token = string();
    } else if (c == '#') {
        token = hash();
    } else if (at_ >= end_) {
        token = finish(TokenKind::end, at_);
    } else {
        token = punctuation();
    }
    return token;
}

// Returns true if a line end was passed.
bool Lexer::skip_blanks() {
    bool newline = false;
    for (;;) {
        const char c = *at_;
        if (is_a(c, kBlank)) {
            ++at_;
        } else if (c == '\n' || c == '\r') {
            newline = true;
            ++at_;
        } else if (c == '/' && at_[1] == '/') {
            skip_line_comment();
        } else if (c == '/' && at_[1] == '*') {
            skip_block_comment();
        } else {
            return newline;
        }
    }
}

Token Lexer::identifier() {
    const char* to = at_ + 1;
    while (is_a(*to, kLetter | kDigit)) ++to;
    if (static_cast<unsigned char>(*to) >= 0x80) return foreign_character();
    Token token = finish(TokenKind::identifier, to);
    token.symbol = symbols_.intern({token_begin_, token.length});
    if (token.symbol < kKeywords.size()) token.kind = static_cast<TokenKind>(token.symbol);
    return token;
}

Token Lexer::number() {
    const char* to = at_;
    std::string without_separators;
    double value = 0.0;
    bool is_malformed = false;
    const bool is_hex = to[0] == '0' && (to[1] == 'x' || to[1] == 'X');
    if (is_hex) {
        to += 2;
        is_malformed = !is_a(*to, kHex);
        for (; is_a(*to, kHex) || *to == '_'; ++to) {
            if (*to == '_') continue;
            const int digit = *to <= '9' ? *to - '0' : (*to | 0x20) - 'a' + 10;
            value = value * 16.0 + digit;
        }
        is_malformed = is_malformed || is_a(*to, kLetter | kDigit);
        while (is_a(*to, kLetter | kDigit)) ++to;
    } else {
        bool has_separators = false;
        const auto digits = [&] {
            for (; is_a(*to, kDigit) || (*to == '_' && is_a(to[1], kDigit) && to > at_); ++to) {
                has_separators = has_separators || *to == '_';
            }
        };
        digits();
        // `1..10` is a foreign range, `1.` is a number.
        if (*to == '.' && to[1] != '.') {
            ++to;
            if (is_a(*to, kDigit)) digits();
        }
        if (*to == 'e' || *to == 'E') {
            const char* exponent = to + 1;
            if (*exponent == '+' || *exponent == '-') ++exponent;
            if (is_a(*exponent, kDigit)) {
                to = exponent;
                while (is_a(*to, kDigit)) ++to;
            } else if (exponent != to + 1) {  // `1e-x`
                is_malformed = true;
                to = exponent;
                while (is_a(*to, kLetter | kDigit)) ++to;
            }
        }
        const char* number_begin = at_;
        if (has_separators) {
            std::copy_if(at_, to, std::back_inserter(without_separators),
                         [](char c) { return c != '_'; });
            without_separators.append(kMaxDigitRun, '\0');
            number_begin = without_separators.c_str();
        }
        value = parse_decimal(number_begin).value;
        // `1.2.3`, but not the range `0..10`.
        if (*to == '.' && is_a(to[1], kDigit)) {
            is_malformed = true;
            while (is_a(*to, kLetter | kDigit) || (*to == '.' && to[1] != '.')) ++to;
        }
    }
    Token token = finish(TokenKind::number, to);
    token.number = value;
    const std::string_view text(token_begin_, token.length);
    if (is_malformed) {
        diagnostics_.error(Code::E0008, span_from(token_begin_, to),
                           fmt::format("`{}` is not a number", text));
        token.number = 0.0;
    } else if (!std::isfinite(value)) {
        diagnostics_.error(Code::E0008, span_from(token_begin_, to),
                           "this number is too large; the largest is about 1.8e308");
        token.number = 0.0;
    } else if (is_a(*to, kLetter)) {
        number_suffix(token);
    }
    return token;
}

void Lexer::number_suffix(Token& token) {
    const char* const begin = at_;
    while (is_a(*at_, kLetter)) ++at_;
    const std::string_view name(begin, static_cast<std::size_t>(at_ - begin));
    token.length = static_cast<std::uint32_t>(at_ - token_begin_);
    token.has_unit = true;
    const auto unit = std::find_if(kUnits.begin(), kUnits.end(),
                                   [&](const Unit& candidate) { return candidate.name == name; });
    if (unit == kUnits.end()) {
        if (is_after_let_) return;  // `let 2nd`: no unit, but a name; the parser says so
        diagnostics_.error(Code::E0007, span_from(begin, at_),
                           fmt::format("unknown unit `{}`; units: deg rad turn m cm mm km", name));
        return;
    }
    token.number *= unit->factor;
    if (!std::isfinite(token.number)) token.number = 0.0;
}

// `#` begins a colour. Otherwise it is the comment of another language, and the line is skipped.
Token Lexer::hash() {
    const char* to = at_ + 1;
    while (is_a(*to, kHex)) ++to;
    const auto digits = static_cast<std::size_t>(to - at_) - 1;
    const bool is_word = is_a(*to, kLetter | kDigit);
    if (digits > 0 && !is_word) {
        if (digits != 3 && digits != 6 && digits != 8) {
            diagnostics_.error(
                Code::E0010, span_from(at_, to),
                fmt::format("a colour has 3, 6 or 8 hex digits; this has {}", digits));
        }
        return finish(TokenKind::color, to);
    }
    const char* line_end = at_;
    while (line_end < end_ && *line_end != '\n' && *line_end != '\r') ++line_end;
    while (line_end > at_ && is_a(line_end[-1], kBlank)) --line_end;
    const std::string_view line(at_, static_cast<std::size_t>(line_end - at_));
    Diagnostic* diagnostic = nullptr;
    if (line.starts_with("#declare") || line.starts_with("#local")) {
        std::string_view rest = line.substr(
            line.find_first_of(" \t") == line.npos ? line.size() : line.find_first_of(" \t") + 1);
        while (!rest.empty() && (rest.back() == ';' || is_a(rest.back(), kBlank))) {
            rest.remove_suffix(1);
        }
        diagnostic =
            &diagnostics_.error(Code::E0006, span_from(at_, line_end),
                                fmt::format("this looks like POV-Ray; write `let {}`", rest));
    } else if (line.starts_with("#include")) {
        diagnostic = &diagnostics_.error(Code::E0006, span_from(at_, at_ + 1),
                                         "this looks like POV-Ray or C; write `include \"file\"`");
    } else {
        diagnostic =
            &diagnostics_.error(Code::E0006, span_from(at_, at_ + 1), "comments start with `//`");
    }
    diagnostic->with_help("a colour is `#` and 3, 6 or 8 hex digits");
    skip_line_comment();
    return nothing();
}

Token Lexer::punctuation() {
    const auto one = [&](TokenKind kind) { return finish(kind, at_ + 1); };
    switch (*at_) {  // what stands in every line of a scene first
        case '{':
            return one(TokenKind::left_brace);
        case '}':
            return one(TokenKind::right_brace);
        case '[':
            return one(TokenKind::left_bracket);
        case ']':
            return one(TokenKind::right_bracket);
        case '(':
            return one(TokenKind::left_paren);
        case ')':
            return one(TokenKind::right_paren);
        case ',':
            return one(TokenKind::comma);
        case ';':
            return one(TokenKind::semicolon);
        case ':':
            return one(TokenKind::colon);
        default:
            return operator_token();
    }
}

Token Lexer::operator_token() {
    const std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
    const auto one = [&](TokenKind kind) { return finish(kind, at_ + 1); };
    const auto two = [&](TokenKind kind) { return finish(kind, at_ + 2); };
    if (rest.starts_with("==")) return two(TokenKind::equal_equal);
    if (rest.starts_with("!=")) return two(TokenKind::not_equal);
    if (rest.starts_with("<=")) return two(TokenKind::less_equal);
    if (rest.starts_with(">=")) return two(TokenKind::greater_equal);
    const bool is_compound = rest.size() > 1 && rest[1] == '=' &&
                             std::string_view("+-*/%^").find(rest[0]) != std::string_view::npos;
    if (is_compound) return two(TokenKind::foreign);
    for (const Foreign& foreign : kForeign) {
        // `--` may be two signs: `- -x` glued. The parser knows.
        if (rest.starts_with(foreign.text) && foreign.text != "++" && foreign.text != "--") {
            return finish(TokenKind::foreign, at_ + foreign.text.size());
        }
    }
    switch (rest[0]) {
        case '.':
            return one(TokenKind::dot);
        case '=':
            return one(TokenKind::equal);
        case '+':
            return one(TokenKind::plus);
        case '-':
            return one(TokenKind::minus);
        case '*':
            return one(TokenKind::star);
        case '/':
            return one(TokenKind::slash);
        case '%':
            return one(TokenKind::percent);
        case '^':
            return one(TokenKind::caret);
        case '<':
            return one(TokenKind::less);
        case '>':
            return one(TokenKind::greater);
        default:
            break;
    }
    if (static_cast<unsigned char>(rest[0]) >= 0x80) return foreign_character();
    if (rest[0] == '\'') return quoted_otherwise(1, "'");
    diagnostics_.error(Code::E0001, span_from(at_, at_ + 1),
                       fmt::format("`{}` means nothing here", rest.substr(0, 1)));
    ++at_;
    return nothing();
}

std::string_view foreign_operator_fix(std::string_view text) {
    for (const Foreign& foreign : kForeign) {
        if (foreign.text == text) return foreign.fix;
    }
    return {};
}

}  // namespace lray::parser
