#include "gui/gestures.h"

#include <algorithm>
#include <cmath>

namespace lray::gui {

Gesture MouseGestures::press(MouseButton button, DVec2 at, bool is_shift) {
    if (button == MouseButton::wheel_up || button == MouseButton::wheel_down) {
        const double notches = button == MouseButton::wheel_up ? 1.0 : -1.0;
        return {.kind = GestureKind::wheel, .at = at, .from = at, .delta = {0.0, notches}};
    }
    if (!held_) held_ = {.button = button, .is_shift = is_shift, .from = at, .last = at};
    return {};
}

Gesture MouseGestures::move(DVec2 at) {
    if (!held_) return {};
    const DVec2 way = at - held_->from;
    if (!held_->is_drag && !(dot(way, way) >= kClickReach * kClickReach)) return {};
    held_->is_drag = true;
    Gesture gesture{.at = at, .from = held_->from, .delta = at - held_->last};
    held_->last = at;
    if (held_->button == MouseButton::right) {
        gesture.kind = GestureKind::crop_drawn;
    } else if (held_->button == MouseButton::middle || held_->is_shift) {
        gesture.kind = GestureKind::pan;
    } else {
        gesture.kind = GestureKind::orbit;
    }
    return gesture;
}

Gesture MouseGestures::release(MouseButton button, DVec2 at) {
    if (!held_ || held_->button != button) return {};
    Gesture gesture = move(at);  // the last bit of the way, if it was not reported
    const bool is_drag = held_->is_drag;
    held_.reset();
    if (is_drag) {
        if (gesture.kind == GestureKind::crop_drawn) gesture.kind = GestureKind::crop_chosen;
        return gesture;
    }
    gesture.at = at;
    if (button == MouseButton::left) gesture.kind = GestureKind::click;
    if (button == MouseButton::right) gesture.kind = GestureKind::crop_cleared;
    return gesture;
}

std::optional<render::PixelRect> touched_pixels(DVec2 from, DVec2 to,
                                                scene::Resolution resolution) {
    const DVec2 size{static_cast<double>(resolution.width), static_cast<double>(resolution.height)};
    const DVec2 low = glm::max(glm::floor(glm::min(from, to)), DVec2(0.0));
    const DVec2 high = glm::min(glm::ceil(glm::max(from, to)), size);
    if (!(low.x < high.x && low.y < high.y)) return {};
    const auto whole = [](double x) { return static_cast<std::uint32_t>(x); };
    return render::PixelRect{whole(low.x), whole(low.y), whole(high.x), whole(high.y)};
}

}  // namespace lray::gui
