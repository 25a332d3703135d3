// The words for what stands in a text file where a number belongs.
#pragma once

#include <string>
#include <string_view>

namespace lray::scene {

/// Returns a token in quotes, cut where it is too long for a message.
std::string quoted_token(std::string_view token);

/// Returns what is wrong with a token that is not a finite number a float holds: "expected a
/// number, found `2,5`; decimals are written with a point".
/// Shape: the token is part of a Text.
std::string wrong_number_text(std::string_view token);

}  // namespace lray::scene
