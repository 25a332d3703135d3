#include "gui/held_keys.h"

#include <algorithm>

#include "base/assert.h"

namespace lray::gui {

HeldKeys::Held& HeldKeys::held(Action action) {
    LRAY_ASSERT(is_movement(action));
    return held_[static_cast<std::size_t>(action) - static_cast<std::size_t>(Action::forward)];
}

void HeldKeys::count(Held& held, double now) {
    if (!held.is_active) return;
    const double end = held.is_down ? now : std::min(now, held.until);
    held.sum += std::max(0.0, end - held.counted);
    held.counted = std::max(held.counted, end);
    held.is_active = held.is_down || held.until > now;
}

void HeldKeys::press(Action action, double now) {
    Held& key = held(action);
    if (key.is_down) return;
    count(key, now);
    key.counted = now;
    key.is_active = true;
    key.is_down = true;
    key.pressed = now;
}

void HeldKeys::let_go(Held& key, double now) {
    if (!key.is_down) return;
    count(key, now);
    key.is_down = false;
    key.until = key.pressed + kLeastPress;
    key.is_active = key.until > now;
}

void HeldKeys::release(Action action, double now) {
    let_go(held(action), now);
}

void HeldKeys::release_all(double now) {
    for (Held& key : held_) let_go(key, now);
}

void HeldKeys::end_taps() {
    for (Held& key : held_) {
        if (!key.is_down) key = {};
    }
}

bool HeldKeys::is_any_held() const {
    return std::ranges::any_of(held_, [](const Held& key) {
        return key.sum > 0.0 || (key.is_active && (key.is_down || key.until > key.counted));
    });
}

double HeldKeys::taken(Action action, double now) {
    Held& key = held(action);
    count(key, now);
    const double seconds = std::min(key.sum, kLongestAdvance);
    key.sum = 0.0;
    return seconds;
}

Motion HeldKeys::advance(double now) {
    Motion motion;
    motion.forward = taken(Action::forward, now) - taken(Action::back, now);
    motion.right = taken(Action::strafe_right, now) - taken(Action::strafe_left, now);
    motion.up = taken(Action::go_up, now) - taken(Action::go_down, now);
    motion.yaw = taken(Action::turn_left, now) - taken(Action::turn_right, now);
    return motion;
}

}  // namespace lray::gui
