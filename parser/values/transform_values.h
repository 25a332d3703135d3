// Values to transforms: the steps of a block, and the built-in functions that make transforms.
#pragma once

#include "base/transform.h"
#include "parser/blocks/schema.h"
#include "parser/values/value.h"

namespace lray::parser {

/// Shape: a number or three numbers.
Transform scaling_of(const Value& value);

/// Shape: 3 or 4 rows of 4 numbers, written row by row; a fourth row is [0, 0, 0, 1].
Transform matrix_of(const Value& rows);

/// Returns `before` followed by a step of a block, which has the step's type.
Transform with_step(const Transform& before, CommonProperty step, const Value& value);

}  // namespace lray::parser
