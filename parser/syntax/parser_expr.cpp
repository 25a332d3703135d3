// The parser's expressions.
#include <fmt/format.h>

#include <array>
#include <utility>

#include "image/srgb.h"
#include "parser/syntax/characters.h"
#include "parser/syntax/parser_state.h"

namespace lray::parser {

namespace {

/// How tightly a binary operator binds; higher is tighter, 0 is no binary operator. All are left
/// associative but comparisons, which do not chain, and `^`, which has a production of its own.
constexpr unsigned binary_priority(TokenKind kind) {
    using enum TokenKind;
    if (kind == kw_or) return 1;
    if (kind == kw_and) return 2;
    if (is_one_of(kind, equal_equal, not_equal, less, less_equal, greater, greater_equal)) return 4;
    if (is_one_of(kind, plus, minus)) return 5;
    if (is_one_of(kind, star, slash, percent)) return 6;
    return 0;
}

constexpr unsigned kNotPriority = 3;  // prefix: between `and` and the comparisons
constexpr unsigned kComparisonPriority = binary_priority(TokenKind::less);
static_assert(binary_priority(TokenKind::kw_and) < kNotPriority &&
              kNotPriority < kComparisonPriority);

/// Returns what to write in place of a foreign operator, with spaces where a word would run into
/// its neighbours; empty where that is not sure: `not` binds less tightly than `!`.
std::string own_operator(std::string_view text, const Token& token) {
    const std::string_view foreign = text.substr(token.offset, token.length);
    if (foreign == "**") return "^";
    if (foreign != "&&" && foreign != "||") return {};
    const auto is_space = [&](std::size_t at) {
        return at < text.size() && (text[at] == ' ' || text[at] == '\t');
    };
    const bool stands_apart = token.offset > 0 && is_space(token.offset - 1);
    return fmt::format("{}{}{}", stands_apart ? "" : " ", foreign == "&&" ? "and" : "or",
                       is_space(token.end()) ? "" : " ");
}

}  // namespace

// expr = "if" expr "then" expr "else" expr | or
Expr* Parser::expression() {
    const Nested nested(*this, span_of(token_));
    if (!nested.fits()) return error_expr(span_of(token_));
    if (token_.kind == TokenKind::kw_if) return conditional();
    return binary(0);
}

Expr* Parser::conditional() {
    const std::uint32_t begin = token_.offset;
    advance();
    Expr* condition = expression();
    if (is_panicking_) return condition;
    if (token_.kind == TokenKind::equal) {
        error(Code::E0111, span_of(token_), "use `==` to compare");
        is_panicking_ = false;
        advance();
        expression();
        condition = error_expr(condition->span);
        is_panicking_ = false;
    }
    const auto expect = [&](TokenKind kind, std::string_view word) {
        if (token_.kind == kind) {
            advance();
            return true;
        }
        error(Code::E0117, here(),
              fmt::format("expected `{}`: a choice is written `if a then b else c`", word));
        return false;
    };
    if (!expect(TokenKind::kw_then, "then")) return error_expr(span_from(begin));
    Expr* then_value = expression();
    if (is_panicking_) return then_value;
    if (!expect(TokenKind::kw_else, "else")) return error_expr(span_from(begin));
    Expr* else_value = expression();
    ConditionalExpr* result = make<ConditionalExpr>(ExprKind::conditional, span_from(begin),
                                                    {condition, then_value, else_value});
    result->condition = condition;
    result->then_value = then_value;
    result->else_value = else_value;
    return result;
}

// or  = and { "or" and } ;  and = not { "and" not } ;  not = "not" not | cmp
// cmp = sum [ ( "==" | "!=" | "<" | "<=" | ">" | ">=" ) sum ]
// sum = term { ( "+" | "-" ) term } ;  term = unary { ( "*" | "/" | "%" ) unary }
Expr* Parser::binary(unsigned limit) {
    Expr* left = nullptr;
    if (token_.kind == TokenKind::kw_not && limit < kNotPriority) {
        const Nested nested(*this, span_of(token_));
        if (!nested.fits()) return error_expr(span_of(token_));
        const std::uint32_t begin = token_.offset;
        advance();
        Expr* operand = binary(kNotPriority - 1);
        UnaryExpr* made = make<UnaryExpr>(ExprKind::unary, span_from(begin), {operand});
        made->op = TokenKind::kw_not;
        made->operand = operand;
        left = made;
    } else {
        left = unary();
    }
    while (!is_panicking_) {
        if (token_.kind == TokenKind::foreign && continues_line()) {
            foreign_operator(left);
            break;
        }
        const unsigned priority = binary_priority(token_.kind);
        if (priority <= limit || !continues_line()) break;
        const Token op = token_;
        advance();
        Expr* right = binary(priority);
        BinaryExpr* made =
            make<BinaryExpr>(ExprKind::binary, span_from(left->span.offset), {left, right});
        made->op = op.kind;
        made->op_span = span_of(op);
        made->left = left;
        made->right = right;
        left = made;
        const bool is_chained = priority == kComparisonPriority && continues_line() &&
                                binary_priority(token_.kind) == kComparisonPriority;
        if (is_chained && !is_panicking_) {
            chained_comparison(*made);
            left = error_expr(span_from(made->span.offset));
        }
    }
    return left;
}

// `a < b < c`: reported with its rewrite, and read to its end.
void Parser::chained_comparison(const BinaryExpr& first) {
    const Token op = token_;
    advance();
    const Expr* last = binary(kComparisonPriority);
    if (is_panicking_) return;
    const Sources& sources = context_.sources;
    std::string rewrite = fmt::format("{} and {}", sources.text(first.span),
                                      sources.text(join(first.right->span, last->span)));
    while (binary_priority(token_.kind) == kComparisonPriority && continues_line()) {
        advance();
        const Expr* next = binary(kComparisonPriority);
        if (is_panicking_) return;
        rewrite += fmt::format(" and {}", sources.text(join(last->span, next->span)));
        last = next;
    }
    error(Code::E0110, span_of(op), fmt::format("write `{}`", rewrite))
        .with_note("comparisons cannot be chained");
    is_panicking_ = false;
}

// unary = ( "-" | "+" ) unary | power
Expr* Parser::unary() {
    if (token_.kind != TokenKind::minus && token_.kind != TokenKind::plus) return power();
    const Nested nested(*this, span_of(token_));
    if (!nested.fits()) return error_expr(span_of(token_));
    const Token op = token_;
    advance();
    Expr* operand = unary();
    UnaryExpr* made = make<UnaryExpr>(ExprKind::unary, span_from(op.offset), {operand});
    made->op = op.kind;
    made->operand = operand;
    return made;
}

// power = postfix [ "^" unary ]
Expr* Parser::power() {
    Expr* base = postfix();
    if (is_panicking_ || token_.kind != TokenKind::caret || !continues_line()) return base;
    const Nested nested(*this, span_of(token_));
    if (!nested.fits()) return base;
    const Token op = token_;
    advance();
    Expr* exponent = unary();
    BinaryExpr* made =
        make<BinaryExpr>(ExprKind::binary, span_from(base->span.offset), {base, exponent});
    made->op = op.kind;
    made->op_span = span_of(op);
    made->left = base;
    made->right = exponent;
    return made;
}

// postfix = primary { "." IDENT | "[" expr "]" | "(" [ args ] ")" | [ STRING ] body }
Expr* Parser::postfix() {
    const bool is_grouped = token_.kind == TokenKind::left_paren;
    Expr* object = primary();
    return is_panicking_ ? object : postfix_of(object, is_grouped);
}

// What follows a primary: an index may follow what stands in parentheses, too.
Expr* Parser::postfix_of(Expr* object, bool is_grouped) {
    while (!is_panicking_) {
        const bool is_head = object->kind == ExprKind::name || object->kind == ExprKind::member ||
                             object->kind == ExprKind::index || object->kind == ExprKind::call ||
                             object->kind == ExprKind::block;
        const bool is_list =
            object->kind == ExprKind::list || object->kind == ExprKind::packed_list;
        if (token_.kind == TokenKind::left_brace && is_head) {
            object = block(object);
            continue;
        }
        if (!continues_line()) return object;
        const std::uint32_t begin = object->span.offset;
        if (token_.kind == TokenKind::dot) {
            advance();
            if (token_.kind != TokenKind::identifier) {
                error(Code::E0102, span_of(token_), "expected a name after `.`");
                return error_expr(object->span);
            }
            const Token name = token_;
            advance();
            MemberExpr* made = make<MemberExpr>(ExprKind::member, span_from(begin), {object});
            made->object = object;
            made->name = name.symbol;
            made->name_span = span_of(name);
            object = made;
        } else if (token_.kind == TokenKind::left_bracket && (is_head || is_list || is_grouped)) {
            const Token opener = token_;
            ++bracket_depth_;
            advance();
            Expr* index = expression();
            --bracket_depth_;
            if (is_list && token_.kind == TokenKind::comma) {  // `[[1, 2] [3, 4]]`
                error(Code::E0106, span_of(opener), "expected `,` before `[`");
            }
            close(TokenKind::right_bracket, opener);
            IndexExpr* made = make<IndexExpr>(ExprKind::index, span_from(begin), {object, index});
            made->object = object;
            made->index = index;
            object = made;
        } else if (token_.kind == TokenKind::left_paren && is_head) {
            object = call(object);
        } else if (token_.kind == TokenKind::string && is_head &&
                   ahead().kind == TokenKind::left_brace) {
            object = block(object);
        } else {
            return object;
        }
    }
    return object;
}

// args = arg { "," arg } [ "," ] ;  arg = [ IDENT ":" ] expr
Expr* Parser::call(Expr* callee) {
    const Token opener = token_;
    const std::uint32_t begin = callee->span.offset;
    std::vector<Argument> arguments;
    std::uint32_t depth = callee->depth;
    ++bracket_depth_;
    advance();
    while (token_.kind != TokenKind::right_paren && !is_panicking_ && !is_ended_) {
        Argument argument;
        if (token_.kind == TokenKind::identifier && ahead().kind == TokenKind::colon) {
            argument.name = token_.symbol;
            argument.name_span = span_of(token_);
            advance();
            advance();
        }
        argument.value = expression();
        depth = std::max<std::uint32_t>(depth, argument.value->depth);
        arguments.push_back(argument);
        if (token_.kind != TokenKind::comma) break;
        advance();
    }
    --bracket_depth_;
    if (!close(TokenKind::right_paren, opener)) return error_expr(span_from(begin));
    CallExpr* made = make<CallExpr>(ExprKind::call, span_from(begin), {callee});
    made->depth = static_cast<std::uint16_t>(depth + 1);
    made->callee = callee;
    made->arguments = context_.arena.copy(arguments);
    if (depth + 1 > context_.max_nesting) too_deep(made->span);
    return made;
}

// block = head [ STRING ] body
Expr* Parser::block(Expr* head) {
    const Nested nested(*this, span_of(token_));
    if (!nested.fits()) return error_expr(head->span);
    const std::uint32_t begin = head->span.offset;
    const StringExpr* label = nullptr;
    if (token_.kind == TokenKind::string) {
        Expr* made = string();
        if (made->kind == ExprKind::string) label = static_cast<StringExpr*>(made);
    }
    const Body made_body = body(context_.sources.text(head->span));
    BlockExpr* made = make<BlockExpr>(ExprKind::block, span_from(begin), {head});
    made->head = head;
    made->label = label;
    made->body = made_body;
    return made;
}

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
        ++bracket_depth_;
        advance();
        Expr* inner = expression();
        --bracket_depth_;
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
    if (is_future_keyword(token.kind)) {
        error(Code::E0120, span_of(token),
              fmt::format("`{}` is not available in this version of lray", text_of(token)));
        return;
    }
    const bool is_elsewhere = token.newline_before || token.kind == TokenKind::end;
    error(Code::E0109, is_elsewhere ? here() : span_of(token),
          is_elsewhere ? std::string("expected a value")
                       : fmt::format("expected a value, found {}", describe(token)));
}

// list = "[" "]" | "[" expr { "," expr } [ "," ] "]"
Expr* Parser::list() {
    if (Expr* packed = packed_list()) return packed;
    const Token opener = token_;
    const Nested nested(*this, span_of(opener));
    if (!nested.fits()) return error_expr(span_of(opener));
    std::vector<Expr*> elements;
    std::uint32_t depth = 0;
    ++bracket_depth_;
    advance();
    if (token_.kind == TokenKind::kw_for) {
        error(Code::E0120, span_of(token_), "`for` is not available in this version of lray");
        --bracket_depth_;
        return error_expr(span_of(opener));
    }
    while (token_.kind != TokenKind::right_bracket && !is_panicking_ && !is_ended_) {
        const bool is_property =
            token_.kind == TokenKind::identifier && ahead().kind == TokenKind::colon;
        if (is_property) {  // the list was not closed, and its last comma is a separator
            is_separated_ = true;
            break;
        }
        elements.push_back(expression());
        depth = std::max<std::uint32_t>(depth, elements.back()->depth);
        if (token_.kind != TokenKind::comma) break;
        advance();
    }
    --bracket_depth_;
    if (!close(TokenKind::right_bracket, opener)) return error_expr(span_from(opener.offset));
    ListExpr* made = make<ListExpr>(ExprKind::list, span_from(opener.offset));
    made->depth = static_cast<std::uint16_t>(depth + 1);
    made->elements = context_.arena.copy(elements);
    if (depth + 1 > context_.max_nesting) too_deep(made->span);
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

// An operator of another language; `left` is what stands before it.
void Parser::foreign_operator(const Expr* left) {
    const Token token = token_;
    const std::string_view text = text_of(token);
    std::string message(foreign_operator_fix(text));
    if (message.empty()) {  // `+=` and its like
        const std::string_view name =
            left != nullptr ? context_.sources.text(left->span) : std::string_view("i");
        advance();
        const std::uint32_t begin = token_.offset;
        const bool has_value = !token_.newline_before && token_.kind != TokenKind::end;
        if (has_value) expression();
        const std::string_view value =
            has_value && !is_panicking_ ? context_.sources.text(span_from(begin)) : "1";
        message = fmt::format("write `{0} = {0} {1} {2}`", name, text.substr(0, 1), value);
    }
    Diagnostic& diagnostic = error(Code::E0112, span_of(token), std::move(message));
    const std::string ours = own_operator(context_.sources[source_].text.view(), token);
    if (!ours.empty()) diagnostic.with_fix(span_of(token), ours);
}

}  // namespace lray::parser
