// Functions of lists that call a function of the scene for each element.
#pragma once

#include "parser/builtins/builtins.h"

namespace lray::parser {

// map(list, f)
Value map_of(Call& call);

// filter(list, f). Errors: E0301 when f returns neither true nor false.
Value filter_of(Call& call);

// reduce(list, f, start). Errors: E0505 of an empty list without a start.
Value reduce_of(Call& call);

// sort(list, key). Errors: E0301 when there are others than numbers, or strings, to compare.
Value sort_of(Call& call);

}  // namespace lray::parser
