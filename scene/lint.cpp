#include "scene/lint.h"

#include "scene/lit.h"
#include "scene/warn_coincident.h"
#include "scene/warn_enclosed.h"
#include "scene/warn_mirrored.h"
#include "scene/warn_view.h"

namespace lray::scene {

void lint(const Scene& scene, const World& world, const LintSettings& settings,
          Diagnostics& diagnostics) {
    warn_enclosed(scene, world, diagnostics);
    warn_view(scene, world, settings.resolution, diagnostics);
    warn_coincident(scene, world, diagnostics);
    if (settings.expects_light) warn_unlit(scene, world, diagnostics);
    if (diagnostics.tells(Code::W1303)) warn_mirrored(scene, diagnostics);
}

}  // namespace lray::scene
