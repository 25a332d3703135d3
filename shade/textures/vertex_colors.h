// The colours of a mesh's vertices as a texture.
#pragma once

#include "base/vec.h"
#include "shade/textures/footprint.h"

namespace lray::shade {

/// What is looked up is the colour itself.
class VertexColors {
 public:
    DVec3 color(const DVec3& p, const Footprint&) const { return p; }
};

}  // namespace lray::shade
