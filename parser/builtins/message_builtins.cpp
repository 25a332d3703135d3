// Functions that tell the user something.
#include <array>
#include <string>
#include <string_view>

#include "parser/builtins/families.h"
#include "parser/builtins/results.h"
#include "parser/values/value_text.h"

namespace lray::parser {

namespace {

constexpr std::size_t kMaxLine = std::size_t{1} << 14;     // bytes of what is printed at once
constexpr std::size_t kMaxMessage = std::size_t{1} << 10;  // bytes of a message

// What a message gives back when it is used as a value: `x > 0 or warn("...")`.
constexpr Value kDone = Value::of(true);

std::string text_of(Call& call, const Value& value, std::size_t limit) {
    return value_text(value, call.runtime.symbols(), limit);
}

Value print_of(Call& call) {
    std::string line;
    for (std::size_t i = 0; i < call.rest.size() && line.size() <= kMaxLine; ++i) {
        if (i > 0) line += ' ';
        const std::string text = text_of(call, call.rest[i], kMaxLine);
        if (!take_text_steps(call.budget, text.size(), call.span, call.diagnostics)) {
            return Value::poison();
        }
        line += text;
    }
    if (line.size() > kMaxLine) {
        line = text_of(call, Value::of_string(line, kNoSource), kMaxLine);
    }
    call.runtime.print(line, call.span);
    return kDone;
}

Value warn_of(Call& call) {
    call.diagnostics.warning(Code::W1106, call.span, text_of(call, call[0], kMaxMessage));
    return kDone;
}

Value error_of(Call& call) {
    call.diagnostics.error(Code::E0508, call.span, text_of(call, call[0], kMaxMessage));
    return Value::poison();
}

Value assert_of(Call& call) {
    if (call[0].boolean) return kDone;
    const std::string message =
        call[1].is(ValueKind::none) ? "this does not hold" : text_of(call, call[1], kMaxMessage);
    call.diagnostics.error(Code::E0507, call.spans[0], message);
    return Value::poison();
}

using enum ParameterType;

// clang-format off
constexpr std::array kBuiltins = {
    Builtin{.name = "print", .function = print_of, .doc = "writes the values on a line, for you to see; true", .is_variadic = true, .rest_type = any, .has_effects = true, .is_statement = true},
    Builtin{.name = "warn", .parameters = {{{"message", any}}}, .function = warn_of, .doc = "a warning with your words; true", .has_effects = true, .is_statement = true},
    Builtin{.name = "error", .parameters = {{{"message", any}}}, .function = error_of, .doc = "an error with your words", .is_statement = true},
    Builtin{.name = "assert", .parameters = {{{"condition", boolean}, {"message", any, true}}}, .function = assert_of, .doc = "an error unless the condition is true; true", .is_statement = true},
};
// clang-format on

}  // namespace

std::span<const Builtin> message_builtins() {
    return kBuiltins;
}

}  // namespace lray::parser
