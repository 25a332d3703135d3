// Stops of a gradient: pairs of a place and a colour, as values and as the scene holds them.
#pragma once

#include <optional>
#include <vector>

#include "parser/values/value.h"
#include "scene/texture.h"

namespace lray::parser {

/// A list of stops is copied into every texture that is made with it: its size is bounded.
inline constexpr std::uint32_t kMaxStops = 256;

/// Returns the stop that a value is: [place, colour], [place, grey] or [place, [r, g, b]].
std::optional<scene::ColorStop> read_stop(const Value& value);

/// Shape: a list that fits a property of the type `stops`.
std::vector<scene::ColorStop> read_stops(const Value& stops);

}  // namespace lray::parser
