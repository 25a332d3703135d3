// The parser's short cut for lists of number literals: `[1, 2, 3]` and `[[x, y, z], ...]` become
// packed arrays without a token or a tree node per number.
#include <limits>
#include <utility>

#include "parser/syntax/characters.h"
#include "parser/syntax/number_literal.h"
#include "parser/syntax/packed_numbers.h"
#include "parser/syntax/parser_state.h"

namespace lray::parser {

namespace {

const char* skip_white_space(const char* at) {
    while (is_a(*at, kBlank) || *at == '\n' || *at == '\r') ++at;
    return at;
}

struct Row {
    const char* end = nullptr;  // behind the `]`; null: not a list of number literals
    std::size_t width = 0;
};

// Reads `[n, n, ...]` at `at`.
Row read_row(const char* at, PackedNumbers& numbers) {
    Row row;
    at = skip_white_space(at + 1);
    while (*at != ']') {
        const NumberLiteral literal = read_number_literal(at);
        if (literal.end == nullptr) return {};
        numbers.push(literal.value);
        ++row.width;
        at = skip_white_space(literal.end);
        if (*at == ',') {
            at = skip_white_space(at + 1);
        } else if (*at != ']') {
            return {};
        }
    }
    row.end = at + 1;
    return row;
}

}  // namespace

// Returns null, with nothing consumed, when the list is empty or holds anything else.
Expr* Parser::packed_list() {
    const std::uint32_t begin = token_.offset;
    const char* at = lexer_.begin() + begin;
    const char* const first = skip_white_space(at + 1);
    const bool is_nested = *first == '[';
    PackedNumbers numbers;
    std::size_t width = 1;
    std::size_t count = 0;
    if (is_nested) {
        at = first;
        while (*at != ']') {
            if (*at != '[') return nullptr;
            const Row row = read_row(at, numbers);
            const bool fits = row.width > 0 && (count == 0 || row.width == width);
            if (row.end == nullptr || !fits) return nullptr;
            width = row.width;
            ++count;
            at = skip_white_space(row.end);
            if (*at == ',') {
                at = skip_white_space(at + 1);
            } else if (*at != ']') {
                return nullptr;
            }
        }
        ++at;
    } else {
        const Row row = read_row(at, numbers);
        if (row.end == nullptr || row.width == 0) return nullptr;
        count = row.width;
        at = row.end;
    }
    constexpr std::size_t kMax = std::numeric_limits<std::uint32_t>::max();
    if (count > kMax || width > kMax) return nullptr;

    const auto end = static_cast<std::uint32_t>(at - lexer_.begin());
    PackedListExpr* made = make<PackedListExpr>(ExprKind::packed_list, lexer_.span(begin, end));
    made->is_nested = is_nested;
    made->width = static_cast<std::uint32_t>(width);
    made->count = static_cast<std::uint32_t>(count);
    if (OwnedNumbers owned = numbers.release()) {
        made->values = owned.get();
        context_.long_lists.push_back(std::move(owned));
    } else {
        made->values =
            context_.arena.copy(std::span<const double>(numbers.data(), numbers.size())).data();
    }
    seek(end);
    return made;
}

}  // namespace lray::parser
