// The mouse as a state machine: from presses, moves and releases to what they are meant as.
#pragma once

#include <cstdint>
#include <optional>

#include "base/vec.h"
#include "render/options.h"
#include "scene/camera.h"

namespace lray::gui {

enum class MouseButton : std::uint8_t { left, middle, right, wheel_up, wheel_down };

enum class GestureKind : std::uint8_t {
    none,
    click,        // at `at`
    orbit,        // by `delta`
    pan,          // by `delta`
    wheel,        // `delta.y` is 1 away from the user, which means closer, and -1 towards
    crop_drawn,   // from `from` to `at`, not finished
    crop_chosen,  // from `from` to `at`
    crop_cleared,
};

/// Space: window pixels from the top left, y down.
struct Gesture {
    GestureKind kind = GestureKind::none;
    DVec2 at{0.0};
    DVec2 from{0.0};
    DVec2 delta{0.0};
};

class MouseGestures {
 public:
    /// A mouse that went less far than this many pixels between press and release has clicked.
    static constexpr double kClickReach = 4.0;

    /// While a button is held others do nothing, but for the wheel.
    Gesture press(MouseButton button, DVec2 at, bool is_shift);
    /// A drag begins once it has left the reach of a click; its first delta is all of the way.
    Gesture move(DVec2 at);
    Gesture release(MouseButton button, DVec2 at);

    /// Forgets the button that is held: what comes of it means nothing more.
    void cancel() { held_.reset(); }

    bool is_held() const { return held_.has_value(); }

 private:
    struct Held {
        MouseButton button = MouseButton::left;
        bool is_shift = false;  // when it was pressed
        bool is_drag = false;
        DVec2 from{0.0};
        DVec2 last{0.0};
    };

    std::optional<Held> held_{};
};

/// Returns the pixels of the picture that a rectangle drawn from corner to corner touches; empty if
/// there are none. Space: window pixels, which are those of the picture.
std::optional<render::PixelRect> touched_pixels(DVec2 from, DVec2 to, scene::Resolution resolution);

}  // namespace lray::gui
