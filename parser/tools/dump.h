// The dump: an evaluated scene written as a scene without loops, functions and components.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace lray::parser {

/// Takes text, a piece after the other.
using TextSink = std::function<void(std::string_view)>;

/// Writes a scene that renders to the same bits, in the canonical style; written again after it was
/// read, it is the same text. A node that stands in several places, or is nested deep, is one
/// `let`; equal materials and equal textures are one `let` each. Files are named as from the
/// directory of the original scene.
void dump(const scene::Scene& scene, const TextSink& sink);

/// Likewise, without what is said of pictures: cameras, the settings of renders, the animation and
/// information. What is left is what there is to be seen.
void dump_contents(const scene::Scene& scene, const TextSink& sink);

std::string dump(const scene::Scene& scene);

}  // namespace lray::parser
