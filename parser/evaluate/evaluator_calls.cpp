// Evaluates calls: of functions in the scene, of function values, of built-in functions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "base/assert.h"
#include "parser/check/check_arguments.h"
#include "parser/check/constant_value.h"
#include "parser/evaluate/evaluator_state.h"
#include "parser/values/type_name.h"
#include "parser/values/value_text.h"

namespace lray::parser {

namespace {

/// Room for what most calls of variadic functions take. Calls come by the million, and few of them
/// need it: only what is used is made.
struct FewArguments {
    static constexpr std::size_t kCount = 8;

    FewArguments() {}

    union {
        Value values[kCount];
    };
    union {
        Span spans[kCount];
    };
};

}  // namespace

Value Evaluator::call(const CallExpr& expr) {
    const NameExpr* callee = nullptr;
    if (expr.callee->kind == ExprKind::name) {
        callee = static_cast<const NameExpr*>(expr.callee);
    } else if (expr.callee->kind == ExprKind::member) {
        callee = static_cast<const MemberExpr&>(*expr.callee).imported;
    }
    if (callee != nullptr && callee->meaning == Meaning::builtin) {
        if (callee->index == assert_builtin_) return assertion(expr);
        return call_builtin_function(expr, builtins()[callee->index]);
    }
    if (callee != nullptr && callee->meaning == Meaning::function) {
        return call_use(expr, checked_.uses[callee->index]);
    }
    return call_value(expr, eval(*expr.callee));
}

Value Evaluator::call_builtin_function(const CallExpr& expr, const Builtin& builtin) {
    if (builtin.of_number != nullptr && expr.arguments.size() == 1) {
        const Value argument = eval(*expr.arguments[0].value);
        if (argument.is(ValueKind::number)) {
            const double result = builtin.of_number(argument.number);
            if (std::isfinite(result)) return Value::of(result);
        }
        Call made{{argument}, {}, {}, expr.span, arena(), budget_, diagnostics_, *this, {}, {}};
        made.spans[0] = expr.arguments[0].value->span;
        return call_builtin(builtin, made);
    }
    Call made{{}, {}, {}, expr.span, arena(), budget_, diagnostics_, *this, {}, {}};
    FewArguments few;
    std::vector<Value> values;
    std::vector<Span> spans;
    std::size_t rest_count = 0;
    const bool has_few = expr.arguments.size() <= FewArguments::kCount;
    if (!has_few) {
        values.resize(expr.arguments.size());
        spans.resize(expr.arguments.size());
    }
    Value* const rest = has_few ? few.values : values.data();
    Span* const rest_spans = has_few ? few.spans : spans.data();
    for (std::size_t i = 0; i < expr.arguments.size(); ++i) {
        const Expr& argument = *expr.arguments[i].value;
        const Value value = eval(argument);
        if (value.is(ValueKind::poison)) return value;
        if (expr.places[i] == kRestPlace) {
            new (&rest[rest_count]) Value(value);
            new (&rest_spans[rest_count++]) Span(argument.span);
        } else {
            made.arguments[expr.places[i]] = value;
            made.spans[expr.places[i]] = argument.span;
        }
    }
    made.rest = {rest, rest_count};
    made.rest_spans = {rest_spans, rest_count};
    return call_builtin(builtin, made);
}

// `assert(a < b, "...")` shows both sides.
Value Evaluator::assertion(const CallExpr& expr) {
    const Expr* condition_expr = nullptr;
    const Expr* message_expr = nullptr;
    for (std::size_t i = 0; i < expr.arguments.size(); ++i) {
        (expr.places[i] == 0 ? condition_expr : message_expr) = expr.arguments[i].value;
    }
    std::string sides;
    std::optional<bool> holds;
    using enum TokenKind;
    const bool is_comparison =
        condition_expr->kind == ExprKind::binary &&
        is_one_of(static_cast<const BinaryExpr&>(*condition_expr).op, equal_equal, not_equal, less,
                  less_equal, greater, greater_equal);
    if (is_comparison) {
        const BinaryExpr& comparison = static_cast<const BinaryExpr&>(*condition_expr);
        const Value left = eval(*comparison.left);
        const Value right = eval(*comparison.right);
        const Value result =
            apply(comparison.op, left, right, comparison.op_span, arena(), budget_, diagnostics_);
        if (result.is(ValueKind::boolean)) holds = result.boolean;
        if (holds && !*holds) {
            const auto add = [&](const Expr& side, const Value& value) {
                if (constant_value(side, arena())) return;  // shows its value itself
                sides += fmt::format("{}`{}` is {}", sides.empty() ? "" : ", ", text(side),
                                     value_text(value, symbols_, kShownBytes));
            };
            add(*comparison.left, left);
            add(*comparison.right, right);
        }
    } else {
        holds = condition(*condition_expr);
    }
    if (!holds) return Value::poison();
    if (*holds) return Value::of(true);
    std::string message = fmt::format("`{}` does not hold", text(*condition_expr));
    if (message_expr != nullptr) {
        const Value told = eval(*message_expr);
        if (told.is(ValueKind::poison)) return told;
        message = value_text(told, symbols_, kShownBytes);
    }
    Diagnostic& diagnostic = error(Code::E0507, condition_expr->span, std::move(message));
    if (!sides.empty()) diagnostic.with_note(std::move(sides));
    return Value::poison();
}

// False: the calls are nested too deep.
bool Evaluator::has_room(const Function& function, Span span) {
    const char here = 0;
    const std::uint32_t limit = environment_.settings.limits.call_depth;
    const bool is_stack_left = &here > stack_end_;
    if (budget_.is_spent) return false;
    if (calls_.size() < limit && is_stack_left) return take_share(function.frame_size, span);
    std::string chain;
    constexpr std::size_t kShown = 3;
    for (std::size_t i = 0; i < std::min(kShown, calls_.size()); ++i) {
        const Function& caller = *calls_[i].function;
        chain +=
            fmt::format("`{}` -> ", caller.name == kNoSymbol ? "fn" : symbols_.text(caller.name));
    }
    Diagnostic& diagnostic =
        error(Code::E0511, span,
              is_stack_left ? fmt::format("more than {} nested calls", limit)
                            : fmt::format("{} nested calls need too much memory", calls_.size()));
    diagnostic.with_note(fmt::format(
        "{}... -> `{}`", chain, function.name == kNoSymbol ? "fn" : symbols_.text(function.name)));
    diagnostic.with_help(
        "does it ever stop calling itself? if so, raise the limit with "
        "`--max-call-depth N`");
    budget_.spend();  // or each of the calls that wait would go on, and come here again
    return false;
}

// Makes room for a frame behind all others, and returns where it begins.
std::size_t Evaluator::push_frame(const Function& function) {
    const std::size_t base = top_;
    top_ += function.frame_size;
    if (slots_.size() < top_) {
        slots_.resize(std::max(top_, slots_.size() * 2));
        frame_ = slots_.data() + base_;
    }
    std::fill_n(slots_.data() + base, function.frame_size, Value{});
    return base;
}

void Evaluator::enter(const Function& function, std::size_t base, Span span) {
    calls_.push_back({&function, span, base_});
    base_ = base;
    frame_ = slots_.data() + base_;
}

void Evaluator::leave() {
    top_ = base_;
    base_ = calls_.back().base;
    frame_ = slots_.data() + base_;
    calls_.pop_back();
}

// Evaluates the defaults of what was not given, inside the function, and checks all types.
bool Evaluator::complete_parameters(const Function& function, Span span) {
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const ParameterDecl& parameter = function.parameters[i];
        if (frame_[i].is(ValueKind::none)) {
            if (parameter.default_value == nullptr) {
                error(Code::E0305, span,
                      fmt::format("`{}` needs its argument `{}`",
                                  function.name == kNoSymbol ? "this function"
                                                             : symbols_.text(function.name),
                                  symbols_.text(parameter.name)));
                return false;
            }
            const Value value = eval(*parameter.default_value);
            frame_[i] = value;
        }
        if (frame_[i].is(ValueKind::poison)) return false;
        if (parameter.type != TypeName::any && !has_type(parameter.type, frame_[i])) {
            error(Code::E0301, span,
                  fmt::format("`{}` needs {}, this is {}", symbols_.text(parameter.name),
                              in_words(parameter.type), describe(frame_[i])))
                .with_label(parameter.name_span, "defined here");
            return false;
        }
    }
    return true;
}

Value Evaluator::call_use(const CallExpr& expr, const FunctionUse& use) {
    const Function& function = *use.function;
    if (!has_room(function, expr.span)) return Value::poison();
    const std::size_t base = push_frame(function);
    for (std::size_t i = 0; i < expr.arguments.size(); ++i) {
        const Value value = eval(*expr.arguments[i].value);
        if (value.is(ValueKind::poison)) {
            top_ = base;
            return value;
        }
        slots_[base + expr.places[i]] = value;
    }
    for (std::size_t i = 0; i < use.capture_slots.size(); ++i) {
        slots_[base + function.capture_slots[i]] = frame_[use.capture_slots[i]];
    }
    enter(function, base, expr.span);
    const Region region = memory_.begin();
    const Value result = result_of(function, expr.span);
    leave();
    return memory_.end_with(region, result);
}

// What the function that was entered gives back.
Value Evaluator::result_of(const Function& function, Span span) {
    if (!complete_parameters(function, span)) return Value::poison();
    if (function.value != nullptr) return eval(*function.value);
    OpenBlock open(block_schema(BlockKind::group), span);
    const std::uint64_t failures = failures_;
    for (Item* at : function.body.items) {
        const Flow flow = item(*at, open);
        if (failures_ != failures) return Value::poison();
        if (flow == Flow::return_value) return result_;
    }
    return failed(
        Code::E0506, span,
        fmt::format("`{}` ends without `return`",
                    function.name == kNoSymbol ? "this function" : symbols_.text(function.name)));
}

// A callee that is known only now.
Value Evaluator::call_value(const CallExpr& expr, const Value& callee) {
    if (callee.is(ValueKind::poison)) return callee;
    if (!callee.is(ValueKind::function)) {
        return failed(
            Code::E0307, expr.callee->span,
            fmt::format("`{}` is not a function, it is {}", text(*expr.callee), describe(callee)));
    }
    const FunctionValue& function = *callee.function;
    CallExpr placed = expr;
    if (function.function == nullptr) {
        const Builtin& builtin = builtins()[function.builtin];
        placed.places =
            check_arguments(expr, signature_of(builtin), symbols_, arena(), diagnostics_);
        if (placed.places.size() != expr.arguments.size()) return Value::poison();
        return call_builtin_function(placed, builtin);
    }
    const std::size_t errors = diagnostics_.error_count();
    placed.places = check_arguments(expr, signature_of(*function.function, symbols_), symbols_,
                                    arena(), diagnostics_);
    if (diagnostics_.error_count() != errors) return Value::poison();
    std::vector<Value> arguments(function.function->parameters.size());
    for (std::size_t i = 0; i < expr.arguments.size(); ++i) {
        const Value value = eval(*expr.arguments[i].value);
        if (value.is(ValueKind::poison)) return value;
        arguments[placed.places[i]] = value;
    }
    return call_function(callee, arguments, expr.span);
}

Value Evaluator::call_function(const Value& callee, std::span<const Value> arguments, Span span) {
    LRAY_ASSERT(callee.is(ValueKind::function));
    const FunctionValue& value = *callee.function;
    if (!take_steps(budget_, 1, span, diagnostics_)) return Value::poison();
    if (value.function == nullptr) {
        const Builtin& builtin = builtins()[value.builtin];
        const std::size_t count = builtin.parameter_count();
        const bool fits = arguments.size() >= builtin.required_count() &&
                          (arguments.size() <= count || builtin.is_variadic);
        if (!fits) {
            return failed(Code::E0306, span,
                          fmt::format("`{}` is called with {} argument{} here", builtin.name,
                                      arguments.size(), arguments.size() == 1 ? "" : "s"));
        }
        Call made{{}, {}, {}, span, arena(), budget_, diagnostics_, *this, {}, {}};
        const std::size_t given = std::min(count, arguments.size());
        std::copy_n(arguments.begin(), given, made.arguments.begin());
        made.spans.fill(span);
        made.rest = arguments.subspan(given);
        const std::vector<Span> rest_spans(made.rest.size(), span);
        made.rest_spans = rest_spans;
        return call_builtin(builtin, made);
    }
    const Function& function = *value.function;
    if (arguments.size() > function.parameters.size()) {
        return failed(Code::E0306, span,
                      fmt::format("this function takes {} argument{}, and is called with {} here",
                                  function.parameters.size(),
                                  function.parameters.size() == 1 ? "" : "s", arguments.size()));
    }
    if (!has_room(function, span)) return Value::poison();
    const std::size_t base = push_frame(function);
    std::copy(arguments.begin(), arguments.end(),
              slots_.begin() + static_cast<std::ptrdiff_t>(base));
    for (std::size_t i = 0; i < function.capture_slots.size(); ++i) {
        slots_[base + function.capture_slots[i]] = value.captures[i];
    }
    enter(function, base, span);
    const Region region = memory_.begin();
    const Value result = result_of(function, span);
    leave();
    return memory_.end_with(region, result);
}

}  // namespace lray::parser
