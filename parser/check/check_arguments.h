// The rules of what a function is called with.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "parser/arena.h"
#include "parser/builtins/builtins.h"
#include "parser/symbols.h"
#include "parser/syntax/ast.h"

namespace lray::parser {

/// What a function takes, built in or not.
struct Signature {
    struct Parameter {
        std::string_view name{};
        bool is_required = false;
    };

    std::string_view name{};
    std::vector<Parameter> parameters{};
    bool is_variadic = false;
};

/// The place of an argument behind all parameters, of a variadic function.
inline constexpr std::uint8_t kRestPlace = 255;

/// The most parameters a function can have.
inline constexpr std::size_t kMaxFunctionParameters = 64;

Signature signature_of(const Builtin& builtin);
Signature signature_of(const Function& function, const Symbols& symbols);

/// Returns the parameter that each argument stands for.
/// Errors: empty, reported at the argument or call (E0305, E0306). What the arguments are is seen
/// when they are evaluated.
std::span<const std::uint8_t> check_arguments(const CallExpr& expr, const Signature& signature,
                                              const Symbols& symbols, Arena& arena,
                                              Diagnostics& diagnostics);

}  // namespace lray::parser
