// Evaluates what stands in a file or between braces: names, assignments, choices, loops.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assert.h"
#include "parser/evaluate/evaluator_state.h"
#include "parser/values/type_name.h"
#include "parser/values/value_text.h"

namespace lray::parser {

Flow Evaluator::items(std::span<Item* const> list, OpenBlock& open) {
    if (!take_share(list.size(), list.empty() ? Span{} : list.front()->span)) return Flow::normal;
    for (Item* at : list) {
        const Flow flow = item(*at, open);
        if (flow != Flow::normal) return flow;
    }
    return Flow::normal;
}

Flow Evaluator::item(Item& item, OpenBlock& open) {
    switch (item.kind) {
        case ItemKind::let:
            let(static_cast<const LetItem&>(item));
            return Flow::normal;
        case ItemKind::property:
            property(static_cast<PropertyItem&>(item), open);
            return Flow::normal;
        case ItemKind::block:
            if (!open.is_import) placed_block(*static_cast<BlockItem&>(item).block, open);
            return Flow::normal;
        case ItemKind::literals:
            if (!open.is_import) literals(static_cast<const LiteralsItem&>(item), open);
            return Flow::normal;
        case ItemKind::include:
            return items(static_cast<const IncludeItem&>(item).items, open);
        case ItemKind::import:
            import(static_cast<const ImportItem&>(item));
            return Flow::normal;
        case ItemKind::file_view:
            if (!open.is_import) file_view(static_cast<const FileViewItem&>(item));
            return Flow::normal;
        case ItemKind::call: {
            const Value value = eval(*static_cast<const CallItem&>(item).value);
            if (value.is(ValueKind::poison)) ++failures_;
            return Flow::normal;
        }
        case ItemKind::assignment:
            assign(static_cast<const AssignmentItem&>(item));
            return Flow::normal;
        case ItemKind::function:
            return Flow::normal;
        case ItemKind::conditional: {
            const ConditionalItem& choice = static_cast<const ConditionalItem&>(item);
            const std::optional<bool> chosen = condition(*choice.condition);
            if (!chosen) {
                ++failures_;
                return Flow::normal;
            }
            return items(*chosen ? choice.then_body.items : choice.else_body.items, open);
        }
        case ItemKind::for_loop:
            return for_loop(static_cast<ForItem&>(item), open);
        case ItemKind::while_loop:
            return while_loop(static_cast<WhileItem&>(item), open);
        case ItemKind::break_loop:
            return Flow::break_loop;
        case ItemKind::continue_loop:
            return Flow::continue_loop;
        case ItemKind::return_value:
            result_ = eval(*static_cast<const ReturnItem&>(item).value);
            return Flow::return_value;
    }
    LRAY_ASSERT(false);
}

void Evaluator::let(const LetItem& item) {
    Value value = item.let_kind == LetKind::param ? param(item) : eval(*item.value);
    if (!value.is(ValueKind::poison) && !has_type(item.type, value)) {
        error(Code::E0301, item.value->span, needs_type(item, value));
        value = Value::poison();
    }
    if (value.is(ValueKind::poison)) ++failures_;
    *variable({item.slot, item.is_global}) = value;
}

std::string Evaluator::needs_type(const LetItem& item, const Value& value) const {
    return fmt::format("`{}` needs {}, this is {}", symbols_.text(item.name), in_words(item.type),
                       describe(value));
}

// A value from the command line takes the place of the default; it has to fit likewise.
Value Evaluator::param(const LetItem& item) {
    const Value fallback = eval(*item.value);
    Value choices;
    if (item.choices != nullptr) choices = eval(*item.choices);
    if (fallback.is(ValueKind::poison) || choices.is(ValueKind::poison)) return Value::poison();
    const auto given = environment_.params.find(&item);
    if (given == environment_.params.end()) {
        const std::optional<Misfit> misfit = misfit_of(item, fallback, fallback, choices);
        if (misfit) error(misfit->code, misfit->span, misfit->message);
        if (misfit) return Value::poison();
        list_param(item, fallback, fallback, choices);
        return fallback;
    }
    const Value value = given->second;
    std::optional<Misfit> misfit = misfit_of(item, value, fallback, choices);
    if (!misfit && !has_type(item.type, value)) {
        misfit = Misfit{Code::E0301, Span{}, needs_type(item, value)};
    }
    if (!misfit) {
        const bool has_good_default = !misfit_of(item, fallback, fallback, choices);
        if (has_good_default) list_param(item, value, fallback, choices);
        return value;
    }
    environment_.usage_mistakes->push_back(misfit->message);
    return fallback;
}

void Evaluator::list_param(const LetItem& item, const Value& value, const Value& fallback,
                           const Value& choices) {
    if (environment_.listed_params == nullptr || !has_type(item.type, value)) return;
    if (params_of_items_.empty()) {
        for (const Param& param : checked_.params) params_of_items_.emplace(param.item, &param);
    }
    environment_.listed_params->add(*params_of_items_.at(&item), value, fallback, choices);
}

// What is wrong with a value of a param; empty if it is one of those that follow `in`.
std::optional<Evaluator::Misfit> Evaluator::misfit_of(const LetItem& item, const Value& value,
                                                      const Value& fallback, const Value& choices) {
    const std::string_view name = symbols_.text(item.name);
    const Span span = item.value->span;
    if (choices.is(ValueKind::none)) {
        const bool is_same_kind =
            value.kind == fallback.kind ||
            (has_type(TypeName::color, fallback) && has_type(TypeName::color, value));
        if (is_same_kind || item.type != TypeName::any) return std::nullopt;
        return Misfit{Code::E0301, span,
                      fmt::format("`{}` is {} by default, this is {}", name, describe(fallback),
                                  describe(value))};
    }
    if (!choices.is_list() || choices.count == 0) {
        return Misfit{Code::E0301, item.choices->span,
                      fmt::format("`{}` needs its least and greatest value, like [0, 10], or a "
                                  "list of what it may be",
                                  name)};
    }
    if (choices.is_vector(2)) {
        const double low = choices.numbers[0];
        const double high = choices.numbers[1];
        if (!value.is(ValueKind::number)) {
            return Misfit{Code::E0301, span,
                          fmt::format("`{}` needs a number, this is {}", name, describe(value))};
        }
        if (low > high) {
            return Misfit{
                Code::E0304, item.choices->span,
                fmt::format("the least value of `{}` is greater than the greatest", name)};
        }
        if (value.number < low || value.number > high) {
            return Misfit{
                Code::E0304, span,
                fmt::format("`{}` must be from {} to {}, this is {}", name, format_number(low),
                            format_number(high), format_number(value.number))};
        }
        const bool is_whole = value.number == std::floor(value.number);
        if (is_whole || !is_whole_range(fallback, choices)) return std::nullopt;
        return Misfit{Code::E0308, span,
                      fmt::format("`{}` needs a whole number, this is {}", name,
                                  format_number(value.number))};
    }
    std::string allowed;
    for (std::uint32_t i = 0; i < choices.count; ++i) {
        const Value choice = element(choices, i);
        const std::optional<bool> is_same = is_equal(value, choice, span, budget_, diagnostics_);
        if (!is_same || *is_same) return std::nullopt;
        if (i < 8)
            allowed +=
                fmt::format("{}{}", i == 0 ? "" : ", ", value_text(choice, symbols_, kShownBytes));
    }
    return Misfit{Code::E0304, span,
                  fmt::format("`{}` must be one of {}; this is {}", name, allowed,
                              value_text(value, symbols_, kShownBytes))};
}

void Evaluator::assign(const AssignmentItem& item) {
    const NameExpr& target = static_cast<const NameExpr&>(*item.target);
    const Value value = eval(*item.value);
    if (value.is(ValueKind::poison)) ++failures_;
    *variable({target.index, target.meaning == Meaning::global}) = value;
}

// The outermost items of an imported file run once, in a frame of their own.
void Evaluator::import(const ImportItem& item) {
    const Module& module = *item.module;
    if (is_imported_[module.id]) return;
    is_imported_[module.id] = true;
    const std::size_t old_base = base_;
    const std::size_t old_top = top_;
    base_ = top_;
    top_ += module.frame_size;
    if (slots_.size() < top_) slots_.resize(top_);
    std::fill_n(slots_.begin() + static_cast<std::ptrdiff_t>(base_), module.frame_size, Value{});
    frame_ = slots_.data() + base_;
    OpenBlock open(block_schema(BlockKind::group), item.span);
    open.is_import = true;
    items(module.items, open);
    base_ = old_base;
    top_ = old_top;
    frame_ = slots_.data() + base_;
}

std::optional<Evaluator::Sequence> Evaluator::sequence(const Expr& expr) {
    if (expr.kind == ExprKind::call) {
        const CallExpr& call = static_cast<const CallExpr&>(expr);
        const bool is_range =
            call.callee->kind == ExprKind::name &&
            static_cast<const NameExpr&>(*call.callee).meaning == Meaning::builtin &&
            static_cast<const NameExpr&>(*call.callee).index == range_builtin_;
        if (is_range) {
            if (std::optional<Sequence> range = range_of(call)) return range;
        }
    }
    const Value list = eval(expr);
    if (list.is(ValueKind::poison)) return std::nullopt;
    if (!list.is_list()) {
        Diagnostic& diagnostic =
            error(Code::E0301, expr.span,
                  fmt::format("a loop goes through a list, this is {}", describe(list)));
        if (list.is(ValueKind::number)) {
            diagnostic.with_help(fmt::format("count with `range({})`", text(expr)));
        }
        return std::nullopt;
    }
    Sequence sequence;
    sequence.list = list;
    sequence.count = list.count;
    return sequence;
}

// A range with plain arguments is counted, not made. Empty: to be called like any function, which
// also reports what is wrong.
std::optional<Evaluator::Sequence> Evaluator::range_of(const CallExpr& call) {
    std::array<double, 3> numbers{0.0, 0.0, 1.0};
    const std::size_t count = call.arguments.size();
    if (count == 0 || count > 3) return std::nullopt;
    const std::uint64_t steps = budget_.steps;
    for (std::size_t i = 0; i < count; ++i) {
        const Argument& argument = call.arguments[i];
        const bool is_plain =
            argument.name == kNoSymbol &&
            (argument.value->kind == ExprKind::number || argument.value->kind == ExprKind::name ||
             argument.value->kind == ExprKind::binary || argument.value->kind == ExprKind::member);
        if (!is_plain) return std::nullopt;
        const Value value = eval(*argument.value);
        if (!value.is(ValueKind::number)) {
            budget_.steps = budget_.is_spent ? 0 : steps;
            return std::nullopt;
        }
        numbers[i] = value.number;
    }
    Sequence range;
    range.is_range = true;
    double end = numbers[0];
    if (count > 1) {
        range.start = numbers[0];
        end = numbers[1];
        range.step = numbers[2];
    }
    if (range.step == 0.0) return std::nullopt;
    const double size = range_count(range.start, end, range.step);
    if (!(size <= 9007199254740992.0)) return std::nullopt;  // 2^53: reported as too long a list
    range.count = size > 0.0 ? static_cast<std::uint64_t>(size) : 0;
    return range;
}

Flow Evaluator::for_loop(ForItem& item, OpenBlock& open) {
    const std::optional<Sequence> elements = sequence(*item.sequence);
    if (!elements) {
        ++failures_;
        return Flow::normal;
    }
    LoopMemory memory{memory_.begin()};
    for (std::uint64_t i = 0; i < elements->count; ++i) {
        if (item.index_name != kNoSymbol) {
            frame_[item.index_slot] = Value::of(static_cast<double>(i));
        }
        frame_[item.element_slot] = elements->at(i);
        if (!take_steps(budget_, 1, item.sequence->span, diagnostics_)) break;
        const std::uint64_t failures = failures_;
        const Flow flow = time_round(item.body, item.loop, memory, open);
        if (flow == Flow::return_value) return flow;
        if (flow == Flow::break_loop || failures_ != failures) break;
    }
    return Flow::normal;
}

Flow Evaluator::while_loop(WhileItem& item, OpenBlock& open) {
    LoopMemory memory{memory_.begin()};
    while (true) {
        const std::optional<bool> goes_on = condition(*item.condition);
        if (!goes_on) ++failures_;
        if (!goes_on || !*goes_on) break;
        const std::uint64_t failures = failures_;
        const Flow flow = time_round(item.body, item.loop, memory, open);
        if (flow == Flow::return_value) return flow;
        if (flow == Flow::break_loop || failures_ != failures) break;
    }
    return Flow::normal;
}

Flow Evaluator::time_round(const Body& body, const LoopInfo& loop, LoopMemory& memory,
                           OpenBlock& open) {
    const std::size_t slots = loop.renewed.size() + loop.assigned.size();
    if (!take_share(slots, body.open)) return Flow::break_loop;
    for (const std::uint32_t slot : loop.renewed) frame_[slot] = Value{};
    const Flow flow = items(body.items, open);
    if (flow == Flow::normal || flow == Flow::continue_loop) end_round(loop, memory);
    return flow;
}

// Gives back what the time round has made, as far as no variable holds it.
void Evaluator::end_round(const LoopInfo& loop, LoopMemory& memory) {
    const Region& region = memory.region;
    if (loop.sets_properties || memory_.is_untouched(region)) return;
    bool is_in_use = false;
    for (const SlotRef& slot : loop.assigned) {
        is_in_use = is_in_use || memory_.is_made_since(region, *variable(slot));
    }
    if (!is_in_use) {
        memory_.end(region);
        return;
    }
    if (!memory_.is_worth_copying(region, memory.in_use)) return;
    memory.in_use = memory_.end_with_values(region, [&](const auto& visit) {
        for (const SlotRef& slot : loop.assigned) visit(*variable(slot));
    });
}

}  // namespace lray::parser
