// The parser's expressions.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

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

}  // namespace

// expr = "if" expr "then" expr "else" expr | "fn" "(" [ params ] ")" "=" expr | or
Expr* Parser::expression() {
    const Nested nested(*this, span_of(token_));
    if (!nested.fits()) return error_expr(span_of(token_));
    if (token_.kind == TokenKind::kw_if) return conditional();
    const bool is_next_item = token_.kind == TokenKind::kw_fn && token_.newline_before &&
                              ahead().kind == TokenKind::identifier;
    if (token_.kind == TokenKind::kw_fn && !is_next_item) return function_value();
    return binary(0);
}

Expr* Parser::conditional() {
    const std::uint32_t begin = token_.offset;
    advance();
    Expr* condition = compared(expression());
    if (is_panicking_) return condition;
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

// After the left side of a comparison: `=` where `==` is meant.
Expr* Parser::compared(Expr* left) {
    if (is_panicking_ || token_.kind != TokenKind::equal || !continues_line()) return left;
    error(Code::E0111, span_of(token_), "use `==` to compare");
    is_panicking_ = false;
    advance();
    expression();
    return error_expr(left->span);
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
            const bool is_arrow = text_of(token_) == "=>" || text_of(token_) == "->";
            foreign_operator(left, true);
            // In front of an arrow stands a parameter, not the use of a name.
            return is_arrow ? error_expr(left->span) : left;
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
Expr* Parser::postfix_of(Expr* object, bool is_grouped, bool is_placed) {
    while (!is_panicking_) {
        const bool is_head = object->kind == ExprKind::name || object->kind == ExprKind::member ||
                             object->kind == ExprKind::index || object->kind == ExprKind::call ||
                             object->kind == ExprKind::block;
        const bool is_list = object->kind == ExprKind::list ||
                             object->kind == ExprKind::packed_list ||
                             object->kind == ExprKind::comprehension;
        if (token_.kind == TokenKind::left_brace && is_head && !is_condition_) {
            object = block(object, is_placed);
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
            Expr* index = nullptr;
            {
                const InBrackets in_brackets(*this);
                advance();
                index = expression();
            }
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
        } else if (token_.kind == TokenKind::string && is_head && !is_condition_ &&
                   ahead().kind == TokenKind::left_brace) {
            object = block(object, is_placed);
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
    std::optional<InBrackets> in_brackets(std::in_place, *this);
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
        if (token_.kind == TokenKind::equal && argument.value->kind == ExprKind::name) {
            const NameExpr& name = static_cast<const NameExpr&>(*argument.value);
            error(Code::E0107, span_of(token_),
                  fmt::format("an argument with a name is written `{}: ...`",
                              context_.symbols.text(name.symbol)));
            is_panicking_ = false;
            argument.name = name.symbol;
            argument.name_span = name.span;
            advance();
            argument.value = expression();
        }
        depth = std::max<std::uint32_t>(depth, argument.value->depth);
        arguments.push_back(argument);
        if (token_.kind != TokenKind::comma) break;
        advance();
    }
    in_brackets.reset();
    if (!close(TokenKind::right_paren, opener)) return error_expr(span_from(begin));
    CallExpr* made = make<CallExpr>(ExprKind::call, span_from(begin), {callee});
    made->depth = static_cast<std::uint16_t>(depth + 1);
    made->callee = callee;
    made->arguments = context_.arena.copy(arguments);
    if (depth + 1 > context_.max_nesting) too_deep(made->span);
    return made;
}

// block = head [ STRING ] body
Expr* Parser::block(Expr* head, bool is_placed) {
    const Nested nested(*this, span_of(token_));
    if (!nested.fits()) return error_expr(head->span);
    const std::uint32_t begin = head->span.offset;
    const StringExpr* label = nullptr;
    if (token_.kind == TokenKind::string) {
        Expr* made = string();
        if (made->kind == ExprKind::string) label = static_cast<StringExpr*>(made);
    }
    Surroundings inside = is_placed ? around_.placed_block() : around_.value_block();
    inside.has_children =
        head->kind == ExprKind::name &&
        find_block(static_cast<const NameExpr*>(head)->symbol) == &block_schema(BlockKind::group);
    const Body made_body = body(context_.sources.text(head->span), inside);
    BlockExpr* made = make<BlockExpr>(ExprKind::block, span_from(begin), {head});
    made->head = head;
    made->label = label;
    made->body = made_body;
    return made;
}

}  // namespace lray::parser
