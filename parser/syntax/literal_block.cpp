// The parser's short cut for blocks of literals, `sphere { center: [0, 1, 0], radius: 2 }`: they
// become nodes of the scene at once and leave no tree behind. Whatever is not plain, or not right,
// is left to the full parser and its messages.
#include <array>
#include <cstring>
#include <string_view>

#include "parser/blocks/build_shape.h"
#include "parser/blocks/property_type.h"
#include "parser/blocks/schema.h"
#include "parser/syntax/characters.h"
#include "parser/syntax/number_literal.h"
#include "parser/syntax/parser_state.h"

namespace lray::parser {

namespace {

const char* skip_blanks(const char* at) {
    while (is_a(*at, kBlank)) ++at;
    return at;
}

struct Separated {
    const char* at = nullptr;
    bool is_separated = false;
};

Separated skip_separators(const char* at) {
    bool is_separated = false;
    for (;; ++at) {
        if (*at == '\n' || *at == '\r' || *at == ',' || *at == ';') {
            is_separated = true;
        } else if (!is_a(*at, kBlank)) {
            return {at, is_separated};
        }
    }
}

/// True if what stands behind a `}` on its line may belong to the same item, `sphere { }{ }`: the
/// full parser tells.
bool may_go_on(const char* at) {
    constexpr std::string_view kBegins = "{[(.\"";
    at = skip_blanks(at);
    return kBegins.find(*at) != std::string_view::npos || (at[0] == '/' && at[1] == '*');
}

/// How many numbers a literal of this type has; 0 for types that are not taken here.
constexpr std::size_t literal_width(PropertyType type) {
    using enum PropertyType;
    if (type == number) return 1;
    if (type == size2) return 2;
    return type == point || type == direction || type == size3 ? 3 : 0;
}

/// Reads `n` or `[n, n, n]` on one line; null when it is anything else.
const char* read_numbers(const char* at, std::size_t width, double* numbers) {
    if (width == 1) {
        const NumberLiteral literal = read_number_literal(at);
        *numbers = literal.value;
        return literal.end;
    }
    if (*at != '[') return nullptr;
    ++at;
    for (std::size_t i = 0; i < width; ++i) {
        const NumberLiteral literal = read_number_literal(skip_blanks(at));
        if (literal.end == nullptr) return nullptr;
        numbers[i] = literal.value;
        at = skip_blanks(literal.end);
        if (*at != (i + 1 < width ? ',' : ']')) return nullptr;
        ++at;
    }
    return at;
}

}  // namespace

// Returns false, with nothing consumed, when the block is not one of literals.
bool Parser::literal_block(const Token& name, scene::NodeId& node) {
    const BlockSchema* const schema = find_block(name.symbol);
    const bool is_shape =
        schema != nullptr && schema->kind >= BlockKind::sphere && schema->kind <= BlockKind::torus;
    if (!is_shape) return false;
    const char* at = skip_blanks(lexer_.begin() + name.end());
    if (*at != '{') return false;

    const std::span<const PropertySchema> properties = schema->properties;
    PropertyValues values(properties);
    std::array<std::array<double, 3>, kMaxProperties> numbers;  // written before they are read
    bool is_separated = true;
    for (++at;;) {
        const Separated next = skip_separators(at);
        is_separated = is_separated || next.is_separated;
        at = next.at;
        if (*at == '}') break;
        if (!is_separated) return false;
        const char* name_end = at;
        while (is_a(*name_end, kLetter | kDigit)) ++name_end;
        const std::string_view key(at, static_cast<std::size_t>(name_end - at));
        const std::size_t slot = find_property(properties, key);
        if (slot == properties.size() || values.has(slot)) return false;
        const PropertySchema& property = properties[slot];
        const std::size_t width = literal_width(property.type);
        at = skip_blanks(name_end);
        if (*at != ':' || width == 0) return false;
        at = read_numbers(skip_blanks(at + 1), width, numbers[slot].data());
        if (at == nullptr) return false;
        const Value value = width == 1 ? Value::of(numbers[slot][0])
                                       : Value::of_numbers({numbers[slot].data(), width});
        if (!is_in_range(property, value)) return false;
        values.set(slot, value);
        is_separated = false;
    }
    if (!is_complete(properties, values) || may_go_on(at + 1)) return false;

    const Span span = lexer_.span(name.offset, static_cast<std::uint32_t>(at + 1 - lexer_.begin()));
    const std::optional<ShapeRef> shape =
        build_shape(*schema, values, span, context_.scene, literal_problems_);
    if (literal_problems_.error_count() + literal_problems_.warning_count() > 0) {
        literal_problems_ = Diagnostics{};
        return false;
    }
    scene::Node made;
    made.kind = shape->kind;
    made.index = shape->index;
    made.span = span;
    node = scene::NodeId(context_.scene.nodes.size());
    context_.scene.nodes.push_back(made);
    seek(span.offset + static_cast<std::uint32_t>(at + 1 - (lexer_.begin() + span.offset)));
    return true;
}

}  // namespace lray::parser
