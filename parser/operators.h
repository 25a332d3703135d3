// The arithmetic of values.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "parser/arena.h"
#include "parser/token.h"
#include "parser/value.h"

namespace lray::parser {

/// Returns left op right, of arithmetic and comparisons: numbers, vectors element by element with
/// each other or with a number, `+` of strings, `==` and `!=` of everything.
/// Errors: poison, reported at `span`: E0301 types, E0302 lengths, E0503 no finite result.
/// Poison stays poison, in silence.
Value apply(TokenKind op, const Value& left, const Value& right, Span span, Arena& arena,
            Diagnostics& diagnostics);

/// Returns -operand or +operand. Errors as apply().
Value apply_sign(TokenKind op, const Value& operand, Span span, Arena& arena,
                 Diagnostics& diagnostics);

/// True if the values are the same: lists by their elements, blocks by identity.
bool is_equal(const Value& a, const Value& b);

/// Returns a list of the elements, packed where they are numbers or rows of numbers.
Value make_list(std::span<const Value> elements, Arena& arena);

/// Element `index` of a list, which it must have.
Value element(const Value& list, std::uint32_t index);

}  // namespace lray::parser
