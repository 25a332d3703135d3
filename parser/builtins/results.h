// What built-in functions return, and how they say that they cannot.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "parser/builtins/builtins.h"

namespace lray::parser {

/// Returns poison; E0503 reported at the call.
Value no_value(Call& call, std::string message);

/// Returns the number; if it is not finite, poison, E0503 reported with the call's arguments.
Value finite(Call& call, double result);

/// Returns the numbers as a list; they are in the arena already. Errors: as finite().
Value finite(Call& call, std::span<const double> numbers);

/// Returns three numbers. Errors: as finite().
Value of_vec3(Call& call, DVec3 v);

/// Returns an opaque colour, linear. Errors: as finite().
Value of_rgb(Call& call, double r, double g, double b);

Value of_transform(Call& call, const Transform& transform);

/// Returns poison; E0302 reported at the call.
Value lengths_differ(Call& call, std::size_t a, std::size_t b);

/// Returns poison; E0505 reported at an argument: "`pick` needs a list with elements".
Value nothing_in_list(Call& call, std::size_t argument);

/// Returns room for so many numbers in the arena, for a list; null when it may not be that long
/// or the budget is spent, reported.
double* take_list_of_numbers(Call& call, double count);

/// Returns a list of the elements. Errors: as make_list().
Value list_of(Call& call, std::span<const Value> elements);

/// Takes steps. Errors: false, reported at the call.
bool take_steps(Call& call, std::uint64_t count);

inline std::span<const double> numbers_of(const Value& value) {
    return {value.numbers, value.is(ValueKind::numbers) ? value.count : 0};
}

/// Returns a at t = 0 and b at t = 1, exactly; further on, beyond them.
inline double lerp(double a, double b, double t) {
    return t == 1.0 ? b : a + (b - a) * t;
}

}  // namespace lray::parser
