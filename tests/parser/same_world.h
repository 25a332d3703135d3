// Compares flattened worlds to the bit, whatever the numbers of their nodes and materials are.
#pragma once

#include <string>

#include "scene/scene.h"

namespace lray::test {

/// Returns all that is traced and shaded, as bytes in words: equal for worlds that make the same
/// picture. Empty when the scene cannot be flattened.
std::string world_text(const scene::Scene& scene);

}  // namespace lray::test
