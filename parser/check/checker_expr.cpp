// Checks expressions.
#include "base/assert.h"
#include "parser/builtins/builtins.h"
#include "parser/check/check_arguments.h"
#include "parser/check/checker_state.h"

namespace lray::parser {

// The parser bounds each chain and each nest, but not chains in blocks in chains, nor the files
// included in them.
bool FileChecker::fits_nesting(Span span) {
    if (program_.nesting <= program_.max_nesting) return true;
    if (!program_.is_too_deep) {
        error(Code::E0115, span,
              fmt::format("nested more than {} levels deep", program_.max_nesting))
            .with_help("raise the limit with `--max-nesting N`, or name parts with `let`");
    }
    program_.is_too_deep = true;
    return false;
}

void FileChecker::expression(Expr& expr) {
    if (expr.kind == ExprKind::block) return block(static_cast<BlockExpr&>(expr), false);
    ++program_.nesting;
    if (fits_nesting(expr.span)) parts_of(expr);
    --program_.nesting;
}

void FileChecker::parts_of(Expr& expr) {
    switch (expr.kind) {
        case ExprKind::error:
        case ExprKind::number:
        case ExprKind::boolean:
        case ExprKind::string:
        case ExprKind::color:
        case ExprKind::packed_list:
            return;
        case ExprKind::name:
            return name(static_cast<NameExpr&>(expr), false);
        case ExprKind::unary:
            return expression(*static_cast<UnaryExpr&>(expr).operand);
        case ExprKind::binary:
            expression(*static_cast<BinaryExpr&>(expr).left);
            expression(*static_cast<BinaryExpr&>(expr).right);
            return;
        case ExprKind::conditional:
            expression(*static_cast<ConditionalExpr&>(expr).condition);
            expression(*static_cast<ConditionalExpr&>(expr).then_value);
            expression(*static_cast<ConditionalExpr&>(expr).else_value);
            return;
        case ExprKind::call:
            return call(static_cast<CallExpr&>(expr));
        case ExprKind::index:
            expression(*static_cast<IndexExpr&>(expr).object);
            expression(*static_cast<IndexExpr&>(expr).index);
            return;
        case ExprKind::member:
            return member(static_cast<MemberExpr&>(expr));
        case ExprKind::list:
            for (Expr* element : static_cast<ListExpr&>(expr).elements) expression(*element);
            return;
        case ExprKind::comprehension:
            return comprehension(static_cast<ComprehensionExpr&>(expr));
        case ExprKind::function: {
            FunctionExpr& value = static_cast<FunctionExpr&>(expr);
            program_.functions.add(value.function, context_);
            for (Context::Loop& loop : context_->loops) loop.has_functions = true;
            function_body(*value.function);
            value.use = use(*value.function);
            return;
        }
        case ExprKind::block:
            break;
    }
    LRAY_ASSERT(false);
}

void FileChecker::comprehension(ComprehensionExpr& expr) {
    expression(*expr.sequence);
    scopes_.open({}, *context_);
    context_->loops.push_back({scopes_.depth(), {}, {}, false, false, false});
    if (expr.index_name != kNoSymbol) {
        expr.index_slot = element_name(expr.index_name, expr.index_span);
    }
    expr.element_slot = element_name(expr.element_name, expr.element_span);
    if (expr.condition != nullptr) expression(*expr.condition);
    expression(*expr.value);
    context_->loops.pop_back();
    close_scope();
}

void FileChecker::call(CallExpr& expr) {
    for (const Argument& argument : expr.arguments) expression(*argument.value);
    if (expr.callee->kind == ExprKind::name) {
        call_of_name(expr, static_cast<NameExpr&>(*expr.callee));
        return;
    }
    expression(*expr.callee);
    if (expr.callee->kind == ExprKind::member) {
        NameExpr* const imported = static_cast<MemberExpr&>(*expr.callee).imported;
        if (imported != nullptr) {
            called(expr, *imported);
            return;
        }
    }
    context_->has_effects = true;  // for all that is known
}

void FileChecker::call_of_name(CallExpr& expr, NameExpr& callee) {
    const std::string_view text = symbols_.text(callee.symbol);
    if (const Variable* variable = scopes_.find(callee.symbol)) {
        const bool is_component = variable->meaning == Meaning::component;
        const bool is_value = variable->let_kind == LetKind::let && !variable->may_be_function;
        name(callee, is_component);
        if (is_value) {
            error(Code::E0307, expr.callee->span, fmt::format("`{}` is not a function", text));
            return;
        }
        called(expr, callee);
        return;
    }
    // A function may have the name of a colour (`gray`) or of a block (none has yet).
    if (const std::optional<std::uint32_t> builtin = find_builtin(text)) {
        callee.meaning = Meaning::builtin;
        callee.index = *builtin;
        context_->has_effects = context_->has_effects || builtins()[*builtin].has_effects;
        constant_random(expr, text);
        called(expr, callee);
    } else if (find_block(callee.symbol) != nullptr) {
        error(Code::E0407, callee.span,
              fmt::format("`{}` is a block; write `{} {{ {} }}`", text, text, as_properties(expr)));
        callee.meaning = Meaning::unknown;
    } else {
        name(callee, false);
        called(expr, callee);
    }
}

// What is called is known by name, or is a value that may be a function.
void FileChecker::called(CallExpr& expr, const NameExpr& callee) {
    const std::string_view head = text(*expr.callee);
    switch (callee.meaning) {
        case Meaning::builtin:
            expr.places = check_arguments(expr, signature_of(builtins()[callee.index]), symbols_,
                                          program_.arena, diagnostics_);
            return;
        case Meaning::function:
            expr.places = check_arguments(
                expr, signature_of(program_.functions.function_of(callee.index), symbols_),
                symbols_, program_.arena, diagnostics_);
            return;
        case Meaning::component:
            error(Code::E0407, expr.callee->span,
                  fmt::format("`{}` is a component; write `{} {{ {} }}`", head, head,
                              as_properties(expr)));
            return;
        case Meaning::global:
        case Meaning::local:
            context_->has_effects = true;  // for all that is known
            return;
        case Meaning::unknown:
        case Meaning::module:
            return;  // reported
        case Meaning::constant:
        case Meaning::colors:
        case Meaning::time:
        case Meaning::frame:
        case Meaning::block:
            break;
    }
    error(Code::E0307, expr.callee->span, fmt::format("`{}` is not a function", head));
}

// `radius: 2, center: p` of a call, when all its arguments have names.
std::string FileChecker::as_properties(const CallExpr& expr) const {
    std::string result;
    for (const Argument& argument : expr.arguments) {
        if (argument.name == kNoSymbol) return "...";
        result += fmt::format("{}{}: {}", result.empty() ? "" : ", ", symbols_.text(argument.name),
                              text(*argument.value));
    }
    return result.empty() ? "..." : result;
}

}  // namespace lray::parser
