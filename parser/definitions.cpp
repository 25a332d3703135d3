#include "parser/definitions.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "base/did_you_mean.h"
#include "parser/check/constant_value.h"

namespace lray::parser {

namespace {

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
    return constant_value(*static_cast<const LetItem&>(*file.items[0]).value, context.arena);
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
