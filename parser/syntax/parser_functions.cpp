// The parser's functions, function values and components, with their parameters.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "parser/syntax/parser_state.h"

namespace lray::parser {

// fn = "fn" IDENT "(" [ params ] ")" ( "=" expr | body )
Item* Parser::function() {
    const Token keyword = token_;
    const Nested nested(*this, span_of(keyword));
    if (!nested.fits()) return nullptr;
    const std::string_view doc = doc_comment();
    advance();
    if (token_.kind == TokenKind::left_paren) {
        error(Code::E0102, span_of(token_), "expected a name after `fn`")
            .with_help("a function that stands alone has one: `fn name(x) = x * x`");
        if (skip_to_body()) body("fn", around_.function());
        return nullptr;
    }
    const std::optional<Token> name = new_name("fn");
    if (!name) {
        if (skip_to_body()) body("fn", around_.function());
        return nullptr;
    }
    FunctionItem* result = function_item(*name, doc);
    Function& made = *result->function;
    const std::string head = fmt::format("fn {}", text_of(*name));
    bool is_right = parameters(made, head);
    if (is_right) {
        is_right = function_result(made, *name);
    } else if (skip_to_body()) {
        body(head, around_.function());
    }
    result->span = span_from(keyword.offset);
    return is_right ? result : poisoned(*name);
}

// A function or component that has no more than its name yet.
FunctionItem* Parser::function_item(const Token& name, std::string_view doc) {
    FunctionItem* result = make_item<FunctionItem>(ItemKind::function, span_of(name));
    result->function = context_.arena.make<Function>();
    result->function->name = name.symbol;
    result->function->name_span = span_of(name);
    result->function->doc = doc;
    return result;
}

// What stands behind the parameters of a `fn`: `= value` or a body. Returns false when something
// was reported.
bool Parser::function_result(Function& function, const Token& name) {
    const Token token = token_;
    const std::string_view text = text_of(name);
    if (token.kind == TokenKind::left_brace) {
        function.body = body(text, around_.function());
        return true;
    }
    if (token.kind == TokenKind::equal) {
        advance();
        if (token_.kind == TokenKind::left_brace) {
            error(Code::E0109, span_of(token), "a body in braces has no `=` before it");
            is_panicking_ = false;
            body(text, around_.function());
            return false;
        }
        const Surroundings outer = std::exchange(around_, around_.function_value());
        function.value = value();
        around_ = outer;
        return true;
    }
    const bool is_foreign = token.kind == TokenKind::foreign && continues_line();
    const bool is_arrow = is_foreign && text_of(token) == "=>";
    const bool is_typed = (token.kind == TokenKind::colon && continues_line()) ||
                          (is_foreign && text_of(token) == "->");
    const char* const message = is_arrow   ? "the value of a function stands behind `=`"
                                : is_typed ? "the value of a function has no type of its own"
                                           : "expected `=` or `{` behind the parameters";
    error(Code::E0107, continues_line() && token.kind != TokenKind::end ? span_of(token) : here(),
          message)
        .with_help(fmt::format("write `fn {0}(...) = value` or `fn {0}(...) {{ ... }}`", text));
    if (is_typed && skip_to_body()) {
        body(text, around_.function());
    } else if (!is_arrow) {
        items_without_braces(name, around_.function());
    }
    return false;
}

// component = "component" IDENT "(" [ params ] ")" body
Item* Parser::component() {
    const Token keyword = token_;
    const Nested nested(*this, span_of(keyword));
    if (!nested.fits()) return nullptr;
    const std::string_view doc = doc_comment();
    advance();
    const std::optional<Token> name = new_name("component");
    if (!name) {
        if (skip_to_body()) body("component", around_.component());
        return nullptr;
    }
    FunctionItem* result = function_item(*name, doc);
    Function& made = *result->function;
    made.is_component = true;
    const bool is_right = parameters(made, fmt::format("component {}", text_of(*name)));
    if (is_right && token_.kind == TokenKind::equal) {
        error(Code::E0116, span_of(token_), "the body of `component` needs `{ }`")
            .with_help(fmt::format("a value is made by `fn {}(...) = ...`", text_of(*name)));
        advance();
        is_panicking_ = false;
        expression();
        return poisoned(*name);
    }
    made.body = statement_body(keyword, around_.component());
    result->span = span_from(keyword.offset);
    return is_right ? result : poisoned(*name);
}

// A function value: `fn(x) = x * x`.
Expr* Parser::function_value() {
    const Token keyword = token_;
    advance();
    if (token_.kind == TokenKind::identifier && continues_line()) {
        error(Code::E0106, span_of(token_), "a function that is a value has no name")
            .with_help("write `fn(x) = ...`");
        return error_expr(span_of(keyword));
    }
    Function* function = context_.arena.make<Function>();
    function->name_span = span_of(keyword);
    if (!parameters(*function, "fn")) return error_expr(span_from(keyword.offset));
    if (token_.kind != TokenKind::equal) {
        error(Code::E0107, token_.newline_before ? here() : span_of(token_),
              "expected `=` and one value: `fn(x) = x * x`");
        if (token_.kind == TokenKind::left_brace && continues_line()) {
            is_panicking_ = false;
            body("fn", around_.function());
        }
        return error_expr(span_from(keyword.offset));
    }
    advance();
    const Surroundings outer = std::exchange(around_, around_.function_value());
    function->value = expression();
    around_ = outer;
    FunctionExpr* made =
        make<FunctionExpr>(ExprKind::function, span_from(keyword.offset), {function->value});
    made->function = function;
    for (const ParameterDecl& declared : function->parameters) {
        if (declared.default_value == nullptr) continue;
        made->depth = std::max<std::uint16_t>(
            made->depth, static_cast<std::uint16_t>(declared.default_value->depth + 1));
    }
    if (made->depth > context_.max_nesting) too_deep(made->span);
    return made;
}

// params = pdecl { "," pdecl } [ "," ]
//
// Returns false when something was reported; what follows is read as if it had been right.
bool Parser::parameters(Function& function, std::string_view head) {
    if (token_.kind != TokenKind::left_paren || !continues_line()) {
        error(Code::E0107, here(), fmt::format("expected `(` after `{}`", head))
            .with_help(fmt::format("without parameters it is `{}()`", head));
        if (token_.kind == TokenKind::left_brace && continues_line()) is_panicking_ = false;
        return false;
    }
    const Token opener = token_;
    std::vector<ParameterDecl> list;
    {
        const InBrackets in_brackets(*this);
        const bool ran_any_times = std::exchange(around_.runs_any_times, true);  // its defaults
        advance();
        while (token_.kind != TokenKind::right_paren && !is_panicking_ && !is_ended_) {
            if (!parameter(list)) break;
            if (token_.kind != TokenKind::comma) break;
            advance();
        }
        around_.runs_any_times = ran_any_times;
    }
    function.parameters = context_.arena.copy(list);
    if (close(TokenKind::right_paren, opener)) return true;
    if (token_.kind == TokenKind::left_brace && continues_line()) {  // only the `)` was missing
        is_panicking_ = false;
        has_broken_brackets_ = false;
    }
    return false;
}

// pdecl = IDENT [ ":" type ] [ "=" expr ]
//
// Returns false at what cannot be a parameter.
bool Parser::parameter(std::vector<ParameterDecl>& list) {
    const bool is_next_item =
        token_.newline_before && is_keyword(token_.kind) && starts_item(token_, ahead());
    if (is_next_item || token_.kind == TokenKind::left_brace) return false;
    if (is_keyword(token_.kind)) {
        error(Code::E0114, span_of(token_),
              fmt::format("`{}` is a keyword; choose another name", text_of(token_)));
        return false;
    }
    if (token_.kind != TokenKind::identifier) {
        const bool is_end = token_.kind == TokenKind::end || is_closing(token_.kind);
        if (is_end) return false;
        error(Code::E0102, span_of(token_),
              fmt::format("expected the name of a parameter, found {}", describe(token_)));
        return false;
    }
    const Token name = token_;
    ParameterDecl made;
    made.name = name.symbol;
    made.name_span = span_of(name);
    advance();
    if (token_.kind == TokenKind::colon) {
        advance();
        const bool is_default = is_one_of(
            token_.kind, TokenKind::number, TokenKind::string, TokenKind::color,
            TokenKind::left_bracket, TokenKind::minus, TokenKind::kw_true, TokenKind::kw_false);
        if (is_default) {
            error(Code::E0107, span_of(token_),
                  fmt::format("a default is written `{} = ...`", text_of(name)));
            is_panicking_ = false;
            made.default_value = expression();
            list.push_back(made);
            return !is_panicking_;
        }
        made.type = type();
        if (is_panicking_) return false;
    } else if (token_.kind == TokenKind::identifier && !token_.newline_before) {
        const Token second = token_;  // `float x`, or a comma is missing
        advance();
        const bool is_list_end = is_one_of(token_.kind, TokenKind::comma, TokenKind::right_paren);
        const auto known = std::find(kTypeNames.begin(), kTypeNames.end(), text_of(name));
        const std::string_view first_type =
            known != kTypeNames.end() ? *known : usual_type(text_of(name));
        error(Code::E0106, span_of(second),
              fmt::format("expected `,` or `)`, found `{}`", text_of(second)))
            .with_help(
                is_list_end && !first_type.empty()
                    ? fmt::format("a type stands behind: `{}: {}`", text_of(second), first_type)
                    : std::string("parameters are separated by commas"));
        return false;
    }
    if (token_.kind == TokenKind::equal) {
        advance();
        made.default_value = expression();
    }
    list.push_back(made);
    return !is_panicking_;
}

}  // namespace lray::parser
