#include "parser/check/checker.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <unordered_map>

#include "base/assert.h"
#include "base/did_you_mean.h"
#include "parser/blocks/property_type.h"
#include "parser/blocks/schema.h"
#include "parser/builtins/builtins.h"
#include "parser/builtins/prelude.h"
#include "parser/check/check_arguments.h"
#include "parser/check/check_block.h"
#include "parser/check/constant_value.h"
#include "parser/syntax/lexer.h"

namespace lray::parser {

namespace {

/// What is known of a name before the program runs.
struct Variable {
    Symbol name = kNoSymbol;
    Span span{};
    std::uint32_t slot = 0;
    std::uint32_t scope = 0;
    const BlockSchema* schema = nullptr;  // of its block, when that is plain to see
    std::int64_t outer = -1;              // the variable of this name that it hides
};

/// The names between one pair of braces.
struct Scope {
    std::size_t first_variable = 0;
    std::span<Item* const> items{};
    std::optional<std::unordered_map<Symbol, Span>> later{};  // all its names, made when asked for
};

class Checker {
 public:
    Checker(const Symbols& symbols, const Sources& sources, std::uint32_t max_nesting, Arena& arena,
            Diagnostics& diagnostics)
        : symbols_(symbols),
          sources_(sources),
          max_nesting_(max_nesting),
          is_too_deep_(diagnostics.has_limit_errors()),
          arena_(arena),
          diagnostics_(diagnostics) {}

    Checked check(std::span<Item* const> list) {
        open_scope(list);
        items(list, nullptr);
        return std::move(checked_);
    }

 private:
    void items(std::span<Item* const> list, const BlockSchema* block);
    void let(LetItem& item);
    void include(IncludeItem& item, const BlockSchema* block);
    void property(PropertyItem& item, const BlockSchema* block);
    void assignment(const AssignmentItem& item, const BlockSchema* block);
    void placed_block(const BlockItem& item, const BlockSchema* block);
    void call_item(const CallItem& item);
    void top_level_block(const BlockExpr& block, const BlockSchema& schema);

    bool fits_nesting(Span span);
    void expression(Expr& expr);
    void parts_of(Expr& expr);
    void name(NameExpr& expr, bool is_block_head);
    void unknown_name(const NameExpr& expr, bool is_block_head);
    void call(const CallExpr& expr);
    std::string as_properties(const CallExpr& expr) const;
    void block(BlockExpr& expr, bool is_placed);
    void head_and_body(BlockExpr& expr, bool is_placed);
    void value_of(const PropertySchema& property, const Expr& expr);
    const BlockSchema* schema_of(const Expr& expr) const;

    void open_scope(std::span<Item* const> list) {
        scopes_.push_back({variables_.size(), list, std::nullopt});
    }
    void close_scope();
    const Variable* find(Symbol symbol) const;
    const Span* defined_later(Symbol symbol);
    static void collect(std::span<Item* const> list, std::unordered_map<Symbol, Span>& names);

    const Symbols& symbols_;
    const Sources& sources_;
    std::uint32_t max_nesting_ = 0;
    std::uint32_t nesting_ = 0;
    bool is_too_deep_ = false;  // reported, here or by the parser
    Arena& arena_;
    Diagnostics& diagnostics_;
    Checked checked_;
    std::vector<Variable> variables_;  // those in scope, outermost first
    std::unordered_map<Symbol, std::size_t> innermost_;
    std::vector<Scope> scopes_;
    Span first_render_{};
    Span first_info_{};
    bool has_failed_include_ = false;  // what is unknown may stand in the file that is missing
};

void Checker::close_scope() {
    while (variables_.size() > scopes_.back().first_variable) {
        const Variable& variable = variables_.back();
        if (variable.outer < 0) {
            innermost_.erase(variable.name);
        } else {
            innermost_[variable.name] = static_cast<std::size_t>(variable.outer);
        }
        variables_.pop_back();
    }
    scopes_.pop_back();
}

const Variable* Checker::find(Symbol symbol) const {
    const auto found = innermost_.find(symbol);
    return found == innermost_.end() ? nullptr : &variables_[found->second];
}

void Checker::collect(std::span<Item* const> list, std::unordered_map<Symbol, Span>& names) {
    for (const Item* item : list) {
        if (item->kind == ItemKind::let) {
            const LetItem& let_item = static_cast<const LetItem&>(*item);
            names.try_emplace(let_item.name, let_item.name_span);
        } else if (item->kind == ItemKind::include) {
            collect(static_cast<const IncludeItem&>(*item).items, names);
        }
    }
}

const Span* Checker::defined_later(Symbol symbol) {
    for (std::size_t i = scopes_.size(); i-- > 0;) {
        Scope& scope = scopes_[i];
        if (!scope.later) collect(scope.items, scope.later.emplace());
        const auto found = scope.later->find(symbol);
        if (found != scope.later->end()) return &found->second;
    }
    return nullptr;
}

void Checker::items(std::span<Item* const> list, const BlockSchema* block_schema) {
    for (Item* item : list) {
        switch (item->kind) {
            case ItemKind::let:
                let(static_cast<LetItem&>(*item));
                break;
            case ItemKind::property:
                property(static_cast<PropertyItem&>(*item), block_schema);
                break;
            case ItemKind::block:
                placed_block(static_cast<BlockItem&>(*item), block_schema);
                break;
            case ItemKind::call:
                call_item(static_cast<CallItem&>(*item));
                break;
            case ItemKind::assignment:
                assignment(static_cast<AssignmentItem&>(*item), block_schema);
                break;
            case ItemKind::include:
                include(static_cast<IncludeItem&>(*item), block_schema);
                break;
            case ItemKind::literals:
            case ItemKind::import:
            case ItemKind::function:
            case ItemKind::conditional:
            case ItemKind::for_loop:
            case ItemKind::while_loop:
            case ItemKind::break_loop:
            case ItemKind::continue_loop:
            case ItemKind::return_value:
                break;  // decoded and checked by the parser
        }
    }
}

void Checker::let(LetItem& item) {
    expression(*item.value);
    const std::string_view text = symbols_.text(item.name);
    if (const BlockSchema* built_in = find_block(item.name)) {
        diagnostics_.error(Code::E0203, item.name_span,
                           fmt::format("`{}` is a built-in block; choose another name", text));
        static_cast<void>(built_in);
    }
    const auto current_scope = static_cast<std::uint32_t>(scopes_.size());
    const Variable* const hidden = find(item.name);
    if (hidden != nullptr && hidden->scope == current_scope) {
        diagnostics_
            .error(Code::E0203, item.name_span, fmt::format("`{}` is already defined", text))
            .with_label(hidden->span, "first defined here")
            .with_help("a name has one value; choose another name");
    } else if (hidden != nullptr) {
        diagnostics_
            .warning(Code::W1102, item.name_span, fmt::format("`{0}` hides the outer `{0}`", text))
            .with_label(hidden->span, "the outer one");
    }
    item.slot = static_cast<std::uint32_t>(checked_.variables.size());
    checked_.variables.push_back(item.name_span);
    Variable variable;
    variable.name = item.name;
    variable.span = item.name_span;
    variable.slot = item.slot;
    variable.scope = current_scope;
    variable.schema = schema_of(*item.value);
    if (hidden != nullptr) variable.outer = hidden - variables_.data();
    innermost_[item.name] = variables_.size();
    variables_.push_back(variable);
}

void Checker::include(IncludeItem& item, const BlockSchema* block_schema) {
    if (block_schema != nullptr && !block_schema->has_children) {
        diagnostics_.error(
            Code::E0118, item.span,
            fmt::format("`include` stands at the top level or in a group, not in a {}",
                        block_schema->name));
        return;
    }
    if (!item.is_loaded) {
        has_failed_include_ = true;
        return;
    }
    items(item.items, block_schema);
}

void Checker::property(PropertyItem& item, const BlockSchema* block_schema) {
    expression(*item.value);
    const std::string_view text = symbols_.text(item.name);
    if (block_schema == nullptr) {
        diagnostics_
            .error(Code::E0410, item.name_span,
                   fmt::format("property `{}` outside any block", text))
            .with_help(fmt::format("a named value is written `let {} = ...`", text));
        return;
    }
    const PropertyPlace place = find_place(*block_schema, text);
    if (place.schema != nullptr) value_of(*place.schema, *item.value);
}

// Fits a value to its property as far as it is plain to see.
void Checker::value_of(const PropertySchema& property, const Expr& expr) {
    if (expr.kind == ExprKind::conditional) {
        const ConditionalExpr& choice = static_cast<const ConditionalExpr&>(expr);
        value_of(property, *choice.then_value);
        value_of(property, *choice.else_value);
        return;
    }
    if (const std::optional<Value> value = constant_value(expr, arena_)) {
        fit(property, *value, expr.span, diagnostics_, name_of(expr, sources_));
        return;
    }
    if (expr.kind == ExprKind::list) {  // its size is plain, whatever is in it
        const std::size_t count = static_cast<const ListExpr&>(expr).elements.size();
        const bool is_point =
            property.type == PropertyType::point || property.type == PropertyType::direction;
        if (is_point && count != 3) {
            diagnostics_.error(
                Code::E0303, expr.span,
                fmt::format("`{}` needs 3 numbers, this has {}", property.name, count));
        }
    }
}

void Checker::assignment(const AssignmentItem& item, const BlockSchema* block_schema) {
    expression(*item.value);
    const std::string_view target = sources_.text(item.target->span);
    if (item.target->kind != ExprKind::name) {
        diagnostics_.error(Code::E0204, item.target->span,
                           fmt::format("`{}` cannot be assigned to", target));
        return;
    }
    const NameExpr& name_expr = static_cast<const NameExpr&>(*item.target);
    const bool is_property =
        block_schema != nullptr && find_place(*block_schema, target).schema != nullptr;
    if (is_property) {
        diagnostics_.error(Code::E0204, item.target->span,
                           fmt::format("`{}` is a property here; write `{}: {}`", target, target,
                                       sources_.text(item.value->span)));
    } else if (const Variable* variable = find(name_expr.symbol)) {
        diagnostics_.error(Code::E0204, item.target->span, fmt::format("`{}` is constant", target))
            .with_label(variable->span, "defined here");
    } else if (find_block(name_expr.symbol) != nullptr || find_constant(target) ||
               find_builtin(target)) {
        diagnostics_
            .error(Code::E0204, item.target->span,
                   fmt::format("`{}` is built in; it cannot be assigned to", target))
            .with_help(fmt::format("a name of your own is written `let {} = ...`", target));
    } else {
        diagnostics_.error(Code::E0201, item.target->span, fmt::format("unknown name `{}`", target))
            .with_help(fmt::format("a new name is written `let {} = ...`", target));
    }
}

void Checker::call_item(const CallItem& item) {
    expression(*item.value);
    diagnostics_.error(Code::E0408, item.span, "the value of this call is not used")
        .with_help("give it a name, `let a = ...`, or set a property with it");
}

void Checker::placed_block(const BlockItem& item, const BlockSchema* parent) {
    BlockExpr& placed = *item.block;
    block(placed, true);
    const BlockSchema* const schema = schema_of(*placed.head);
    const bool is_built_in = placed.head->kind == ExprKind::name &&
                             static_cast<const NameExpr&>(*placed.head).meaning == Meaning::block;
    if (schema == nullptr) return;
    if (!is_built_in && schema->kind == BlockKind::material) {
        const std::string_view head = sources_.text(placed.head->span);
        diagnostics_.error(Code::E0408, placed.head->span, "a material cannot be placed")
            .with_hint(fmt::format("use `material: {}` in a shape", head));
        return;
    }
    if (parent == nullptr) top_level_block(placed, *schema);
}

void Checker::top_level_block(const BlockExpr& placed, const BlockSchema& schema) {
    if (schema.kind == BlockKind::material) {
        diagnostics_.error(Code::E0408, placed.head->span, "a material cannot be placed")
            .with_help(
                "give it a name: `let red = material { ... }`, then `material: red` in a shape");
    }
    const bool is_unique = schema.kind == BlockKind::render || schema.kind == BlockKind::info;
    if (!is_unique) return;
    Span& first = schema.kind == BlockKind::render ? first_render_ : first_info_;
    if (first.is_nowhere()) {
        first = placed.head->span;
        return;
    }
    diagnostics_
        .error(Code::E0405, placed.head->span, fmt::format("a second `{}` block", schema.name))
        .with_label(first, "the first one is here");
}

// The schema of the block that an expression makes or names, when that is plain to see.
const BlockSchema* Checker::schema_of(const Expr& expr) const {
    const Expr* at = &expr;
    while (at->kind == ExprKind::block) at = static_cast<const BlockExpr*>(at)->head;
    if (at->kind != ExprKind::name) return nullptr;
    const NameExpr& head = static_cast<const NameExpr&>(*at);
    if (head.meaning == Meaning::block) return &block_schema(static_cast<BlockKind>(head.index));
    if (head.meaning != Meaning::global) return nullptr;
    const Variable* variable = find(head.symbol);
    return variable != nullptr && variable->slot == head.index ? variable->schema : nullptr;
}

void Checker::block(BlockExpr& expr, bool is_placed) {
    ++nesting_;
    if (fits_nesting(expr.head->span)) head_and_body(expr, is_placed);
    --nesting_;
}

void Checker::head_and_body(BlockExpr& expr, bool is_placed) {
    Expr& head = *expr.head;
    if (head.kind == ExprKind::name) {
        name(static_cast<NameExpr&>(head), true);
    } else {
        expression(head);
    }
    const BlockSchema* const schema = schema_of(head);
    const bool is_built_in =
        head.kind == ExprKind::name && static_cast<const NameExpr&>(head).meaning == Meaning::block;
    // A placed node value is an instance; everything else with a value in front is a copy.
    const bool is_instance = is_placed && schema != nullptr && schema->is_placeable;
    const BlockUse use = is_built_in   ? BlockUse::make
                         : is_instance ? BlockUse::instance
                                       : BlockUse::copy;
    open_scope(expr.body.items);
    if (schema != nullptr) {
        items(expr.body.items, schema);
        check_block(*schema, expr, use, symbols_, sources_, diagnostics_);
    } else {  // known when it runs; until then anything may stand there
        static constexpr BlockSchema kUnknown{BlockKind::group, "block", "", {}, false, true};
        items(expr.body.items, &kUnknown);
    }
    close_scope();
}

// The parser bounds each chain and each nest, but not chains in blocks in chains, nor the files
// included in them.
bool Checker::fits_nesting(Span span) {
    if (nesting_ <= max_nesting_) return true;
    if (!is_too_deep_) {
        diagnostics_
            .error(Code::E0115, span, fmt::format("nested more than {} levels deep", max_nesting_))
            .with_help("raise the limit with `--max-nesting N`, or name parts with `let`");
    }
    is_too_deep_ = true;
    return false;
}

void Checker::expression(Expr& expr) {
    if (expr.kind == ExprKind::block) return block(static_cast<BlockExpr&>(expr), false);
    ++nesting_;
    if (fits_nesting(expr.span)) parts_of(expr);
    --nesting_;
}

void Checker::parts_of(Expr& expr) {
    switch (expr.kind) {
        case ExprKind::error:
        case ExprKind::number:
        case ExprKind::boolean:
        case ExprKind::string:
        case ExprKind::color:
        case ExprKind::packed_list:
            return;
        case ExprKind::name:
            name(static_cast<NameExpr&>(expr), false);
            return;
        case ExprKind::unary:
            expression(*static_cast<UnaryExpr&>(expr).operand);
            return;
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
            call(static_cast<CallExpr&>(expr));
            return;
        case ExprKind::index:
            expression(*static_cast<IndexExpr&>(expr).object);
            expression(*static_cast<IndexExpr&>(expr).index);
            return;
        case ExprKind::member:
            expression(*static_cast<MemberExpr&>(expr).object);
            return;
        case ExprKind::list:
            for (Expr* element : static_cast<ListExpr&>(expr).elements) expression(*element);
            return;
        case ExprKind::block:
            break;
        case ExprKind::comprehension:
        case ExprKind::function:
            return;
    }
    LRAY_ASSERT(false);
}

void Checker::name(NameExpr& expr, bool is_block_head) {
    const std::string_view text = symbols_.text(expr.symbol);
    if (const Variable* variable = find(expr.symbol)) {
        expr.meaning = Meaning::global;
        expr.index = variable->slot;
    } else if (const BlockSchema* schema = find_block(expr.symbol)) {
        if (!is_block_head) {
            diagnostics_.error(Code::E0116, expr.span,
                               fmt::format("`{}` needs braces: `{} {{ }}`", text, text));
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
    } else if (text == "colors") {
        expr.meaning = Meaning::colors;
    } else {
        unknown_name(expr, is_block_head);
    }
}

void Checker::unknown_name(const NameExpr& expr, bool is_block_head) {
    const std::string_view text = symbols_.text(expr.symbol);
    if (const Span* later = defined_later(expr.symbol)) {
        diagnostics_
            .error(Code::E0202, expr.span,
                   diagnostics_.takes_hints() && later->source == expr.span.source
                       ? fmt::format("`{}` is used before line {} defines it", text,
                                     sources_.position(*later).line)
                       : fmt::format("`{}` is used before it is defined", text))
            .with_label(*later, "defined here, later");
        return;
    }
    if (has_failed_include_ || was_reported(text)) return;
    if (is_not_yet_available(text)) {
        diagnostics_.error(Code::E0120, expr.span,
                           fmt::format("`{}` is not available in this version of lray", text));
        return;
    }
    std::vector<std::string_view> names;
    constexpr std::size_t kMaxNames = 100'000;
    const bool is_searched = diagnostics_.takes_hints() && innermost_.size() <= kMaxNames;
    if (is_searched) {
        names.reserve(innermost_.size());
        for (const auto& [symbol, index] : innermost_) names.push_back(symbols_.text(symbol));
        std::sort(names.begin(), names.end());
    }
    if (is_block_head) {
        for (const BlockSchema& schema : block_schemas()) names.push_back(schema.name);
    } else {
        for (const Builtin& builtin : builtins()) names.push_back(builtin.name);
        for (const Constant& constant : prelude_constants()) names.push_back(constant.name);
    }
    Diagnostic& diagnostic =
        diagnostics_.error(Code::E0201, expr.span, fmt::format("unknown name `{}`", text));
    const std::string_view habit = is_block_head ? block_habit(text) : std::string_view{};
    if (!habit.empty()) {
        diagnostic.with_hint(fmt::format("here it is called `{}`", habit));
    } else {
        diagnostic.with_hint(did_you_mean(text, names));
    }
}

void Checker::call(const CallExpr& expr) {
    for (const Argument& argument : expr.arguments) expression(*argument.value);
    if (expr.callee->kind == ExprKind::name) {
        NameExpr& callee = static_cast<NameExpr&>(*expr.callee);
        const std::string_view text = symbols_.text(callee.symbol);
        // A function may have the name of a colour (`gray`) or of a block (none has yet).
        const std::optional<std::uint32_t> builtin = find_builtin(text);
        if (find(callee.symbol) == nullptr && builtin) {
            callee.meaning = Meaning::builtin;
            callee.index = *builtin;
            check_arguments(expr, builtins()[*builtin], symbols_, diagnostics_);
            return;
        }
        if (find(callee.symbol) == nullptr && find_block(callee.symbol) != nullptr) {
            diagnostics_.error(Code::E0407, callee.span,
                               fmt::format("`{}` is a block; write `{} {{ {} }}`", text, text,
                                           as_properties(expr)));
            return;
        }
        name(callee, false);
        if (callee.meaning == Meaning::unknown) return;
    } else {
        expression(*expr.callee);
    }
    diagnostics_.error(Code::E0307, expr.callee->span,
                       fmt::format("`{}` is not a function", sources_.text(expr.callee->span)));
}

// `radius: 2, center: p` of a call, when all its arguments have names.
std::string Checker::as_properties(const CallExpr& expr) const {
    std::string result;
    for (const Argument& argument : expr.arguments) {
        if (argument.name == kNoSymbol) return "...";
        result += fmt::format("{}{}: {}", result.empty() ? "" : ", ", symbols_.text(argument.name),
                              sources_.text(argument.value->span));
    }
    return result.empty() ? "..." : result;
}

}  // namespace

Checked check(std::span<Item* const> items, const Symbols& symbols, const Sources& sources,
              std::uint32_t max_nesting, Arena& arena, Diagnostics& diagnostics) {
    return Checker(symbols, sources, max_nesting, arena, diagnostics).check(items);
}

}  // namespace lray::parser
