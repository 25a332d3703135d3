#include "parser/definitions.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>

#include "base/did_you_mean.h"
#include "parser/builtins/builtins.h"
#include "parser/check/constant_value.h"
#include "parser/values/operators.h"

namespace lray::parser {

namespace {

std::optional<Value> literal_value(const Expr& expr, Arena& arena);

// `rgb(1, 0.5, 0)`: a colour that has no hex digits.
std::optional<Value> color_value(const CallExpr& call, Arena& arena) {
    if (call.callee->kind != ExprKind::name || call.arguments.size() != 3) return std::nullopt;
    const NameExpr& callee = static_cast<const NameExpr&>(*call.callee);
    const bool is_rgb = callee.meaning == Meaning::builtin && callee.index == find_builtin("rgb");
    std::array<double, 4> rgba{0.0, 0.0, 0.0, 1.0};
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
        const Argument& argument = call.arguments[i];
        const std::optional<Value> channel = constant_value(*argument.value, arena);
        const bool is_plain =
            argument.name == kNoSymbol && channel && channel->is(ValueKind::number);
        if (!is_rgb || !is_plain) return std::nullopt;
        rgba[i] = channel->number;
    }
    return Value::of_color(arena.copy(std::span<const double>(rgba)).data());
}

std::optional<Value> list_value(const ListExpr& expr, Arena& arena) {
    std::vector<Value> elements;
    for (const Expr* element : expr.elements) {
        const std::optional<Value> value = literal_value(*element, arena);
        if (!value) return std::nullopt;
        elements.push_back(*value);
    }
    return make_list(elements, arena);
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as literal() lets the checker go
std::optional<Value> literal_value(const Expr& expr, Arena& arena) {
    if (expr.kind == ExprKind::call) return color_value(static_cast<const CallExpr&>(expr), arena);
    if (expr.kind == ExprKind::list) return list_value(static_cast<const ListExpr&>(expr), arena);
    return constant_value(expr, arena);
}

// A file that is named on the command line is looked for where that of the default would be.
// NOLINTNEXTLINE(misc-no-recursion): as deep as literal() lets the checker go
Value written_in(SourceId source, const Value& value, Arena& arena) {
    if (value.is(ValueKind::string)) return Value::of_string(value.string(), source);
    if (!value.is(ValueKind::list)) return value;
    std::vector<Value> elements;
    for (std::uint32_t i = 0; i < value.count; ++i) {
        elements.push_back(written_in(source, value.elements[i], arena));
    }
    return make_list(elements, arena);
}

// The text as a value of the language; empty if it is none.
std::optional<Value> literal(std::string_view text, ParseContext& context) {
    Diagnostics problems;
    const SourceId source =
        context.sources.add("the command line", Text(fmt::format("let value = {}\n", text)));
    const ParsedFile file = parse(source, context, problems);
    const bool is_let = file.items.size() == 1 && file.items[0]->kind == ItemKind::let;
    if (!is_let || problems.has_errors() || !file.imports.empty()) return std::nullopt;
    constexpr std::uint32_t kNesting = 64;
    check(file.items, context.scene.nodes, context.symbols, context.sources, kNesting,
          context.arena, problems);
    if (problems.has_errors()) return std::nullopt;
    return literal_value(*static_cast<const LetItem&>(*file.items[0]).value, context.arena);
}

}  // namespace

std::unordered_map<const LetItem*, Value> read_definitions(std::span<const Definition> definitions,
                                                           const Checked& checked,
                                                           ParseContext& context,
                                                           std::vector<std::string>& mistakes) {
    std::unordered_map<const LetItem*, Value> values;
    for (const Definition& definition : definitions) {
        const Param* param = nullptr;
        std::vector<std::string_view> names;
        for (const Param& known : checked.params) {
            names.push_back(known.name);
            if (known.name == definition.name) param = &known;
        }
        if (param == nullptr) {
            const std::string near = did_you_mean(definition.name, names);
            mistakes.push_back(fmt::format("`-D {}`: the scene has no param `{}`{}{}",
                                           definition.name, definition.name,
                                           near.empty() ? "" : "; ", near));
            continue;
        }
        const LetItem& item = *param->item;
        const bool is_text =
            item.value->kind == ExprKind::string && !definition.value.starts_with('"');
        std::optional<Value> value;
        if (is_text) {
            value = Value::of_string(context.arena.copy(std::string_view(definition.value)),
                                     item.value->span.source);
        } else {
            value = literal(definition.value, context);
            if (value) value = written_in(item.value->span.source, *value, context.arena);
        }
        if (!value) {
            mistakes.push_back(
                fmt::format("`-D {}={}`: this is no value, like 1, [1, 2, 3], #ff0000 "
                            "or true",
                            definition.name, definition.value));
            continue;
        }
        values[&item] = *value;
    }
    return values;
}

}  // namespace lray::parser
