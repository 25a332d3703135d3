// Functions of strings. A string that is made keeps the file of the left-most string it is made
// of: paths are relative to where they were written.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string_view>

#include "parser/builtins/families.h"
#include "parser/builtins/format_text.h"
#include "parser/builtins/results.h"
#include "parser/builtins/sequence.h"
#include "parser/values/value_text.h"

namespace lray::parser {

namespace {

/// Returns room for a string; null when the budget is spent, reported.
char* take_string(Call& call, std::uint64_t size) {
    const bool is_paid = take_bytes(call.budget, size, call.span, call.diagnostics) &&
                         take_text_steps(call.budget, size, call.span, call.diagnostics);
    return is_paid ? static_cast<char*>(call.arena.allocate(size, 1)) : nullptr;
}

/// Returns the texts of the values one after the other, with a separator between them.
Value joined(Call& call, std::span<const Value> values, std::string_view separator,
             SourceId source) {
    std::uint64_t size = 0;
    // More would not be paid for; a string has 4 GiB at most.
    const std::uint64_t limit =
        std::min<std::uint64_t>(call.budget.value_bytes, std::numeric_limits<std::uint32_t>::max());
    const std::uint64_t too_much = limit + 1;
    for (std::size_t i = 0; i < values.size() && size <= limit; ++i) {
        if (!take_steps(call, 1)) return Value::poison();
        size += i > 0 ? separator.size() : 0;
        if (size > limit) break;
        size += text_size(values[i], call.runtime.symbols(), limit - size).value_or(too_much);
    }
    if (size > limit && limit < call.budget.value_bytes) {
        call.diagnostics.error(Code::E0516, call.span, "a string must be smaller than 4 GiB");
        return Value::poison();
    }
    char* const text = take_string(call, size);
    if (text == nullptr) return Value::poison();
    char* out = text;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) out = std::copy(separator.begin(), separator.end(), out);
        out = write_text(values[i], call.runtime.symbols(), out);
    }
    return Value::of_string({text, static_cast<std::size_t>(size)}, source);
}

/// The file of the first string among the values; of none, that of the call.
SourceId origin_of(const Call& call, std::span<const Value> values) {
    const auto first = std::ranges::find(values, ValueKind::string, &Value::kind);
    return first != values.end() ? first->source : call.span.source;
}

Value str_of(Call& call) {
    return joined(call, call.rest, "", origin_of(call, call.rest));
}

Value join_of(Call& call) {
    Sequence sequence(call);
    if (!sequence.add_all(call[0])) return Value::poison();
    const std::string_view separator =
        call[1].is(ValueKind::none) ? std::string_view{} : call[1].string();
    return joined(call, sequence.elements(), separator, origin_of(call, sequence.elements()));
}

Value format_of(Call& call) {
    const std::optional<FormatText> format = parse_format(call);
    if (!format) return Value::poison();
    return joined(call, format->pieces, "", call[0].source);
}

template <char (*change)(char)>
Value changed(Call& call) {
    char* const text = take_string(call, call[0].count);
    if (text == nullptr) return Value::poison();
    std::transform(call[0].text, call[0].text + call[0].count, text, change);
    return Value::of_string({text, call[0].count}, call[0].source);
}

char upper_of(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
char lower_of(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// The bytes of the character at the beginning.
std::size_t character_size(std::string_view text) {
    std::size_t size = 1;
    while (size < text.size() && (text[size] & 0xc0) == 0x80) ++size;  // UTF-8
    return size;
}

Value split_of(Call& call) {
    std::string_view text = call[0].string();
    const std::string_view separator = call[1].string();
    // A search may compare the separator at each place.
    const std::uint64_t cost =
        text.size() + text.size() / 64 * std::min<std::uint64_t>(separator.size(), text.size());
    if (!take_text_steps(call.budget, cost, call.span, call.diagnostics)) return Value::poison();
    Sequence parts(call);
    const auto add = [&](std::string_view part) {
        return parts.add(Value::of_string(part, call[0].source));
    };
    if (separator.empty()) {
        while (!text.empty()) {
            const std::size_t size = character_size(text);
            if (!add(text.substr(0, size))) return Value::poison();
            text.remove_prefix(size);
        }
        return parts.finish();
    }
    for (;;) {
        const std::size_t end = text.find(separator);
        if (!add(text.substr(0, end))) return Value::poison();
        if (end == std::string_view::npos) return parts.finish();
        text.remove_prefix(end + separator.size());
    }
}

using enum ParameterType;

constexpr Parameter kText{"text", string};

// clang-format off
constexpr std::array kBuiltins = {
    Builtin{.name = "str", .function = str_of, .doc = "the values as text, one after the other", .is_variadic = true, .rest_type = any},
    Builtin{.name = "format", .parameters = {kText}, .function = format_of, .doc = "the text with a value for each `{}`, `{:.2}` for 2 decimals; `{{` and `}}` are braces", .is_variadic = true, .rest_type = any},
    Builtin{"upper", {kText}, changed<upper_of>, "with A to Z for a to z"},
    Builtin{"lower", {kText}, changed<lower_of>, "with a to z for A to Z"},
    Builtin{"split", {{kText, {"separator", string}}}, split_of, "the parts between separators; with an empty one, the characters"},
    Builtin{"join", {{{"list", list}, {"separator", string, true}}}, join_of, "the elements as text, with the separator between them"},
};
// clang-format on

}  // namespace

std::span<const Builtin> string_builtins() {
    return kBuiltins;
}

}  // namespace lray::parser
