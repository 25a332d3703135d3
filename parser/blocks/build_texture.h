// Property values to textures.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/diagnostics.h"
#include "parser/blocks/property_values.h"
#include "parser/file_loader.h"
#include "scene/scene.h"

namespace lray::parser {

/// Adds the texture that the properties describe to the scene. `space_from_texture`, its steps, is
/// invertible.
/// Errors: empty when its picture cannot be read (E06.., E07..), reported at `file`.
std::optional<scene::TextureId> build_texture(const BlockSchema& schema,
                                              const PropertyValues& values,
                                              const std::array<Span, kMaxProperties>& value_spans,
                                              const Transform& space_from_texture, Span span,
                                              FileLoader& files, scene::Scene& scene);

/// Returns the texture that shows the colours of vertices.
scene::Texture vertex_colors();

/// Adds a texture, and works out its average colour.
scene::TextureId add_texture(scene::Texture texture, scene::Scene& scene);

/// Returns the memory that build_texture() takes of the scene, pictures apart.
std::uint64_t texture_size(const PropertyValues& values, const BlockSchema& schema);

}  // namespace lray::parser
