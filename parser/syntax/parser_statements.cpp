// The parser's statements: if, for, while and what leaves them.
#include <fmt/format.h>

#include <string>
#include <utility>

#include "parser/syntax/parser_state.h"

namespace lray::parser {

namespace {

/// `else if` in other languages.
constexpr bool is_else_if(std::string_view word) {
    return word == "elif" || word == "elsif" || word == "elseif";
}

}  // namespace

// if = "if" cond body [ "else" ( if | body ) ]
Item* Parser::if_statement() {
    const Token keyword = token_;
    const Nested nested(*this, span_of(keyword));  // a chain of `else if` is as deep as it is long
    if (!nested.fits()) return nullptr;
    ConditionalItem* result = make_item<ConditionalItem>(ItemKind::conditional, span_of(keyword));
    advance();
    result->condition = condition(keyword, "`if` needs a condition, like `n > 0`");
    const Surroundings branch = around_.branch();
    result->then_body = statement_body(keyword, branch);
    if (!is_panicking_) else_branch(*result, branch);
    result->span = span_from(keyword.offset);
    return result;
}

// What may stand behind the body of an `if`.
void Parser::else_branch(ConditionalItem& item, const Surroundings& around) {
    const Token word = token_;
    const bool is_foreign = word.kind == TokenKind::identifier && is_else_if(text_of(word)) &&
                            !is_one_of(ahead().kind, TokenKind::colon, TokenKind::equal,
                                       TokenKind::left_brace, TokenKind::dot);
    if (is_foreign) {
        error(Code::E0117, span_of(word), "write `else if`");
        is_panicking_ = false;
    } else if (word.kind == TokenKind::kw_else) {
        advance();
    } else {
        return;
    }
    item.has_else = true;
    const Token next = token_;
    if (is_foreign || next.kind == TokenKind::kw_if) {
        const Surroundings outer = std::exchange(around_, around);
        Item* const inner = if_statement();
        around_ = outer;
        if (inner == nullptr) return;
        item.else_body.items = context_.arena.copy(std::span<Item* const>(&inner, 1));
        item.else_body.open = span_of(next);
        item.else_body.close = here();
        return;
    }
    item.else_body = statement_body(word, around);
}

// for = "for" IDENT [ "," IDENT ] "in" cond body
Item* Parser::for_statement() {
    const Token keyword = token_;
    const Nested nested(*this, span_of(keyword));
    if (!nested.fits()) return nullptr;
    const std::optional<LoopNames> names = loop_names("for i in range(10) { }");
    ForItem* result = make_item<ForItem>(ItemKind::for_loop, span_of(keyword));
    if (names) {
        result->sequence = condition(keyword, "`in` needs a list, like `range(10)`");
        result->index_name = names->index_name;
        result->index_span = names->index_span;
        result->element_name = names->element_name;
        result->element_span = names->element_span;
    }
    result->body = statement_body(keyword, around_.loop());
    result->span = span_from(keyword.offset);
    return names ? result : nullptr;  // without its names the body would be all mistakes
}

// while = "while" cond body
Item* Parser::while_statement() {
    const Token keyword = token_;
    const Nested nested(*this, span_of(keyword));
    if (!nested.fits()) return nullptr;
    WhileItem* result = make_item<WhileItem>(ItemKind::while_loop, span_of(keyword));
    advance();
    const bool ran_any_times = std::exchange(around_.runs_any_times, true);
    result->condition = condition(keyword, "`while` needs a condition, like `n > 0`");
    around_.runs_any_times = ran_any_times;
    result->body = statement_body(keyword, around_.loop());
    result->span = span_from(keyword.offset);
    return result;
}

// At `for`: it, one or two names, and `in`.
std::optional<LoopNames> Parser::loop_names(std::string_view example) {
    LoopNames names;
    advance();
    const auto one = [&](std::string_view after) -> std::optional<Token> {
        const bool is_name_missing =
            continues_line() && is_one_of(token_.kind, TokenKind::kw_in, TokenKind::left_paren);
        if (!is_name_missing) return new_name(after);
        error(Code::E0102, span_of(token_), fmt::format("expected a name after `{}`", after))
            .with_help(fmt::format("a loop is written `{}`", example));
        return std::nullopt;
    };
    const std::optional<Token> first = one("for");
    if (!first) return std::nullopt;
    names.element_name = first->symbol;
    names.element_span = span_of(*first);
    if (token_.kind == TokenKind::comma) {
        advance();
        const std::optional<Token> second = one(",");
        if (!second) return std::nullopt;
        names.index_name = std::exchange(names.element_name, second->symbol);
        names.index_span = std::exchange(names.element_span, span_of(*second));
    }
    if (token_.kind == TokenKind::kw_in) {
        advance();
        return names;
    }
    Diagnostic& diagnostic =
        error(Code::E0107, here(),
              fmt::format("expected `in` after `{}`", context_.symbols.text(names.element_name)));
    if (token_.kind == TokenKind::comma) {
        diagnostic.with_help("one name is for the element, two are for its index and the element");
    } else {
        diagnostic.with_help(fmt::format("a loop is written `{}`", example));
    }
    return std::nullopt;
}

// cond = expr
//
// A `{` behind a name in it opens the body; inside ( ) and [ ] it opens a block again.
Expr* Parser::condition(const Token& keyword, std::string_view missing) {
    // Behind `in` a line may end.
    const bool is_next_item = keyword.kind == TokenKind::kw_for
                                  ? is_item_keyword(token_.kind) &&
                                        !is_one_of(token_.kind, TokenKind::kw_if, TokenKind::kw_fn)
                                  : true;
    const bool is_missing =
        is_one_of(token_.kind, TokenKind::left_brace, TokenKind::right_brace, TokenKind::end) ||
        (token_.newline_before && is_next_item);
    if (is_missing) {
        error(Code::E0109, here(), std::string(missing));
        is_panicking_ = !(token_.kind == TokenKind::left_brace && !token_.newline_before);
        return error_expr(span_of(keyword));
    }
    const bool outer = std::exchange(is_condition_, true);
    Expr* result = compared(expression());
    if (skip_list_without_opener(*result)) result = error_expr(result->span);
    is_condition_ = outer;
    return result;
}

// The body of a statement, or the report that its braces are missing.
Body Parser::statement_body(const Token& head, const Surroundings& around) {
    if (is_panicking_ && !skip_to_body()) return {};
    if (is_ended_) return {};
    if (token_.kind == TokenKind::left_brace) return body(text_of(head), around);
    const bool is_beside = !token_.newline_before && token_.kind != TokenKind::end;
    error(Code::E0116, is_beside ? span_of(token_) : here(),
          fmt::format("the body of `{}` needs `{{ }}`", text_of(head)));
    const bool is_word =
        is_one_of(token_.kind, TokenKind::colon, TokenKind::semicolon, TokenKind::kw_then) ||
        (token_.kind == TokenKind::identifier && text_of(token_) == "do");
    if (is_word && is_beside) advance();
    if (token_.kind == TokenKind::left_brace) {
        is_panicking_ = false;
        body(text_of(head), around);
    } else {
        items_without_braces(head, around);
    }
    return {};
}

// Behind a mistake that was reported: reads what most likely is the body, up to its `}` when only
// the `{` is missing, one item beside the head, or the lines below that stand further in.
void Parser::items_without_braces(const Token& head, const Surroundings& around) {
    const std::uint32_t indent = line_indent(head.offset);
    const bool is_below = token_.newline_before && line_indent(token_.offset) > indent;
    const bool is_item = token_.kind == TokenKind::identifier
                             ? starts_item(token_, ahead()) ||
                                   is_one_of(ahead().kind, TokenKind::left_paren, TokenKind::dot)
                             : is_item_keyword(token_.kind);
    const bool is_beside = !token_.newline_before && is_item;
    if (is_ended_ || (!is_below && !is_beside)) return;
    is_panicking_ = false;
    has_broken_brackets_ = false;
    const Surroundings outer = std::exchange(around_, around);
    const bool was_condition = std::exchange(is_condition_, false);
    const std::uint32_t outer_brackets = std::exchange(bracket_depth_, 0u);
    if (is_below || line_closes_too_many_braces(token_)) {
        openers_.push_back({head.offset, indent});
        // Whatever the braces say: these lines end where their indentation does.
        const Structure by =
            std::exchange(structure_, is_below ? Structure::indentation : structure_);
        items(false);
        const bool is_closed = token_.kind == TokenKind::right_brace && !closes_outer_block(token_);
        structure_ = by;
        openers_.pop_back();
        const bool is_own = !token_.newline_before || line_indent(token_.offset) == indent;
        if (is_closed && is_own) advance();
    } else {
        item();
    }
    bracket_depth_ = outer_brackets;
    is_condition_ = was_condition;
    around_ = outer;
}

// After a mistake in the head of a statement: goes on at the `{` of its body, if its line has one.
bool Parser::skip_to_body() {
    if (is_separated_ || is_ended_) return false;
    while (!token_.newline_before &&
           !is_one_of(token_.kind, TokenKind::left_brace, TokenKind::right_brace, TokenKind::end)) {
        advance();
    }
    if (token_.kind != TokenKind::left_brace || token_.newline_before) return false;
    is_panicking_ = false;
    has_broken_brackets_ = false;
    return true;
}

// `break` and `continue`.
Item* Parser::jump() {
    const Token keyword = token_;
    advance();
    if (!around_.is_in_loop) {
        Diagnostic& diagnostic = error(Code::E0119, span_of(keyword),
                                       fmt::format("`{}` outside a loop", text_of(keyword)));
        if (around_.has_loop_outside) {
            diagnostic.with_note(
                "the loop around this block, function or value cannot be left from in it");
        }
        is_panicking_ = false;
    }
    return make_item<Item>(
        keyword.kind == TokenKind::kw_break ? ItemKind::break_loop : ItemKind::continue_loop,
        span_of(keyword));
}

// return = "return" expr
Item* Parser::return_statement() {
    const Token keyword = token_;
    if (!around_.is_in_function) {
        Diagnostic& diagnostic =
            error(Code::E0119, span_of(keyword), "`return` outside a function");
        if (around_.has_function_outside) {
            diagnostic.with_note("the function around this value cannot be left from in it");
        } else if (around_.is_in_component) {
            diagnostic.with_help("a component places what stands in it; `fn` returns a value");
        }
        skip_balanced();
        is_panicking_ = false;
        return nullptr;
    }
    advance();
    ReturnItem* result = make_item<ReturnItem>(ItemKind::return_value, span_of(keyword));
    const bool is_missing =
        token_.newline_before || is_one_of(token_.kind, TokenKind::right_brace,
                                           TokenKind::semicolon, TokenKind::comma, TokenKind::end);
    if (is_missing) {
        error(Code::E0109, span_of(keyword), "`return` needs a value, like `return 0`");
        is_panicking_ = false;
        result->value = error_expr(span_of(keyword));
        return result;
    }
    result->value = value();
    result->span = span_from(keyword.offset);
    return result;
}

}  // namespace lray::parser
