// Views gone through, for undo and redo.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "scene/camera.h"

namespace lray::gui {

/// True if both see the same, whatever they are called.
inline bool is_same_view(const scene::Camera& a, const scene::Camera& b) {
    return a.position == b.position && a.look_at == b.look_at && a.up == b.up &&
           a.projection == b.projection && a.fov == b.fov && a.height == b.height &&
           a.aperture == b.aperture && a.focus == b.focus;
}

class CameraHistory {
 public:
    static constexpr std::size_t kMaxSize = 200;  // the oldest are forgotten

    /// To be called with the view that a move is about to leave. What was undone is lost.
    void remember(const scene::Camera& before) {
        redo_.clear();
        push(undo_, before);
    }

    /// Returns the last view that differs from the current one, which redo() brings back.
    std::optional<scene::Camera> undo(const scene::Camera& current) {
        return step(undo_, redo_, current);
    }
    std::optional<scene::Camera> redo(const scene::Camera& current) {
        return step(redo_, undo_, current);
    }

 private:
    using Views = std::deque<scene::Camera>;

    static void push(Views& views, const scene::Camera& camera) {
        if (!views.empty() && is_same_view(views.back(), camera)) return;
        if (views.size() == kMaxSize) views.pop_front();
        views.push_back(camera);
    }

    static std::optional<scene::Camera> step(Views& from, Views& to, const scene::Camera& current) {
        while (!from.empty()) {
            const scene::Camera view = from.back();
            from.pop_back();
            if (is_same_view(view, current)) continue;
            push(to, current);
            return view;
        }
        return {};
    }

    Views undo_{};
    Views redo_{};
};

}  // namespace lray::gui
