// Checks what decides whether and how often something runs.
#include <utility>

#include "base/assert.h"
#include "parser/builtins/builtins.h"
#include "parser/check/checker_state.h"
#include "parser/check/constant_value.h"

namespace lray::parser {

namespace {

bool is_comparison(TokenKind op) {
    using enum TokenKind;
    return is_one_of(op, equal_equal, not_equal, less, less_equal, greater, greater_equal);
}

}  // namespace

void FileChecker::conditional(ConditionalItem& item, const Place& place) {
    // A chain of `else if` is as deep as it is long.
    ++program_.nesting;
    if (fits_nesting(item.condition->span)) {
        expression(*item.condition);
        constant_condition(*item.condition);
        scopes_.open(item.then_body.items, *context_);
        declare_functions(item.then_body.items);
        items(item.then_body.items, place);
        close_scope();
        if (item.has_else) {
            scopes_.open(item.else_body.items, *context_);
            declare_functions(item.else_body.items);
            items(item.else_body.items, place);
            close_scope();
        }
    }
    --program_.nesting;
}

// A comparison of two literals: `if 1 == 2`. A lone `true` or `false` is a switch.
void FileChecker::constant_condition(const Expr& condition) {
    if (condition.kind != ExprKind::binary) return;
    const BinaryExpr& comparison = static_cast<const BinaryExpr&>(condition);
    if (!is_comparison(comparison.op)) return;
    const bool is_constant = constant_value(*comparison.left, program_.arena).has_value() &&
                             constant_value(*comparison.right, program_.arena).has_value();
    if (!is_constant) return;
    diagnostics_.warning(Code::W1104, condition.span, "this condition is always the same");
}

Context::Loop FileChecker::loop_body(const Body& body, const Place& place, LoopInfo& info) {
    declare_functions(body.items);
    items(body.items, place);
    close_scope();
    Context::Loop loop = std::move(context_->loops.back());
    context_->loops.pop_back();
    info.assigned = program_.arena.copy(loop.assigned);
    if (loop.has_functions) info.renewed = program_.arena.copy(loop.declared);
    info.sets_properties = loop.sets_properties;
    return loop;
}

// The name of an element, or its index, of a loop or comprehension: new each time round.
std::uint32_t FileChecker::element_name(Symbol name, Span span) {
    new_name(name, span);
    return declare_value(name, span).slot;
}

void FileChecker::for_loop(ForItem& item, const Place& place) {
    ++program_.nesting;
    if (fits_nesting(item.sequence->span)) {
        expression(*item.sequence);
        scopes_.open(item.body.items, *context_);
        context_->loops.push_back({scopes_.depth(), {}, {}, false, false, false});
        if (item.index_name != kNoSymbol) {
            item.index_slot = element_name(item.index_name, item.index_span);
        }
        item.element_slot = element_name(item.element_name, item.element_span);
        loop_body(item.body, place, item.loop);
    }
    --program_.nesting;
}

void FileChecker::while_loop(WhileItem& item, const Place& place) {
    ++program_.nesting;
    if (fits_nesting(item.condition->span)) {
        context_->loops.push_back({scopes_.depth() + 1, {}, {}, false, false, false});
        expression(*item.condition);
        constant_condition(*item.condition);
        scopes_.open(item.body.items, *context_);
        const Context::Loop loop = loop_body(item.body, place, item.loop);
        const bool is_true = item.condition->kind == ExprKind::boolean &&
                             static_cast<const BooleanExpr&>(*item.condition).value;
        if (is_true && !loop.has_exit) {
            diagnostics_.warning(Code::W1104, item.condition->span, "this loop never ends")
                .with_help("leave it with `break`, or write what it waits for");
        }
    }
    --program_.nesting;
}

// `rand(seed)` in a loop: the same number every time round.
void FileChecker::constant_random(const CallExpr& expr, std::string_view name) {
    if (context_->loops.empty() || expr.arguments.empty()) return;
    const bool is_keyed = name.starts_with("rand") || name == "gauss";
    if (!is_keyed) return;
    for (const Argument& argument : expr.arguments) {
        if (!constant_value(*argument.value, program_.arena)) return;
    }
    diagnostics_
        .warning(Code::W1105, expr.span,
                 fmt::format("`{}` gives the same number every time round", name))
        .with_help("add what changes, like the index: `rand(seed, i)`");
}

}  // namespace lray::parser
