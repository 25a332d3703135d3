// Checks what stands in a file or between braces: names, properties, assignments, calls.
#include <utility>

#include "base/assert.h"
#include "base/did_you_mean.h"
#include "parser/blocks/property_type.h"
#include "parser/builtins/builtins.h"
#include "parser/builtins/prelude.h"
#include "parser/check/checker_state.h"
#include "parser/check/constant_value.h"
#include "parser/syntax/lexer.h"

namespace lray::parser {

namespace {

/// False for what is plainly another value.
bool may_be_function(const Expr& expr) {
    switch (expr.kind) {
        case ExprKind::number:
        case ExprKind::boolean:
        case ExprKind::string:
        case ExprKind::color:
        case ExprKind::list:
        case ExprKind::packed_list:
        case ExprKind::block:
        case ExprKind::comprehension:
            return false;
        case ExprKind::error:
        case ExprKind::name:
        case ExprKind::unary:
        case ExprKind::binary:
        case ExprKind::conditional:
        case ExprKind::call:
        case ExprKind::index:
        case ExprKind::member:
        case ExprKind::function:
            return true;
    }
    LRAY_ASSERT(false);
}

}  // namespace

void FileChecker::items(std::span<Item* const> list, const Place& place) {
    for (Item* at : list) item(*at, place);
    unreachable(list);
}

void FileChecker::item(Item& item, const Place& place) {
    switch (item.kind) {
        case ItemKind::let:
            return let(static_cast<LetItem&>(item));
        case ItemKind::property:
            return property(static_cast<PropertyItem&>(item), place);
        case ItemKind::block:
            return placed_block(static_cast<BlockItem&>(item), place);
        case ItemKind::call:
            return call_item(static_cast<CallItem&>(item));
        case ItemKind::assignment:
            return assignment(static_cast<AssignmentItem&>(item), place);
        case ItemKind::include:
            return include(static_cast<IncludeItem&>(item), place);
        case ItemKind::import:
            return import(static_cast<ImportItem&>(item));
        case ItemKind::file_view:
            static_cast<FileViewItem&>(item).is_top_level = place.kind == Place::Kind::file;
            return;
        case ItemKind::function:
            return function_body(*static_cast<FunctionItem&>(item).function);
        case ItemKind::conditional:
            return conditional(static_cast<ConditionalItem&>(item), place);
        case ItemKind::for_loop:
            return for_loop(static_cast<ForItem&>(item), place);
        case ItemKind::while_loop:
            return while_loop(static_cast<WhileItem&>(item), place);
        case ItemKind::return_value:
            for (Context::Loop& loop : context_->loops) loop.has_exit = true;
            return expression(*static_cast<ReturnItem&>(item).value);
        case ItemKind::break_loop:
            if (!context_->loops.empty()) context_->loops.back().has_exit = true;
            return;
        case ItemKind::continue_loop:
            return;
        case ItemKind::literals:
            return literals(static_cast<LiteralsItem&>(item));
    }
    LRAY_ASSERT(false);
}

void FileChecker::unreachable(std::span<Item* const> list) {
    if (diagnostics_.has_errors()) return;
    for (std::size_t i = 0; i + 1 < list.size(); ++i) {
        const ItemKind kind = list[i]->kind;
        const bool ends = kind == ItemKind::break_loop || kind == ItemKind::continue_loop ||
                          kind == ItemKind::return_value;
        if (!ends || list[i + 1]->kind == ItemKind::function) continue;
        diagnostics_.warning(Code::W1103, list[i + 1]->span, "what stands here is never reached")
            .with_label(list[i]->span, "the block ends here");
        return;
    }
}

void FileChecker::let(LetItem& item) {
    if (item.let_kind == LetKind::param) param(item);
    expression(*item.value);
    new_name(item.name, item.name_span);
    Variable variable;
    variable.name = item.name;
    variable.span = item.name_span;
    variable.let_kind = item.let_kind;
    variable.owner = context_;
    variable.warns_if_unused = !scopes_.is_outermost();
    variable.may_be_function = may_be_function(*item.value);
    if (item.let_kind != LetKind::var) {
        const BlockSchema* const schema = schema_of(*item.value);
        know_schema(item.name_span, schema);
        variable.is_material = schema != nullptr && schema->kind == BlockKind::material;
    }
    if (item.slot == kNoSlot) {
        item.is_global = scopes_.is_outermost();
        item.slot = item.is_global ? program_.checked.global_count++ : context_->frame_size++;
    } else {
        variable.is_used = true;  // by a function that stands above
    }
    variable.meaning = item.is_global ? Meaning::global : Meaning::local;
    variable.slot = item.slot;
    scopes_.declare(variable);
    if (!item.is_global) {
        for (Context::Loop& loop : context_->loops) loop.declared.push_back(item.slot);
    }
}

void FileChecker::param(LetItem& item) {
    if (!scopes_.is_outermost()) {
        error(Code::E0118, item.span, "`param` stands at the top level of a file")
            .with_help("a value that does not change from outside is written `let`");
    }
    if (item.choices != nullptr) expression(*item.choices);
    program_.checked.params.push_back({&item, prefix_ + std::string(symbols_.text(item.name))});
}

void FileChecker::include(IncludeItem& item, const Place& place) {
    const bool is_allowed = place.kind == Place::Kind::file ||
                            (place.kind == Place::Kind::block && place.schema->has_children);
    if (!is_allowed || !context_->loops.empty() || context_->function != nullptr) {
        const std::string_view where = place.kind == Place::Kind::block && !is_allowed
                                           ? place.schema->name
                                           : std::string_view{};
        error(Code::E0118, item.span,
              where.empty()
                  ? std::string("`include` stands at the top level or in a group")
                  : fmt::format("`include` stands at the top level or in a group, not in a {}",
                                where));
        return;
    }
    if (!item.is_loaded) {
        has_failed_include_ = true;
        return;
    }
    items(item.items, place);
}

void FileChecker::property(PropertyItem& item, const Place& place) {
    expression(*item.value);
    const std::string_view name = symbols_.text(item.name);
    if (place.kind != Place::Kind::block) {
        Diagnostic& diagnostic = error(Code::E0410, item.name_span,
                                       fmt::format("property `{}` outside any block", name));
        if (place.kind == Place::Kind::file) {
            diagnostic.with_help(fmt::format("a named value is written `let {} = ...`", name));
        } else {
            diagnostic.with_help("a function gives a value: `return ...`");
        }
        return;
    }
    for (Context::Loop& loop : context_->loops) {
        if (loop.first_scope > place.scope) loop.sets_properties = true;
    }
    const PropertyPlace found = find_place(*place.schema, name);
    if (found.schema != nullptr) value_of(*found.schema, *item.value);
}

// Fits a value to its property as far as it is plain to see.
void FileChecker::value_of(const PropertySchema& property, const Expr& expr) {
    if (expr.kind == ExprKind::conditional) {
        const ConditionalExpr& choice = static_cast<const ConditionalExpr&>(expr);
        value_of(property, *choice.then_value);
        value_of(property, *choice.else_value);
        return;
    }
    if (const std::optional<Value> value = constant_value(expr, program_.arena)) {
        fit(property, *value, expr.span, diagnostics_, name_of(expr, sources_));
        return;
    }
    if (expr.kind == ExprKind::list) {  // its size is plain, whatever is in it
        const std::size_t count = static_cast<const ListExpr&>(expr).elements.size();
        const bool is_point =
            property.type == PropertyType::point || property.type == PropertyType::direction;
        if (is_point && count != 3) {
            error(Code::E0303, expr.span,
                  fmt::format("`{}` needs 3 numbers, this has {}", property.name, count));
        }
    }
}

void FileChecker::assignment(AssignmentItem& item, const Place& place) {
    expression(*item.value);
    const std::string_view target = text(*item.target);
    if (item.target->kind != ExprKind::name) {
        error(Code::E0204, item.target->span, fmt::format("`{}` cannot be assigned to", target))
            .with_help("values do not change; give the variable a new one: `p = [1, 2, 3]`");
        return;
    }
    NameExpr& name_expr = static_cast<NameExpr&>(*item.target);
    const bool is_property =
        place.kind == Place::Kind::block && find_place(*place.schema, target).schema != nullptr;
    Variable* const variable = scopes_.find(name_expr.symbol);
    const bool is_var = variable != nullptr && variable->let_kind == LetKind::var;
    if (is_property && !is_var) {
        error(Code::E0204, item.target->span,
              fmt::format("`{}` is a property here; write `{}: {}`", target, target,
                          text(*item.value)));
    } else if (is_var && variable->owner != context_) {
        error(Code::E0205, item.target->span,
              fmt::format("a function cannot change the variable `{}` around it", target))
            .with_label(variable->span, "defined here")
            .with_help("return the new value, and assign it where the function is called");
    } else if (is_var) {
        name_expr.meaning = variable->meaning;
        name_expr.index = variable->slot;
        name_expr.definition = variable->span;
        for (Context::Loop& loop : context_->loops) {
            if (loop.first_scope <= variable->scope) continue;
            loop.assigned.push_back({variable->slot, variable->meaning == Meaning::global});
        }
    } else if (variable != nullptr) {
        Diagnostic& diagnostic =
            error(Code::E0204, item.target->span, fmt::format("`{}` is constant", target));
        diagnostic.with_label(variable->span, "defined here");
        const bool is_let =
            variable->let_kind == LetKind::let &&
            (variable->meaning == Meaning::global || variable->meaning == Meaning::local);
        if (is_let)
            diagnostic.with_help(fmt::format("to change it, define it with `var {}`", target));
    } else if (find_block(name_expr.symbol) != nullptr || find_constant(target) ||
               find_builtin(target)) {
        error(Code::E0204, item.target->span,
              fmt::format("`{}` is built in; it cannot be assigned to", target))
            .with_help(fmt::format("a name of your own is written `let {} = ...`", target));
    } else if (!has_failed_include_) {
        error(Code::E0201, item.target->span, fmt::format("unknown name `{}`", target))
            .with_help(fmt::format("a new name is written `let {0} = ...`, or `var {0} = ...` if "
                                   "it will change",
                                   target));
    }
}

void FileChecker::call_item(const CallItem& item) {
    expression(*item.value);
    if (item.value->kind != ExprKind::call) return;
    const CallExpr& call = static_cast<const CallExpr&>(*item.value);
    const NameExpr* callee = nullptr;
    if (call.callee->kind == ExprKind::name) {
        callee = static_cast<const NameExpr*>(call.callee);
    } else if (call.callee->kind == ExprKind::member) {
        callee = static_cast<const MemberExpr&>(*call.callee).imported;
    }
    if (callee != nullptr) {
        const bool is_statement =
            callee->meaning == Meaning::builtin && builtins()[callee->index].is_statement;
        const bool is_reported =
            callee->meaning == Meaning::unknown || callee->meaning == Meaning::component;
        if (is_statement || is_reported) return;
        if (callee->meaning == Meaning::function) {  // right if it prints
            program_.unused_calls.emplace_back(&call, callee->index);
            return;
        }
    }
    error(Code::E0408, item.span, "the value of this call is not used")
        .with_help("give it a name, `let a = ...`, or set a property with it");
}

}  // namespace lray::parser
