// The names every scene knows without defining them: constants and colours.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "parser/values/value.h"

namespace lray::parser {

struct Constant {
    std::string_view name{};
    Value value{};
};

/// `pi` and the colour names of CSS, in linear RGB.
std::span<const Constant> prelude_constants();

/// Index into prelude_constants(); empty if there is none of that name.
std::optional<std::uint32_t> find_constant(std::string_view name);

}  // namespace lray::parser
