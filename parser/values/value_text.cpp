#include "parser/values/value_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "base/assert.h"
#include "parser/builtins/builtins.h"
#include "parser/syntax/ast.h"
#include "parser/values/operators.h"

namespace lray::parser {

namespace {

/// Writes text, or counts what would be written. Full, it takes no more.
class Writer {
 public:
    Writer(char* out, std::uint64_t limit) : out_(out), limit_(limit) {}

    std::uint64_t size() const { return size_; }
    bool is_full() const { return is_full_; }

    void add(std::string_view text) {
        const auto room =
            static_cast<std::size_t>(std::min<std::uint64_t>(limit_ - size_, text.size()));
        if (out_ != nullptr) std::copy_n(text.data(), room, out_ + size_);
        size_ += room;
        is_full_ = is_full_ || room < text.size();
    }

 private:
    char* out_ = nullptr;
    std::uint64_t limit_ = 0;
    std::uint64_t size_ = 0;
    bool is_full_ = false;
};

void add_number(double number, Writer& writer) {
    fmt::memory_buffer digits;
    fmt::format_to(std::back_inserter(digits), "{}", number);
    writer.add({digits.data(), digits.size()});
}

void add_numbers(std::span<const double> numbers, Writer& writer) {
    for (std::size_t i = 0; i < numbers.size() && !writer.is_full(); ++i) {
        if (i > 0) writer.add(", ");
        add_number(numbers[i], writer);
    }
}

/// As it would be written in a scene.
void add_quoted(std::string_view text, Writer& writer) {
    writer.add("\"");
    for (std::size_t i = 0; i < text.size() && !writer.is_full(); ++i) {
        const char c = text[i];
        if (c == '"' || c == '\\') writer.add("\\");
        if (c == '\n') {
            writer.add("\\n");
        } else if (c == '\t') {
            writer.add("\\t");
        } else {
            writer.add({&c, 1});
        }
    }
    writer.add("\"");
}

void add_transform(const Transform& transform, Writer& writer) {
    writer.add("matrix([");
    for (int row = 0; row < 3; ++row) {
        const DMat3& linear = transform.linear();
        const double numbers[] = {linear[0][row], linear[1][row], linear[2][row],
                                  transform.offset()[row]};
        writer.add(row == 0 ? "[" : ", [");
        add_numbers(numbers, writer);
        writer.add("]");
    }
    writer.add("])");
}

void add_function(const FunctionValue& value, const Symbols& symbols, Writer& writer) {
    std::string_view name;
    if (value.function == nullptr) {
        name = builtins()[value.builtin].name;
    } else if (value.function->name != kNoSymbol) {
        name = symbols.text(value.function->name);
    }
    writer.add(name.empty() ? "fn" : "fn ");
    writer.add(name);
}

// NOLINTNEXTLINE(misc-no-recursion): values nest kMaxValueDepth deep at most
void add_value(const Value& value, const Symbols& symbols, bool is_inside, Writer& writer) {
    switch (value.kind) {
        case ValueKind::number:
            return add_number(value.number, writer);
        case ValueKind::boolean:
            return writer.add(value.boolean ? "true" : "false");
        case ValueKind::string:
            return is_inside ? add_quoted(value.string(), writer) : writer.add(value.string());
        case ValueKind::numbers:
            writer.add("[");
            add_numbers({value.numbers, value.count}, writer);
            return writer.add("]");
        case ValueKind::rows:
        case ValueKind::list:
            writer.add("[");
            for (std::uint32_t i = 0; i < value.count && !writer.is_full(); ++i) {
                if (i > 0) writer.add(", ");
                add_value(element(value, i), symbols, true, writer);
            }
            return writer.add("]");
        case ValueKind::color:
            writer.add("rgb(");
            add_numbers({value.numbers, 3}, writer);
            return writer.add(")");
        case ValueKind::transform:
            return add_transform(*value.transform, writer);
        case ValueKind::record:
            writer.add("record {");
            for (std::uint32_t i = 0; i < value.count && !writer.is_full(); ++i) {
                writer.add(i == 0 ? " " : ", ");
                writer.add(symbols.text(value.fields[i].name));
                writer.add(": ");
                add_value(value.fields[i].value, symbols, true, writer);
            }
            return writer.add(" }");
        case ValueKind::function:
            return add_function(*value.function, symbols, writer);
        case ValueKind::none:
        case ValueKind::poison:
        case ValueKind::texture:
        case ValueKind::material:
        case ValueKind::node:
            return writer.add(describe(value));
    }
    LRAY_ASSERT(false);
}

}  // namespace

std::optional<std::uint64_t> text_size(const Value& value, const Symbols& symbols,
                                       std::uint64_t limit) {
    Writer writer(nullptr, limit);
    add_value(value, symbols, false, writer);
    if (writer.is_full()) return std::nullopt;
    return writer.size();
}

char* write_text(const Value& value, const Symbols& symbols, char* out) {
    Writer writer(out, std::numeric_limits<std::uint64_t>::max());
    add_value(value, symbols, false, writer);
    return out + writer.size();
}

std::string value_text(const Value& value, const Symbols& symbols, std::size_t limit) {
    constexpr std::string_view kCut = "...";
    LRAY_ASSERT(limit >= kCut.size());
    const std::optional<std::uint64_t> size = text_size(value, symbols, limit);
    std::string text(size.value_or(limit), '\0');
    Writer writer(text.data(), text.size());
    add_value(value, symbols, false, writer);
    if (size) return text;
    std::size_t end = text.size() - kCut.size();
    const auto continues = [&](std::size_t at) { return (text[at] & 0xc0) == 0x80; };  // UTF-8
    while (end > 0 && continues(end)) --end;
    text.replace(end, std::string::npos, kCut);
    return text;
}

}  // namespace lray::parser
