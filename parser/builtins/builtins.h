// The built-in functions: one table of names, parameters and what they do.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "base/diagnostics.h"
#include "parser/arena.h"
#include "parser/builtins/parameter_type.h"
#include "parser/values/operators.h"
#include "parser/values/value.h"
#include "scene/scene.h"

namespace lray::parser {

struct Parameter {
    std::string_view name{};
    ParameterType type{};
    bool is_optional = false;
};

inline constexpr std::size_t kMaxParameters = 6;

/// The running program, as far as built-in functions may use it.
class Runtime {
 public:
    virtual ~Runtime() = default;

    /// Calls a function value. Errors: poison, reported.
    virtual Value call_function(const Value& function, std::span<const Value> arguments,
                                Span span) = 0;

    /// Prints one line for the user, without its line end. Errors: E0517 at `span`.
    virtual void print(std::string_view line, Span span) = 0;

    virtual const scene::Scene& scene() const = 0;
    virtual const Symbols& symbols() const = 0;
    virtual Symbol intern(std::string_view name) = 0;
};

/// What a function is called with: arguments that fit its parameters, absent ones as none.
struct Call {
    std::array<Value, kMaxParameters> arguments{};
    std::span<const Value> rest{};       // of a variadic function: what follows its parameters
    std::span<const Span> rest_spans{};  // where they stand
    Span span{};
    Arena& arena;
    Budget& budget;
    Diagnostics& diagnostics;
    Runtime& runtime;
    std::array<Span, kMaxParameters> spans{};  // of the arguments
    std::string_view name{};

    double number(std::size_t i) const { return arguments[i].number; }
    const Value& operator[](std::size_t i) const { return arguments[i]; }
};

struct Builtin {
    std::string_view name{};
    std::array<Parameter, kMaxParameters> parameters{};
    Value (*function)(Call&) = nullptr;
    std::string_view doc{};

    double (*of_number)(double) = nullptr;  // the same for one number, without ceremony
    bool is_variadic = false;               // takes any more arguments, of `rest_type` each
    ParameterType rest_type = ParameterType::any;
    bool has_effects = false;   // prints: a component that calls it is evaluated for each use
    bool is_statement = false;  // is called for what it does, not for its value

    std::size_t parameter_count() const;
    std::size_t required_count() const;
};

/// Functions that belong together, under the heading they have in the reference.
struct BuiltinFamily {
    std::string_view title{};
    std::span<const Builtin> functions{};
};

std::span<const BuiltinFamily> builtin_families();

/// All functions, family by family.
std::span<const Builtin> builtins();

/// Returns how many numbers `range` gives: start + i * step, without the end.
/// Shape: the step is not 0.
double range_count(double start, double end, double step);

/// Index into builtins(); empty if there is none of that name.
std::optional<std::uint32_t> find_builtin(std::string_view name);

/// Checks that the arguments, `rest` included, fit the parameters and calls the function.
/// Errors: poison, reported at the argument (E0301, E0303, E0308) or at the call (E0302, E0503).
/// Poison among the arguments gives poison, in silence.
Value call_builtin(const Builtin& builtin, Call& call);

}  // namespace lray::parser
