// What is written as in other languages: the parser understands it well enough to say how it is
// written here.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "parser/blocks/schema.h"
#include "parser/syntax/parser_state.h"

namespace lray::parser {

namespace {

/// A word that begins a statement elsewhere, before a name or a condition.
struct Habit {
    std::string_view word{};
    std::string_view fix{};
};

constexpr std::string_view kFunction = "a function is written `fn name(x) = value`";
constexpr std::string_view kComponent = "a component is written `component name(x) { ... }`";
constexpr std::string_view kConstant = "a value gets a name with `let name = value`";
constexpr std::string_view kLoop = "a loop is written `for x in xs { ... }`";
constexpr std::string_view kCondition = "a choice is written `if condition { ... } else { ... }`";

constexpr std::array<Habit, 30> kHabits = {{
    {"auto", kConstant},
    {"bool", kConstant},
    {"case", kCondition},
    {"const", kConstant},
    {"def", kFunction},
    {"define", kConstant},
    {"do", "a loop is written `while condition { ... }`"},
    {"double", kConstant},
    {"elif", kCondition},
    {"elseif", kCondition},
    {"elsif", kCondition},
    {"final", kConstant},
    {"float", kConstant},
    {"foreach", kLoop},
    {"fun", kFunction},
    {"func", kFunction},
    {"function", kFunction},
    {"int", kConstant},
    {"loop", "a loop is written `while condition { ... }`"},
    {"macro", kComponent},
    {"module", kComponent},
    {"mut", "what changes is written `var name = value`"},
    {"number", kConstant},
    {"object", kComponent},
    {"proc", kFunction},
    {"string", kConstant},
    {"switch", kCondition},
    {"template", kComponent},
    {"unless", kCondition},
    {"val", kConstant},
}};

/// What types are called elsewhere.
struct TypeHabit {
    std::string_view written{};
    std::string_view type{};
};

constexpr std::array<TypeHabit, 22> kTypeHabits = {{
    {"array", "list"},       {"boolean", "bool"},   {"callable", "function"}, {"colour", "color"},
    {"dict", "record"},      {"direction", "vec3"}, {"double", "number"},     {"float", "number"},
    {"fn", "function"},      {"func", "function"},  {"group", "node"},        {"integer", "int"},
    {"matrix", "transform"}, {"object", "node"},    {"point", "vec3"},        {"real", "number"},
    {"rgb", "color"},        {"shape", "node"},     {"str", "string"},        {"struct", "record"},
    {"text", "string"},      {"vector", "vec3"},
}};

/// Returns what to write in place of a foreign operator, with spaces where a word would run into
/// its neighbours; empty where that is not sure: `not` binds less tightly than `!`.
std::string own_operator(std::string_view text, const Token& token) {
    const std::string_view foreign = text.substr(token.offset, token.length);
    if (foreign == "**") return "^";
    if (foreign != "&&" && foreign != "||") return {};
    const auto is_space = [&](std::size_t at) {
        return at < text.size() && (text[at] == ' ' || text[at] == '\t');
    };
    const bool stands_apart = token.offset > 0 && is_space(token.offset - 1);
    return fmt::format("{}{}{}", stands_apart ? "" : " ", foreign == "&&" ? "and" : "or",
                       is_space(token.end()) ? "" : " ");
}

}  // namespace

std::string_view usual_type(std::string_view word) {
    const auto found = std::find_if(kTypeHabits.begin(), kTypeHabits.end(),
                                    [&](const TypeHabit& known) { return known.written == word; });
    return found == kTypeHabits.end() ? std::string_view{} : found->type;
}

// An operator of another language; `left` is what stands before it, in a value or as an item.
void Parser::foreign_operator(const Expr* left, bool is_value) {
    const Token token = token_;
    const std::string_view text = text_of(token);
    std::string message(foreign_operator_fix(text));
    if (message.empty()) {  // `+=` and its like
        const std::string_view name =
            left != nullptr ? context_.sources.text(left->span) : std::string_view("i");
        advance();
        const std::uint32_t begin = token_.offset;
        const bool has_value = !token_.newline_before && token_.kind != TokenKind::end;
        if (has_value) expression();
        const std::string_view value =
            has_value && !is_panicking_ ? context_.sources.text(span_from(begin)) : "1";
        message = fmt::format("write `{0} = {0} {1} {2}`", name, text.substr(0, 1), value);
    } else if (is_value && (text == "=>" || text == "->")) {
        message = "a function that is a value is written `fn(x) = value`";
    }
    Diagnostic& diagnostic = error(Code::E0112, span_of(token), std::move(message));
    const std::string ours = own_operator(context_.sources[source_].text.view(), token);
    if (!ours.empty()) diagnostic.with_fix(span_of(token), ours);
}

// `i++` and `i--`.
bool Parser::step_operator(const Expr& head) {
    const bool is_sign = token_.kind == TokenKind::plus || token_.kind == TokenKind::minus;
    const bool is_doubled = is_sign && ahead().kind == token_.kind && continues_line() &&
                            ahead().offset == token_.end();
    if (!is_doubled) return false;
    error(
        Code::E0112, lexer_.span(token_.offset, ahead().end()),
        fmt::format("write `{0} = {0} {1} 1`", context_.sources.text(head.span), text_of(token_)));
    return true;
}

// A name with a value behind it and nothing in between.
Item* Parser::misplaced_name(const Token& name) {
    const Token next = ahead();
    const std::string_view text = text_of(name);
    const bool is_block = find_block(text) != nullptr;
    advance();
    const auto habit = std::find_if(kHabits.begin(), kHabits.end(),
                                    [&](const Habit& known) { return known.word == text; });
    if (habit != kHabits.end() && next.kind == TokenKind::identifier) {
        error(Code::E0107, span_of(name), std::string(habit->fix));
        skip_with_lines_below(name);
        return habit->fix == kCondition || habit->fix == kLoop ? nullptr : poisoned(next);
    }
    if (next.kind == TokenKind::identifier && ahead().kind == TokenKind::left_brace && is_block) {
        error(Code::E0107, span_of(next),
              fmt::format("write `let {} = {} {{ ... }}`", text_of(next), text))
            .with_help(fmt::format("or, as a label: `{} \"{}\" {{ ... }}`", text, text_of(next)));
        advance();
        skip_balanced();
        is_panicking_ = false;
        return nullptr;
    }
    if (read_block_without_brace(span_of(name))) return nullptr;
    error(Code::E0107, here(), fmt::format("expected `:` after `{}`", text));
    return nullptr;
}

// The version of an included file stands at its begin, too.
void Parser::misplaced_version() {
    error(Code::E0118, span_of(token_), "`lrs` and a version stand at the very begin of a file");
    skip_line();
    is_panicking_ = false;
}

}  // namespace lray::parser
