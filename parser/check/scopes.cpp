#include "parser/check/scopes.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/assert.h"

namespace lray::parser {

namespace {

void collect(std::span<Item* const> items, std::unordered_map<Symbol, LetItem*>& lets) {
    for (Item* item : items) {
        if (item->kind == ItemKind::let) {
            LetItem& let = static_cast<LetItem&>(*item);
            lets.try_emplace(let.name, &let);
        } else if (item->kind == ItemKind::include) {
            collect(static_cast<const IncludeItem&>(*item).items, lets);
        }
    }
}

}  // namespace

void Scopes::close() {
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

Variable& Scopes::declare(Variable variable) {
    const Variable* const hidden = find(variable.name);
    variable.outer = hidden == nullptr ? -1 : hidden - variables_.data();
    variable.scope = scopes_.size();
    innermost_[variable.name] = variables_.size();
    return variables_.emplace_back(variable);
}

Variable* Scopes::find(Symbol symbol) {
    const auto found = innermost_.find(symbol);
    return found == innermost_.end() ? nullptr : &variables_[found->second];
}

Scopes::Later Scopes::find_later(Symbol symbol) {
    for (std::size_t i = scopes_.size(); i-- > 0;) {
        Scope& scope = scopes_[i];
        if (!scope.lets) collect(scope.items, scope.lets.emplace());
        const auto found = scope.lets->find(symbol);
        if (found != scope.lets->end()) return {found->second, &scope};
    }
    return {};
}

std::vector<std::string_view> Scopes::names(const Symbols& symbols) const {
    constexpr std::size_t kMaxNames = 100'000;
    std::vector<std::string_view> names;
    if (innermost_.size() > kMaxNames) return names;
    names.reserve(innermost_.size());
    for (const auto& [symbol, index] : innermost_) names.push_back(symbols.text(symbol));
    std::sort(names.begin(), names.end());
    return names;
}

std::uint32_t slot_in(Context& context, const Context* owner, std::uint32_t slot) {
    if (&context == owner) return slot;
    for (const Context::Captured& captured : context.captured) {
        if (captured.owner == owner && captured.slot == slot) return captured.own_slot;
    }
    if (context.captured.size() == kMaxCaptures) {
        context.captures_too_much = true;
        return context.captured.back().own_slot;
    }
    context.captured.push_back({owner, slot, context.frame_size});
    return context.frame_size++;
}

Context& FunctionUses::add(Function* function, const Context* outer) {
    Context& context = contexts_.emplace_back();
    context.function = function;
    context.outer = outer;
    if (function != nullptr) {
        function->id = static_cast<std::uint32_t>(functions_.size());
        functions_.push_back(&context);
    }
    return context;
}

std::uint32_t FunctionUses::use(Function& function, Context& from) {
    uses_.push_back({&function, &from});
    return static_cast<std::uint32_t>(uses_.size() - 1);
}

void FunctionUses::resolve(Arena& arena, std::vector<FunctionUse>& uses, Diagnostics& diagnostics) {
    // What a function captures and prints is also captured and printed by whoever names it.
    std::vector<std::vector<Context*>> named_by(functions_.size());
    for (const Use& use : uses_) named_by[use.function->id].push_back(use.from);
    std::vector<Context*> changed(functions_.rbegin(), functions_.rend());
    std::vector<bool> is_waiting(functions_.size(), true);
    // One that captures too much is an error: the others need not be known then.
    bool is_too_much = false;
    while (!changed.empty() && !is_too_much) {
        Context& context = *changed.back();
        changed.pop_back();
        is_waiting[context.function->id] = false;
        for (Context* from : named_by[context.function->id]) {
            const std::size_t captured_before = from->captured.size();
            const bool had_effects = from->has_effects;
            from->has_effects = from->has_effects || context.has_effects;
            for (std::size_t i = 0; i < context.captured.size(); ++i) {
                const Context::Captured captured = context.captured[i];
                slot_in(*from, captured.owner, captured.slot);
            }
            is_too_much = is_too_much || from->captures_too_much;
            const bool is_changed =
                from->captured.size() != captured_before || from->has_effects != had_effects;
            if (is_changed && from->function != nullptr && !is_waiting[from->function->id]) {
                is_waiting[from->function->id] = true;
                changed.push_back(from);
            }
        }
    }
    for (Context* context : functions_) {
        if (context->captures_too_much) {
            diagnostics
                .error(
                    Code::E0306, context->function->name_span,
                    fmt::format("this uses more than {} names of the code around it", kMaxCaptures))
                .with_help("pass them as parameters, in a list or a `record`");
        }
        std::vector<std::uint32_t> slots;
        for (const Context::Captured& captured : context->captured) {
            slots.push_back(captured.own_slot);
        }
        context->function->capture_slots = arena.copy(slots);
        context->function->frame_size = context->frame_size;
        context->function->has_effects = context->has_effects;
    }
    for (const Use& use : uses_) {
        std::vector<std::uint32_t> slots;
        for (const Context::Captured& captured : functions_[use.function->id]->captured) {
            slots.push_back(slot_in(*use.from, captured.owner, captured.slot));
        }
        uses.push_back({use.function, arena.copy(slots)});
    }
}

}  // namespace lray::parser
