// Property values to materials.
#pragma once

#include <span>

#include "base/diagnostics.h"
#include "parser/blocks/property_values.h"
#include "scene/material.h"
#include "scene/texture.h"

namespace lray::parser {

/// Returns the material that the properties describe; `textures` are those of the scene.
/// Warns W1402 of more than all light given back, W1404 of an index of refraction below 1.
scene::Material build_material(const PropertyValues& values,
                               std::span<const scene::Texture> textures, Span span,
                               Diagnostics& diagnostics);

}  // namespace lray::parser
