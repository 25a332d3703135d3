#include "gui/overlay_painter.h"

#include <GL/freeglut.h>

#include <variant>

namespace lray::gui {

namespace {

void use_window_pixels(scene::Resolution window) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0.0, window.width, window.height, 0.0, -1.0, 1.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

void use_color(Rgba color) {
    glColor4f(color.r, color.g, color.b, color.a);
}

void paint_mark(const OverlayBox& mark) {
    use_color(mark.color);
    glBegin(GL_QUADS);
    glVertex2d(mark.box.left, mark.box.top);
    glVertex2d(mark.box.left, mark.box.bottom);
    glVertex2d(mark.box.right, mark.box.bottom);
    glVertex2d(mark.box.right, mark.box.top);
    glEnd();
}

void paint_mark(const OverlayText& mark) {
    use_color(mark.color);
    glRasterPos2d(mark.at.x, mark.at.y + kOverlayFont.ascent);
    for (const char c : mark.text) {
        glutBitmapCharacter(GLUT_BITMAP_8_BY_13, static_cast<unsigned char>(c));
    }
}

}  // namespace

void paint(const Overlay& overlay, scene::Resolution window) {
    use_window_pixels(window);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glBegin(GL_LINES);
    for (const OverlayLine& line : overlay.lines) {
        use_color(line.color);
        glVertex2d(line.from.x, line.from.y);
        glVertex2d(line.to.x, line.to.y);
    }
    glEnd();
    for (const auto& mark : overlay.marks) {
        std::visit([](const auto& any) { paint_mark(any); }, mark);
    }
    glDisable(GL_BLEND);
}

}  // namespace lray::gui
