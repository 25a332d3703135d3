// Draws overlays by OpenGL.
#pragma once

#include "gui/overlay.h"
#include "scene/camera.h"

namespace lray::gui {

/// GLUT's font of 8 by 13 pixels, which every overlay is drawn in.
inline constexpr Font kOverlayFont{.width = 8, .height = 13, .ascent = 11};

/// Draws over what the current context shows, in a window of that size.
void paint(const Overlay& overlay, scene::Resolution window);

}  // namespace lray::gui
