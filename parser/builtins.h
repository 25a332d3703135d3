// The built-in functions: one table of names, parameters and what they do.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "base/diagnostics.h"
#include "parser/arena.h"
#include "parser/operators.h"
#include "parser/value.h"

namespace lray::parser {

enum class ParameterType : std::uint8_t {
    number,
    elements,  // a number, or a vector taken element by element
    vector,    // 2 to 4 numbers
    vec3,
    color,
    transform,
    rows,       // 3 or 4 rows of 4 numbers
    any_scale,  // a number or three
};

struct Parameter {
    std::string_view name{};
    ParameterType type{};
    bool is_optional = false;
};

inline constexpr std::size_t kMaxParameters = 4;

/// What a function is called with: arguments that fit its parameters, absent ones as none.
struct Call {
    std::array<Value, kMaxParameters> arguments{};
    Span span{};
    Arena& arena;
    Budget& budget;
    Diagnostics& diagnostics;
    std::string_view name{};

    double number(std::size_t i) const { return arguments[i].number; }
    const Value& operator[](std::size_t i) const { return arguments[i]; }
};

struct Builtin {
    std::string_view name{};
    std::array<Parameter, kMaxParameters> parameters{};
    Value (*function)(Call&) = nullptr;
    std::string_view doc{};

    std::size_t parameter_count() const;
    std::size_t required_count() const;
};

std::span<const Builtin> builtins();

/// Index into builtins(); empty if there is none of that name.
std::optional<std::uint32_t> find_builtin(std::string_view name);

/// Checks that the arguments fit the parameters and calls the function.
/// Errors: poison, reported at the argument (E0301, E0303) or at the call (E0302, E0503).
/// Poison among the arguments gives poison, in silence.
Value call_builtin(const Builtin& builtin, Call& call, std::span<const Span> argument_spans);

}  // namespace lray::parser
