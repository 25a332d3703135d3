// Property values to lights.
#pragma once

#include <array>
#include <optional>

#include "base/diagnostics.h"
#include "parser/blocks/build_shape.h"
#include "parser/blocks/property_values.h"
#include "parser/file_loader.h"
#include "scene/scene.h"

namespace lray::parser {

/// Adds the light that the properties describe to the scene.
/// Errors: empty when it has no direction (E0311), no area (E0304), or its picture cannot be read
/// (E06.., E07..), reported at the property or the block.
std::optional<ShapeRef> build_light(const BlockSchema& schema, const PropertyValues& values,
                                    const std::array<Span, kMaxProperties>& value_spans, Span span,
                                    FileLoader& files, scene::Scene& scene,
                                    Diagnostics& diagnostics);

}  // namespace lray::parser
