// The families of built-in functions, each in a file of its own.
#pragma once

#include <span>

#include "parser/builtins/builtins.h"

namespace lray::parser {

std::span<const Builtin> animation_builtins();
std::span<const Builtin> color_builtins();
std::span<const Builtin> geometry_builtins();
std::span<const Builtin> list_builtins();
std::span<const Builtin> message_builtins();
std::span<const Builtin> noise_builtins();
std::span<const Builtin> number_builtins();
std::span<const Builtin> random_builtins();
std::span<const Builtin> string_builtins();
std::span<const Builtin> transform_builtins();
std::span<const Builtin> vector_builtins();

}  // namespace lray::parser
