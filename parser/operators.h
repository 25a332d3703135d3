// The arithmetic of values.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "parser/arena.h"
#include "parser/token.h"
#include "parser/value.h"

namespace lray::parser {

/// What evaluation may still spend.
struct Budget {
    std::uint64_t steps = 0;        // left
    std::uint64_t value_bytes = 0;  // that the arena may hold
    std::uint64_t max_steps = 0;    // for the message
};

/// Takes one step from the budget. Errors: false, E0512 reported at `span`.
bool take_step(Budget& budget, Span span, Diagnostics& diagnostics);

/// Returns left op right, of arithmetic and comparisons: numbers, vectors element by element with
/// each other or with a number, `+` of strings, `==` and `!=` of everything.
/// Errors: poison, reported at `span`: E0301 types, E0302 lengths, E0503 no finite result, E0512 and
/// E0516 when the budget is spent.
/// Poison stays poison, in silence.
Value apply(TokenKind op, const Value& left, const Value& right, Span span, Arena& arena,
            Budget& budget, Diagnostics& diagnostics);

/// Returns -operand or +operand. Errors as apply().
Value apply_sign(TokenKind op, const Value& operand, Span span, Arena& arena,
                 Diagnostics& diagnostics);

/// True if the values are the same: lists by their elements, blocks by identity. Each comparison
/// of two elements is a step; false when they run out.
bool is_equal(const Value& a, const Value& b, Budget& budget);

/// Returns a list of the elements, packed where they are numbers or rows of numbers.
Value make_list(std::span<const Value> elements, Arena& arena);

/// Element `index` of a list, which it must have.
Value element(const Value& list, std::uint32_t index);

}  // namespace lray::parser
