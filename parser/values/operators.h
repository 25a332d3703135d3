// The arithmetic of values.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "base/diagnostics.h"
#include "parser/arena.h"
#include "parser/syntax/token.h"
#include "parser/values/value.h"

namespace lray::parser {

/// What evaluation may still spend. Spent once, it stays spent: nothing more is evaluated, and
/// nothing more is said.
struct Budget {
    std::uint64_t steps = 0;            // left
    std::uint64_t value_bytes = 0;      // left; what is given back counts again
    std::uint64_t max_steps = 0;        // for the messages
    std::uint64_t max_value_bytes = 0;  // likewise
    std::uint64_t max_list_size = 0;    // elements of one list
    std::uint64_t kept_bytes = 0;       // taken for good
    bool is_spent = false;

    void spend() {
        steps = 0;
        is_spent = true;
    }
};

/// Takes steps from the budget. Errors: false, E0512 reported at `span`.
bool take_steps(Budget& budget, std::uint64_t count, Span span, Diagnostics& diagnostics);

/// Takes memory for something computed. Errors: false, E0516 reported at `span`.
bool take_bytes(Budget& budget, std::uint64_t size, Span span, Diagnostics& diagnostics);

/// Takes memory for something that stays to the end of the run. Errors as take_bytes().
bool take_kept_bytes(Budget& budget, std::uint64_t size, Span span, Diagnostics& diagnostics);

/// Takes what making `count` numbers costs: memory, and a step each beyond the first few.
bool take_numbers(Budget& budget, std::uint64_t count, Span span, Diagnostics& diagnostics);

/// True if a list may have so many elements. Errors: false, E0514 reported at `span`.
/// Shape: any number that is not NaN; it need not be representable as an integer.
bool may_have_elements(const Budget& budget, double count, Span span, Diagnostics& diagnostics);

/// Takes what reading or writing `size` bytes of text costs: a step for every few.
bool take_text_steps(Budget& budget, std::uint64_t size, Span span, Diagnostics& diagnostics);

/// Returns left op right, of arithmetic and comparisons: numbers, vectors element by element with
/// each other or with a number, `+` of strings, `==` and `!=` of everything.
/// Errors: poison, reported at `span`: E0301 types, E0302 lengths, E0503 no finite result, E0512
/// and E0516 when the budget is spent. Poison stays poison, in silence.
Value apply(TokenKind op, const Value& left, const Value& right, Span span, Arena& arena,
            Budget& budget, Diagnostics& diagnostics);

/// Returns -operand or +operand. Errors as apply().
Value apply_sign(TokenKind op, const Value& operand, Span span, Arena& arena, Budget& budget,
                 Diagnostics& diagnostics);

/// True if the values are the same: lists by their elements, records by their fields in order,
/// functions by what they capture, blocks by identity. Each comparison of two elements is a step.
/// Errors: empty, E0512 reported at `span`.
std::optional<bool> is_equal(const Value& a, const Value& b, Span span, Budget& budget,
                             Diagnostics& diagnostics);

/// Returns a list of the elements, packed where they are numbers or rows of numbers. Poison among
/// them gives poison. For lists that are bounded by the text they stand in.
Value make_list(std::span<const Value> elements, Arena& arena);

/// The same for lists that are computed: what they cost is taken from the budget first.
/// Errors: poison; E0514 reported at `span` when there are too many elements or they nest too deep,
/// E0512 and E0516 when the budget is spent.
Value make_list(std::span<const Value> elements, Span span, Arena& arena, Budget& budget,
                Diagnostics& diagnostics);

/// Returns a list of numbers; of none it is the empty list.
/// Shape: the numbers live as long as the value.
Value list_of_numbers(std::span<const double> numbers);

/// Returns how deep a list or record of these would nest.
std::uint8_t depth_around(std::span<const Value> elements);

/// Element `index` of a list, which it must have.
Value element(const Value& list, std::uint32_t index);

}  // namespace lray::parser
