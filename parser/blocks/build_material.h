// Property values to materials.
#pragma once

#include "base/diagnostics.h"
#include "parser/blocks/property_values.h"
#include "scene/material.h"

namespace lray::parser {

/// Returns the material that the properties describe.
/// Warns W1402 of more than all light given back, W1404 of an index of refraction below 1.
scene::Material build_material(const PropertyValues& values, Span span, Diagnostics& diagnostics);

}  // namespace lray::parser
