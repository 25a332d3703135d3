// Finds out what names mean.
#include <algorithm>
#include <utility>

#include "base/suggest_name.h"
#include "parser/builtins/builtins.h"
#include "parser/builtins/prelude.h"
#include "parser/check/checker_state.h"
#include "parser/syntax/lexer.h"

namespace lray::parser {

// What a mistake hides from the checker may be what uses a name.
void FileChecker::close_scope() {
    const std::span<const Variable> ended =
        diagnostics_.has_errors() ? std::span<Variable>{} : scopes_.innermost();
    for (const Variable& variable : ended) {
        const bool is_private = symbols_.text(variable.name).starts_with('_');
        if (variable.is_used || !variable.warns_if_unused || is_private) continue;
        diagnostics_.warning(Code::W1101, variable.span,
                             fmt::format("`{}` is not used", symbols_.text(variable.name)));
    }
    scopes_.close();
}

// Of the main file: a file that is included, or that places nothing, is a library.
void FileChecker::unused_materials(std::span<Item* const> list) {
    const bool places_something = std::any_of(list.begin(), list.end(), [](const Item* item) {
        const ItemKind kind = item->kind;
        return kind == ItemKind::block || kind == ItemKind::literals ||
               kind == ItemKind::for_loop || kind == ItemKind::while_loop ||
               kind == ItemKind::conditional;
    });
    // A misspelt use would be told twice.
    if (!places_something || diagnostics_.has_errors()) return;
    std::vector<const Variable*> unused;
    for (const Variable& variable : scopes_.innermost()) {
        const bool is_private = symbols_.text(variable.name).starts_with('_');
        const bool is_own = variable.span.source == list.front()->span.source;
        if (variable.is_used || !variable.is_material || is_private || !is_own) continue;
        unused.push_back(&variable);
    }
    constexpr std::size_t kMostForgotten = 3;  // with more it is a library that shows itself
    if (unused.size() > kMostForgotten) return;
    for (const Variable* variable : unused) {
        diagnostics_.warning(
            Code::W1405, variable->span,
            fmt::format("the material `{}` is not used", symbols_.text(variable->name)));
    }
}

// What is to be said about a name before it is defined here.
void FileChecker::new_name(Symbol name, Span span) {
    const std::string_view text = symbols_.text(name);
    // The name of a texture may be taken, as that of a colour: `let wood = image { ... }`.
    const BlockSchema* const built_in = find_block(name);
    if (built_in != nullptr && !is_texture(built_in->kind)) {
        error(Code::E0203, span,
              fmt::format("`{}` is a built-in block; choose another name", text));
    }
    const Variable* const hidden = scopes_.find(name);
    if (hidden == nullptr) return;
    const bool is_same_braces = hidden->scope == scopes_.depth();
    if (is_same_braces) {
        error(Code::E0203, span, fmt::format("`{}` is already defined", text))
            .with_label(hidden->span, "first defined here")
            .with_help(hidden->span.source != span.source
                           ? std::string("to use two files with the same names, `import` them")
                           : fmt::format("to change a value, define it with `var {0}` and write "
                                         "`{0} = ...`",
                                         text));
    } else {
        diagnostics_.warning(Code::W1102, span, fmt::format("`{0}` hides the outer `{0}`", text))
            .with_label(hidden->span, "the outer one");
    }
}

Variable& FileChecker::declare(Symbol name, Span span, Meaning meaning) {
    Variable variable;
    variable.name = name;
    variable.span = span;
    variable.meaning = meaning;
    variable.owner = context_;
    return scopes_.declare(variable);
}

Variable& FileChecker::declare_value(Symbol name, Span span) {
    Variable& variable = declare(name, span, Meaning::local);
    variable.slot = context_->frame_size++;
    return variable;
}

// Writes into an expression what its name stands for. False: reported.
bool FileChecker::resolve(NameExpr& expr, Variable& variable) {
    variable.is_used = true;
    expr.meaning = variable.meaning;
    expr.definition = variable.span;
    if (variable.meaning == Meaning::function || variable.meaning == Meaning::component) {
        expr.index = use(*variable.function);
        return true;
    }
    if (variable.meaning == Meaning::module) return true;
    const bool is_outer_var = variable.let_kind == LetKind::var && variable.owner != context_;
    if (is_outer_var) {
        const std::string_view name = symbols_.text(expr.symbol);
        const Function* const function = context_->function;
        const std::string reader = function == nullptr || function->name == kNoSymbol
                                       ? std::string("a function")
                                       : fmt::format("`{}`", symbols_.text(function->name));
        error(Code::E0205, expr.span,
              fmt::format("{} cannot read the variable `{}`; pass it as a parameter", reader, name))
            .with_label(variable.span, "defined here");
        expr.meaning = Meaning::unknown;
        return false;
    }
    expr.index = variable.meaning == Meaning::global
                     ? variable.slot
                     : slot_in(*context_, variable.owner, variable.slot);
    return true;
}

// A function may name what is defined further down around it: it will have a value by then.
bool FileChecker::resolve_later(NameExpr& expr) {
    const Scopes::Later later = scopes_.find_later(expr.symbol);
    if (later.item == nullptr) return false;
    LetItem& item = *later.item;
    const bool may_wait = later.scope->context != context_;
    if (!may_wait) {
        const std::string_view name = symbols_.text(expr.symbol);
        error(Code::E0202, expr.span,
              diagnostics_.takes_hints() && item.name_span.source == expr.span.source
                  ? fmt::format("`{}` is used before line {} defines it", name,
                                sources_.position(item.name_span).line)
                  : fmt::format("`{}` is used before it is defined", name))
            .with_label(item.name_span, "defined here, later");
        return true;
    }
    if (item.slot == kNoSlot) {
        item.is_global = scopes_.is_outermost(*later.scope);
        item.slot =
            item.is_global ? program_.checked.global_count++ : later.scope->context->frame_size++;
    }
    Variable variable;
    variable.name = item.name;
    variable.span = item.name_span;
    variable.meaning = item.is_global ? Meaning::global : Meaning::local;
    variable.let_kind = item.let_kind;
    variable.slot = item.slot;
    variable.owner = later.scope->context;
    resolve(expr, variable);
    return true;
}

void FileChecker::name(NameExpr& expr, bool is_block_head) {
    const std::string_view text = symbols_.text(expr.symbol);
    if (Variable* variable = scopes_.find(expr.symbol)) {
        if (!resolve(expr, *variable)) return;
        if (expr.meaning == Meaning::module) {
            if (variable->module != nullptr) {
                error(Code::E0301, expr.span,
                      fmt::format("`{0}` is an import; name something in "
                                  "it: `{0}.name`",
                                  text));
            }
            expr.meaning = Meaning::unknown;
        } else if (expr.meaning == Meaning::component && !is_block_head) {
            error(Code::E0116, expr.span, fmt::format("`{}` needs braces: `{} {{ }}`", text, text));
            expr.meaning = Meaning::unknown;
        }
        return;
    }
    if (const BlockSchema* schema = find_block(expr.symbol)) {
        if (!is_block_head) {
            error(Code::E0116, expr.span, fmt::format("`{}` needs braces: `{} {{ }}`", text, text));
            return;
        }
        expr.meaning = Meaning::block;
        expr.index = static_cast<std::uint32_t>(schema->kind);
    } else if (const std::optional<std::uint32_t> constant = find_constant(text)) {
        expr.meaning = Meaning::constant;
        expr.index = *constant;
    } else if (const std::optional<std::uint32_t> builtin = find_builtin(text)) {
        expr.meaning = Meaning::builtin;
        expr.index = *builtin;
        context_->has_effects = context_->has_effects || builtins()[*builtin].has_effects;
    } else if (text == "colors") {
        expr.meaning = Meaning::colors;
    } else if (text == "time") {
        expr.meaning = Meaning::time;
    } else if (text == "frame") {
        expr.meaning = Meaning::frame;
    } else if (!resolve_later(expr)) {
        unknown_name(expr, is_block_head);
    }
}

void FileChecker::unknown_name(const NameExpr& expr, bool is_block_head) {
    const std::string_view text = symbols_.text(expr.symbol);
    if (has_failed_include_ || was_reported(text)) return;
    // `component towerlevels = 3)` was to define `tower`.
    for (const std::string_view broken : program_.broken_names) {
        if (broken.starts_with(text)) return;
    }
    if (is_not_yet_available(text)) {
        error(Code::E0120, expr.span,
              fmt::format("`{}` is not available in this version of lray", text));
        return;
    }
    if (text == "children") {
        error(Code::E0201, expr.span, "`children` stands in a component: what is put into it");
        return;
    }
    std::vector<std::string_view> names;
    if (diagnostics_.takes_hints()) names = scopes_.names(symbols_);
    if (is_block_head) {
        for (const BlockSchema& schema : block_schemas()) names.push_back(schema.name);
    } else {
        for (const Builtin& builtin : builtins()) names.push_back(builtin.name);
        for (const Constant& constant : prelude_constants()) names.push_back(constant.name);
        names.push_back("time");
        names.push_back("frame");
    }
    Diagnostic& diagnostic = error(Code::E0201, expr.span, fmt::format("unknown name `{}`", text));
    const std::string_view habit = is_block_head ? block_habit(text) : std::string_view{};
    if (!habit.empty()) {
        diagnostic.with_hint(fmt::format("here it is called `{}`", habit));
    } else {
        suggest_name(diagnostic, text, names);
    }
}

}  // namespace lray::parser
