// The parser's expressions that stand for themselves: literals, names, lists.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "image/srgb.h"
#include "parser/syntax/parser_state.h"

namespace lray::parser {

// primary = NUMBER | STRING | COLOR | "true" | "false" | IDENT | "(" expr ")" | list
Expr* Parser::primary() {
    const Token token = token_;
    if (token.kind == TokenKind::string) return string();
    if (token.kind == TokenKind::color) return color();
    if (token.kind == TokenKind::left_bracket) return list();
    if (token.kind == TokenKind::number) {
        advance();
        NumberExpr* made = make<NumberExpr>(ExprKind::number, span_of(token));
        made->value = token.number;
        made->has_unit = token.has_unit;
        return made;
    }
    if (is_one_of(token.kind, TokenKind::kw_true, TokenKind::kw_false)) {
        advance();
        BooleanExpr* made = make<BooleanExpr>(ExprKind::boolean, span_of(token));
        made->value = token.kind == TokenKind::kw_true;
        return made;
    }
    if (token.kind == TokenKind::identifier) {
        advance();
        NameExpr* made = make<NameExpr>(ExprKind::name, span_of(token));
        made->symbol = token.symbol;
        return made;
    }
    if (token.kind == TokenKind::left_paren) {
        const bool is_in_condition = is_condition_;
        Expr* inner = nullptr;
        {
            const InBrackets in_brackets(*this);
            advance();
            inner = expression();
            if (is_in_condition) inner = compared(inner);
        }
        close(TokenKind::right_paren, token);
        return inner;
    }
    missing_value();
    return error_expr(span_of(token));
}

void Parser::missing_value() {
    const Token token = token_;
    if (token.kind == TokenKind::less) {
        error(Code::E0109, span_of(token), "vectors are written `[1, 2, 3]`");
        while (token_.kind != TokenKind::greater && token_.kind != TokenKind::end &&
               token_.kind != TokenKind::left_brace && token_.kind != TokenKind::right_brace &&
               !ahead().newline_before) {
            advance();
        }
        if (token_.kind == TokenKind::greater) {
            advance();
            is_panicking_ = false;
        }
        return;
    }
    if (token.kind == TokenKind::foreign) {
        foreign_operator(nullptr);
        return;
    }
    if (is_reserved_word(token.kind)) {
        error(Code::E0114, span_of(token),
              fmt::format("`{}` is a keyword, kept for later", text_of(token)));
        return;
    }
    const bool is_elsewhere = token.newline_before || token.kind == TokenKind::end;
    error(Code::E0109, is_elsewhere ? here() : span_of(token),
          is_elsewhere ? std::string("expected a value")
                       : fmt::format("expected a value, found {}", describe(token)));
}

// list = "[" "]"
//      | "[" "for" IDENT [ "," IDENT ] "in" expr [ "if" expr ] ":" expr "]"
//      | "[" expr { "," expr } [ "," ] "]"
Expr* Parser::list() {
    if (Expr* packed = packed_list()) return packed;
    const Token opener = token_;
    const Nested nested(*this, span_of(opener));
    if (!nested.fits()) return error_expr(span_of(opener));
    std::vector<Expr*> elements;
    std::uint32_t depth = 0;
    const std::size_t error_count = diagnostics_.error_count();
    advance();
    if (token_.kind == TokenKind::kw_for) return comprehension(opener);
    const bool has_own_lines = token_.newline_before;
    std::optional<InBrackets> in_brackets(std::in_place, *this);
    while (token_.kind != TokenKind::right_bracket && !is_panicking_ && !is_ended_) {
        const bool is_property =
            token_.kind == TokenKind::identifier && ahead().kind == TokenKind::colon;
        if (is_property) {
            // The list was not closed: its last comma separates arguments or, if no bracket is open
            // around it, items.
            is_separated_ = bracket_depth_ == 1;
            break;
        }
        elements.push_back(expression());
        depth = std::max<std::uint32_t>(depth, elements.back()->depth);
        if (token_.kind == TokenKind::kw_for && !is_panicking_) {
            error(Code::E0106, span_of(token_),
                  fmt::format("`for` comes first: `[for x in xs: {}]`",
                              context_.sources.text(elements.back()->span)));
        }
        if (token_.kind != TokenKind::comma) break;
        advance();
    }
    in_brackets.reset();
    // Brackets of its elements that do not match make it look unclosed: they were told of already.
    const bool is_told = diagnostics_.error_count() > error_count;
    if (has_own_lines && is_told && token_.kind != TokenKind::right_bracket) is_panicking_ = true;
    if (!close(TokenKind::right_bracket, opener)) {
        if (has_own_lines) skip_to_closing_line(opener);
        return error_expr(span_from(opener.offset));
    }
    ListExpr* made = make<ListExpr>(ExprKind::list, span_from(opener.offset));
    made->depth = static_cast<std::uint16_t>(depth + 1);
    made->elements = context_.arena.copy(elements);
    if (depth + 1 > context_.max_nesting) too_deep(made->span);
    return made;
}

// What stands in the brackets of `[for i, x in xs if condition: value]`, and the closing one.
Expr* Parser::comprehension(const Token& opener) {
    std::optional<InBrackets> in_brackets(std::in_place, *this);
    const bool ran_any_times = std::exchange(around_.runs_any_times, true);
    const std::optional<LoopNames> names = loop_names("[for x in xs: 2 * x]");
    ComprehensionExpr parts;
    if (names && !is_panicking_) parts.sequence = expression();
    if (token_.kind == TokenKind::kw_if && !is_panicking_) {
        advance();
        parts.condition = compared(expression());
    }
    if (!is_panicking_ && token_.kind != TokenKind::colon) {
        const bool is_line_end = token_.newline_before || token_.kind == TokenKind::end;
        error(Code::E0107,
              is_line_end || token_.kind == TokenKind::right_bracket ? here() : span_of(token_),
              "expected `:` and the value of each element: `[for x in xs: 2 * x]`");
    }
    if (!is_panicking_) {
        advance();
        parts.value = expression();
    }
    around_.runs_any_times = ran_any_times;
    in_brackets.reset();
    if (!close(TokenKind::right_bracket, opener)) return error_expr(span_from(opener.offset));
    ComprehensionExpr* made = make<ComprehensionExpr>(
        ExprKind::comprehension, span_from(opener.offset),
        {parts.sequence, parts.condition != nullptr ? parts.condition : parts.value, parts.value});
    made->index_name = names->index_name;
    made->index_span = names->index_span;
    made->element_name = names->element_name;
    made->element_span = names->element_span;
    made->sequence = parts.sequence;
    made->condition = parts.condition;
    made->value = parts.value;
    return made;
}

Expr* Parser::string() {
    const Token token = token_;
    advance();
    const std::string_view text = text_of(token);
    std::string_view inner = text.substr(token.quote_size);
    const bool is_closed = token.quote_size > 1 || (!inner.empty() && inner.back() == text.front());
    if (is_closed) inner.remove_suffix(token.quote_size);
    const Span inner_span = lexer_.span(token.offset + token.quote_size, token.end());
    std::string buffer;
    const std::string_view value = unescape(inner, inner_span, buffer, diagnostics_);
    StringExpr* made = make<StringExpr>(ExprKind::string, span_of(token));
    made->value = context_.arena.copy(value);
    return made;
}

// `#rgb`, `#rrggbb`, `#rrggbbaa`: sRGB as a colour picker shows it.
Expr* Parser::color() {
    const Token token = token_;
    advance();
    const std::string_view digits = text_of(token).substr(1);
    const auto digit = [&](std::size_t i) {
        const char c = digits[i];
        return c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10;
    };
    ColorExpr* made = make<ColorExpr>(ExprKind::color, span_of(token));
    const bool is_short = digits.size() == 3;
    if (!is_short && digits.size() != 6 && digits.size() != 8) {  // reported by the lexer
        made->rgba[3] = 1.0;
        return made;
    }
    made->rgba[3] = 1.0;
    for (std::size_t i = 0; i < (is_short ? 3 : digits.size() / 2); ++i) {
        const int byte = is_short ? digit(i) * 17 : digit(2 * i) * 16 + digit(2 * i + 1);
        const double encoded = byte / 255.0;
        made->rgba[i] = i < 3 ? image::srgb_decode(encoded) : encoded;
    }
    return made;
}

}  // namespace lray::parser
