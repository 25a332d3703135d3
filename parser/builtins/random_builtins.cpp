// Random numbers as functions of the language: of keys, so that the same keys give the same number.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "base/portable_math.h"
#include "parser/builtins/families.h"
#include "parser/builtins/random_key.h"

namespace lray::parser {

namespace {

/// The keys from argument `first` on, and the rest.
KeyedRandom keyed(Call& call, std::size_t first) {
    KeyedRandom random = with_key(call, KeyedRandom{}, call[first]);
    for (const Value& key : call.rest) random = with_key(call, random, key);
    return random;
}

/// Two independent numbers: those of the keys with another key of 0 and of 1.
DVec2 pair_of(KeyedRandom random) {
    return {random.with(0.0).number(), random.with(1.0).number()};
}

/// A whole number from 0 to count - 1; count is whole and at most 2^53, so none is likelier than
/// another by more than count * 2^-53 of it.
double whole_below(KeyedRandom random, double count) {
    return std::min(std::floor(random.number() * count), count - 1.0);
}

Value vector_of(Call& call, std::span<const double> numbers) {
    if (!take_numbers(call.budget, numbers.size(), call.span, call.diagnostics)) {
        return Value::poison();
    }
    return Value::of_numbers(call.arena.copy(numbers));
}

Value rand_of(Call& call) {
    return Value::of(keyed(call, 0).number());
}

Value rand_range_of(Call& call) {
    const double lo = call.number(0);
    const double hi = call.number(1);
    const double t = keyed(call, 2).number();
    const double number = lo + t * (hi - lo);
    // The difference alone may be too large for a number.
    return Value::of(std::isfinite(number) ? number : lo * (1.0 - t) + hi * t);
}

Value rand_int_of(Call& call) {
    constexpr double kMost = 0x1p53;
    const double lo = call.number(0);
    const double hi = call.number(1);
    const auto refuse = [&](std::size_t i, std::string message) {
        call.diagnostics.error(Code::E0304, call.spans[i], std::move(message));
        return Value::poison();
    };
    for (const std::size_t i : {0u, 1u}) {
        if (std::fabs(call.number(i)) <= kMost) continue;
        return refuse(i, fmt::format("`rand_int` goes to 2^53 and no further, this is {}",
                                     format_number(call.number(i))));
    }
    if (lo > hi) {
        return refuse(1, fmt::format("`hi` of `rand_int` is {}, less than `lo`, {}",
                                     format_number(hi), format_number(lo)));
    }
    if (hi - lo >= kMost) return refuse(1, "`rand_int` chooses among at most 2^53 numbers");
    return Value::of(lo + whole_below(keyed(call, 2), hi - lo + 1.0));
}

Value rand_on_sphere_of(Call& call) {
    const DVec2 uv = pair_of(keyed(call, 0));
    const double z = 1.0 - 2.0 * uv.x;
    const DVec2 xy = std::sqrt(std::max(0.0, 1.0 - z * z)) * unit_circle_point(uv.y);
    return vector_of(call, std::array<double, 3>{xy.x, xy.y, z});
}

Value rand_in_disk_of(Call& call) {
    const DVec2 uv = pair_of(keyed(call, 0));
    const DVec2 p = std::sqrt(uv.x) * unit_circle_point(uv.y);
    return vector_of(call, std::array<double, 2>{p.x, p.y});
}

// Source: Box, Muller 1958, "A Note on the Generation of Random Normal Deviates".
Value gauss_of(Call& call) {
    const DVec2 uv = pair_of(keyed(call, 0));
    // 1 - u lies in (0, 1], where the logarithm is finite.
    const double radius = std::sqrt(-2.0 * natural_logarithm(1.0 - uv.x));
    return Value::of(radius * unit_circle_point(uv.y).x);
}

// Source: Durstenfeld 1964, "Algorithm 235: Random permutation" (Fisher-Yates).
Value shuffle_of(Call& call) {
    const Value& list = call[0];
    const KeyedRandom random = keyed(call, 1);
    const std::uint64_t size = std::uint64_t{list.count} * (sizeof(Value) + sizeof(double) * 4);
    if (!take_steps(call.budget, list.count, call.span, call.diagnostics) ||
        !take_bytes(call.budget, size, call.span, call.diagnostics)) {
        return Value::poison();
    }
    std::vector<Value> elements;
    elements.reserve(list.count);
    for (std::uint32_t i = 0; i < list.count; ++i) elements.push_back(element(list, i));
    for (std::uint32_t left = list.count; left > 1; --left) {
        const double chosen = whole_below(random.with(left), left);
        std::swap(elements[left - 1], elements[static_cast<std::size_t>(chosen)]);
    }
    return make_list(elements, call.arena);
}

Value pick_of(Call& call) {
    const Value& list = call[0];
    if (list.count == 0) {
        call.diagnostics.error(Code::E0505, call.spans[0], "`pick` from a list without elements");
        return Value::poison();
    }
    const double chosen = whole_below(keyed(call, 1), list.count);
    return element(list, static_cast<std::uint32_t>(chosen));
}

using enum ParameterType;

constexpr Parameter kSeed{"seed", key};

/// A function that takes any number of keys behind its parameters.
constexpr Builtin keyed_builtin(std::string_view name,
                                std::array<Parameter, kMaxParameters> parameters,
                                Value (*function)(Call&), std::string_view doc) {
    Builtin builtin{name, parameters, function, doc};
    builtin.is_variadic = true;
    builtin.rest_type = key;
    return builtin;
}

// clang-format off
constexpr std::array kRandom = {
    keyed_builtin("rand", {{kSeed}}, rand_of, "a number from 0 to 1, without 1"),
    keyed_builtin("rand_range", {{{"lo", number}, {"hi", number}, kSeed}}, rand_range_of, "a number from lo to hi"),
    keyed_builtin("rand_int", {{{"lo", integer}, {"hi", integer}, kSeed}}, rand_int_of, "a whole number from lo to hi, both included"),
    keyed_builtin("rand_on_sphere", {{kSeed}}, rand_on_sphere_of, "a direction: a point of the unit sphere"),
    keyed_builtin("rand_in_disk", {{kSeed}}, rand_in_disk_of, "two numbers: a point of the unit disk"),
    keyed_builtin("gauss", {{kSeed}}, gauss_of, "a number about 0, normally distributed with deviation 1"),
    keyed_builtin("shuffle", {{{"list", list}, kSeed}}, shuffle_of, "the list in another order"),
    keyed_builtin("pick", {{{"list", list}, kSeed}}, pick_of, "an element of the list"),
};
// clang-format on

}  // namespace

KeyedRandom with_key(Call& call, KeyedRandom random, const Value& key) {
    if (key.is(ValueKind::string)) {
        const bool is_paid = take_text_steps(call.budget, key.count, call.span, call.diagnostics);
        return is_paid ? random.with(key.string()) : random;
    }
    LRAY_ASSERT(key.is(ValueKind::number));
    return random.with(key.number);
}

std::span<const Builtin> random_builtins() {
    return kRandom;
}

}  // namespace lray::parser
