// What a picture is of, as names and values: films can be added up, and renders go on, only where
// all of it is the same.
#pragma once

#include "cli/options.h"
#include "cli/view.h"
#include "render/film_file.h"
#include "scene/scene.h"

namespace lray::cli {

/// Returns all that a sample depends on, the version of the program too; nothing that it does not
/// depend on, like threads, hierarchies, and how many samples there are. Of the scene it is what
/// is left when it is evaluated: names and comments do not matter. `files` is the content of
/// what it reads beside scenes.
render::PictureIdentity picture_identity(const scene::Scene& scene, const ContentHash& files,
                                         const View& view, const Options& options);

}  // namespace lray::cli
