// The parser's short cut for blocks of literals, `sphere { center: [0, 1, 0], radius: 2 }`: they
// become nodes of the scene at once and leave no tree behind, but for the name of a material, which
// means nothing yet. Whatever is not plain, or not right, is left to the full parser and its
// messages.
#include "parser/syntax/literal_block.h"

#include <array>
#include <cstring>
#include <string_view>

#include "parser/blocks/build_shape.h"
#include "parser/blocks/property_type.h"
#include "parser/blocks/schema.h"
#include "parser/blocks/schemas.h"
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

constexpr std::string_view kMaterialName =
    schemas::kCommon[static_cast<std::size_t>(CommonProperty::material)].name;

/// How many numbers a literal of this type has; 0 for types that are not taken here.
constexpr std::size_t literal_width(PropertyType type) {
    using enum PropertyType;
    if (type == number) return 1;
    if (type == size2) return 2;
    return type == point || type == direction || type == size3 ? 3 : 0;
}

std::string_view read_name(const char* at) {
    const char* end = at;
    while (is_a(*end, kLetter | kDigit)) ++end;
    return {at, static_cast<std::size_t>(end - at)};
}

/// Reads `n` or `[n, n, n]` on one line; null when it is anything else.
const char* read_numbers(const char* at, std::size_t width, double* numbers) {
    const bool is_list = width > 1;
    if (is_list) {
        if (*at != '[') return nullptr;
        at = skip_blanks(at + 1);
    }
    for (std::size_t i = 0;;) {
        // One call for both forms: it is inlined then.
        const NumberLiteral literal = read_number_literal(at);
        if (literal.end == nullptr) return nullptr;
        numbers[i] = literal.value;
        if (!is_list) return literal.end;
        at = skip_blanks(literal.end);
        ++i;
        if (*at != (i < width ? ',' : ']')) return nullptr;
        if (i == width) return at + 1;
        at = skip_blanks(at + 1);
    }
}

/// A literal that was read.
struct Literal {
    Value value{};
    const char* end = nullptr;  // null: not a literal of the wanted type
};

/// Shape: `numbers` holds those of the value.
Literal read_literal(const char* at, PropertyType type, std::array<double, 3>& numbers) {
    if (type == PropertyType::boolean) {
        const std::string_view word = read_name(at);
        if (word != "true" && word != "false") return {};
        return {Value::of(word == "true"), word.data() + word.size()};
    }
    const std::size_t width = literal_width(type);
    if (width == 0) return {};
    const char* const end = read_numbers(at, width, numbers.data());
    if (width == 1) return {Value::of(numbers[0]), end};
    return {Value::of_numbers({numbers.data(), width}), end};
}

}  // namespace

Span material_name(Span block, const Sources& sources) {
    // Nothing else in such a block has these letters in it.
    const std::string_view text = sources.text(block);
    const std::size_t colon = text.find(':', text.find(kMaterialName));
    const std::size_t begin = text.find_first_not_of(" \t", colon + 1);
    const std::size_t size = read_name(text.data() + begin).size();
    return Span::make(block.source, block.offset + begin, block.offset + begin + size);
}

// Returns nothing, with nothing consumed, when the block is not one of literals.
std::optional<LiteralBlock> Parser::literal_block(const Token& name) {
    const BlockSchema* const schema = find_block(name.symbol);
    const bool is_shape =
        schema != nullptr && schema->kind >= BlockKind::sphere && schema->kind <= BlockKind::torus;
    constexpr std::uint32_t kLevels = 3;  // in the full parser: a block, a value, a sign
    if (!is_shape || nesting_ + kLevels > context_.max_nesting) return std::nullopt;
    const char* at = skip_blanks(lexer_.begin() + name.end());
    if (*at != '{') return std::nullopt;

    const std::span<const PropertySchema> properties = schema->properties;
    PropertyValues values(properties);
    std::array<std::array<double, 3>, kMaxProperties> numbers;  // written before they are read
    LiteralBlock block;
    bool is_separated = true;
    for (++at;;) {
        const Separated next = skip_separators(at);
        is_separated = is_separated || next.is_separated;
        at = next.at;
        if (*at == '}') break;
        if (!is_separated) return std::nullopt;
        const std::string_view key = read_name(at);
        at = skip_blanks(at + key.size());
        if (*at != ':') return std::nullopt;
        at = skip_blanks(at + 1);
        const std::size_t slot = find_property(properties, key);
        if (slot < properties.size()) {
            if (values.has(slot)) return std::nullopt;
            const PropertySchema& property = properties[slot];
            const Literal literal = read_literal(at, property.type, numbers[slot]);
            if (literal.end == nullptr || !is_in_range(property, literal.value)) {
                return std::nullopt;
            }
            values.set(slot, literal.value);
            at = literal.end;
        } else if (key == kMaterialName && block.material == kNoSymbol) {
            const std::string_view material = read_name(at);
            if (!is_a(*at, kLetter)) return std::nullopt;
            block.material = context_.symbols.intern(material);
            const bool is_reserved = block.material < kKeywords.size();
            if (is_reserved || find_block(block.material) != nullptr) return std::nullopt;
            const auto begin = static_cast<std::uint32_t>(at - lexer_.begin());
            block.material_span =
                lexer_.span(begin, begin + static_cast<std::uint32_t>(material.size()));
            at += material.size();
        } else {
            return std::nullopt;
        }
        is_separated = false;
    }
    if (!is_complete(properties, values) || may_go_on(at + 1)) return std::nullopt;

    const auto end = static_cast<std::uint32_t>(at + 1 - lexer_.begin());
    if (end - name.offset > Span::kMaxLength) return std::nullopt;  // see material_name()
    const Span span = lexer_.span(name.offset, end);
    const std::optional<ShapeRef> shape =
        build_shape(*schema, values, span, context_.scene, literal_problems_);
    if (literal_problems_.error_count() + literal_problems_.warning_count() > 0) {
        literal_problems_ = Diagnostics{};
        return std::nullopt;
    }
    scene::Node made;
    made.kind = shape->kind;
    made.index = shape->index;
    made.span = span;
    block.node_id = scene::NodeId(context_.scene.nodes.size());
    context_.scene.nodes.push_back(made);
    seek(end);
    return block;
}

}  // namespace lray::parser
