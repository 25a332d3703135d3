#include "tests/parser/builtin_caller.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "base/assert.h"
#include "parser/blocks/schema.h"

namespace lray::test {

using parser::Value;
using parser::ValueKind;

BuiltinCaller::BuiltinCaller() {
    budget = {1'000'000, 10'000'000, 1'000'000, 10'000'000, 1000, false};
}

Value BuiltinCaller::string(std::string_view text, SourceId source) {
    return Value::of_string(arena_.copy(text), source);
}

Value BuiltinCaller::list(std::initializer_list<Value> elements) {
    return parser::make_list({elements.begin(), elements.size()}, arena_);
}

Value BuiltinCaller::numbers(std::initializer_list<double> numbers) {
    return parser::list_of_numbers(
        arena_.copy(std::span<const double>(numbers.begin(), numbers.size())));
}

Value BuiltinCaller::color(double r, double g, double b) {
    const std::array rgba = {r, g, b, 1.0};
    return Value::of_color(arena_.copy(std::span<const double>(rgba)).data());
}

Value BuiltinCaller::function(Function function) {
    functions_.push_back(std::move(function));
    // `builtin` says which one it is; no such built-in function is called.
    function_values_.push_back({nullptr, static_cast<std::uint32_t>(functions_.size() - 1)});
    return Value::of_function(&function_values_.back(), 1);
}

Value BuiltinCaller::node(scene::NodeId id) {
    made_.push_back({&parser::block_schema(parser::BlockKind::group), nullptr, id.value});
    return Value::of_made(ValueKind::node, &made_.back());
}

Value BuiltinCaller::nested(std::size_t depth) {
    Value value = boolean(true);
    for (std::size_t i = 0; i < depth; ++i) value = list({value});
    return value;
}

Value BuiltinCaller::call(std::string_view name, std::vector<Value> arguments) {
    const auto index = parser::find_builtin(name);
    LRAY_ASSERT(index.has_value());
    const parser::Builtin& builtin = parser::builtins()[*index];
    const auto span_at = [](std::size_t column) {
        return Span{static_cast<std::uint32_t>(column - 1), 0, 1};
    };
    parser::Call call{{}, {}, {}, span_at(1), arena_, budget, diagnostics, *this, {}, {}};
    std::vector<Span> rest_spans;
    const std::size_t fixed = std::min(builtin.parameter_count(), arguments.size());
    LRAY_ASSERT(fixed >= builtin.required_count());
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const Span span = span_at(10 * (i + 1));
        if (i < fixed) {
            call.arguments[i] = arguments[i];
            call.spans[i] = span;
        } else {
            LRAY_ASSERT(builtin.is_variadic);
            rest_spans.push_back(span);
        }
    }
    call.rest = std::span<const Value>(arguments).subspan(fixed);
    call.rest_spans = rest_spans;
    return call_builtin(builtin, call);
}

std::string BuiltinCaller::says(std::string_view name, std::vector<Value> arguments) {
    diagnostics = {};
    const Value result = call(name, std::move(arguments));
    std::string text;
    for (const Diagnostic* diagnostic : diagnostics.sorted()) {
        text += fmt::format("{}{} {} {}", text.empty() ? "" : "\n", code_info(diagnostic->code).id,
                            diagnostic->span.offset + 1, diagnostic->message);
    }
    EXPECT_EQ(result.is(ValueKind::poison), diagnostics.has_errors()) << name << ": " << text;
    if (!text.empty() || result.is(ValueKind::poison)) return text;
    constexpr std::size_t kLimit = 1000;
    const std::string shown = value_text(result, symbols_, kLimit);
    return result.is(ValueKind::string) ? fmt::format("\"{}\"", shown) : shown;
}

Value BuiltinCaller::call_function(const Value& function, std::span<const Value> arguments, Span) {
    return functions_[function.function->builtin](arguments);
}

}  // namespace lray::test
