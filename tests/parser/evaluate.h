// Evaluates single expressions, seen through what they do to a scene.
#pragma once

#include <string>
#include <string_view>

#include "base/vec.h"

namespace lray::test {

/// The value of an expression of numbers, after some definitions. NaN, with a failure recorded, if
/// the scene has an error.
double number_of(std::string_view expression, std::string_view before = {});
DVec3 vec3_of(std::string_view expression, std::string_view before = {});
bool is_true(std::string_view condition, std::string_view before = {});
std::string string_of(std::string_view expression, std::string_view before = {});

/// As a material's colour: linear.
Color color_of(std::string_view expression, std::string_view before = {});

/// The codes that a scene raises, those that only say what is missing from it left out.
std::string codes_of(std::string_view scene);

}  // namespace lray::test
