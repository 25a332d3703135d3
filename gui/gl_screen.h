// The picture in a window: frames to pixels by OpenGL, whatever version there is.
#pragma once

#include <cstdint>

#include "render/live_picture.h"
#include "scene/camera.h"

namespace lray::gui {

/// What bringing frames to OpenGL took.
struct UploadCounts {
    std::uint64_t frames = 0;
    double seconds = 0.0;
};

/// For the context that is current when it is made. Frames go through a pixel buffer into a
/// texture, straight into the texture where there are no pixel buffers, and without textures of any
/// size each is drawn pixel by pixel.
class GlScreen {
 public:
    GlScreen();
    ~GlScreen();
    GlScreen(const GlScreen&) = delete;
    GlScreen& operator=(const GlScreen&) = delete;

    /// Takes over rows of a frame; all of it if its size is not that of the last one.
    void upload(const render::Frame& frame, render::RowRange rows);

    /// Draws it over all of the window, stretched if that has another size.
    void draw(const render::Frame& frame, scene::Resolution window) const;

    const UploadCounts& counts() const { return counts_; }

 private:
    void set_size(scene::Resolution size);
    void draw_pixels(const render::Frame& frame, scene::Resolution window) const;

    bool has_textures_ = false;
    bool has_buffers_ = false;
    unsigned texture_ = 0;
    unsigned buffer_ = 0;
    scene::Resolution size_{0, 0};
    bool fits_ = false;  // into a texture
    UploadCounts counts_{};
};

}  // namespace lray::gui
