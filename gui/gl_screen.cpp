#include "gui/gl_screen.h"

// The loader comes before any other header of OpenGL.
#include <GL/glew.h>

#include <chrono>
#include <cstring>

#include "base/assert.h"

namespace lray::gui {

namespace {

constexpr std::size_t kBytesPerPixel = 4;

void use_window_corners() {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

void forget_errors() {
    while (glGetError() != GL_NO_ERROR) {
    }
}

}  // namespace

GlScreen::GlScreen()
    : has_textures_(GLEW_VERSION_2_0 || GLEW_ARB_texture_non_power_of_two),
      has_buffers_(GLEW_VERSION_2_1) {
    if (has_textures_) glGenTextures(1, &texture_);
    if (has_buffers_) glGenBuffers(1, &buffer_);
}

GlScreen::~GlScreen() {
    if (has_textures_) glDeleteTextures(1, &texture_);
    if (has_buffers_) glDeleteBuffers(1, &buffer_);
}

void GlScreen::set_size(scene::Resolution size) {
    size_ = size;
    fits_ = false;
    if (!has_textures_) return;
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const auto limit = static_cast<std::uint32_t>(largest > 0 ? largest : 0);
    if (size.width > limit || size.height > limit) return;
    forget_errors();
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, static_cast<GLsizei>(size.width),
                 static_cast<GLsizei>(size.height), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    fits_ = glGetError() == GL_NO_ERROR;
}

void GlScreen::upload(const render::Frame& frame, render::RowRange rows) {
    const auto begin = std::chrono::steady_clock::now();
    if (size_ != frame.resolution) {
        set_size(frame.resolution);
        rows = {0, frame.resolution.height};
    }
    LRAY_ASSERT(rows.end <= size_.height);
    if (!fits_) return;  // drawn from memory each time
    const std::size_t row_bytes = std::size_t{size_.width} * kBytesPerPixel;
    const std::size_t bytes = row_bytes * (rows.end - rows.begin);
    const void* source = frame.bytes.data() + row_bytes * rows.begin;
    void* mapped = nullptr;
    if (has_buffers_) {
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer_);
        glBufferData(GL_PIXEL_UNPACK_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr,
                     GL_STREAM_DRAW);
        mapped = glMapBuffer(GL_PIXEL_UNPACK_BUFFER, GL_WRITE_ONLY);
        if (mapped != nullptr) {
            std::memcpy(mapped, source, bytes);
            if (glUnmapBuffer(GL_PIXEL_UNPACK_BUFFER) != GL_TRUE) mapped = nullptr;
        }
        if (mapped == nullptr) glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    }
    glBindTexture(GL_TEXTURE_2D, texture_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(rows.begin),
                    static_cast<GLsizei>(size_.width), static_cast<GLsizei>(rows.end - rows.begin),
                    GL_RGBA, GL_UNSIGNED_BYTE, mapped != nullptr ? nullptr : source);
    if (has_buffers_) glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    ++counts_.frames;
    counts_.seconds += passed.count();
}

void GlScreen::draw(const render::Frame& frame, scene::Resolution window) const {
    glViewport(0, 0, static_cast<GLsizei>(window.width), static_cast<GLsizei>(window.height));
    if (frame.bytes.empty()) {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        return;
    }
    use_window_corners();
    if (!fits_) {
        draw_pixels(frame, window);
        return;
    }
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, texture_);
    const GLint filter = window == size_ ? GL_NEAREST : GL_LINEAR;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glColor4f(1.0f, 1.0f, 1.0f, 1.0f);
    glBegin(GL_QUADS);  // row 0 is on top
    glTexCoord2f(0.0f, 1.0f);
    glVertex2f(-1.0f, -1.0f);
    glTexCoord2f(1.0f, 1.0f);
    glVertex2f(1.0f, -1.0f);
    glTexCoord2f(1.0f, 0.0f);
    glVertex2f(1.0f, 1.0f);
    glTexCoord2f(0.0f, 0.0f);
    glVertex2f(-1.0f, 1.0f);
    glEnd();
    glDisable(GL_TEXTURE_2D);
}

void GlScreen::draw_pixels(const render::Frame& frame, scene::Resolution window) const {
    const auto [width, height] = frame.resolution;
    glRasterPos2f(-1.0f, 1.0f);
    glPixelZoom(static_cast<float>(window.width) / static_cast<float>(width),
                -static_cast<float>(window.height) / static_cast<float>(height));
    glDrawPixels(static_cast<GLsizei>(width), static_cast<GLsizei>(height), GL_RGBA,
                 GL_UNSIGNED_BYTE, frame.bytes.data());
}

}  // namespace lray::gui
