// Keys that are held down, integrated over time: GLUT's key repeat plays no part in how far the
// camera goes. The time is given by the caller, in seconds from any origin.
#pragma once

#include <array>
#include <cstddef>

#include "gui/key_bindings.h"

namespace lray::gui {

/// For how long each way was in force, in seconds; opposite keys cancel out.
struct Motion {
    double forward = 0.0;
    double right = 0.0;
    double up = 0.0;
    double yaw = 0.0;  // to the left

    bool is_none() const { return forward == 0.0 && right == 0.0 && up == 0.0 && yaw == 0.0; }
};

class HeldKeys {
 public:
    /// A tap counts as this long, so that it can be seen.
    static constexpr double kLeastPress = 0.1;

    /// The longest time that one advance() counts: after a computer slept, the camera must not
    /// shoot off.
    static constexpr double kLongestAdvance = 0.25;

    /// Pressing what is held already changes nothing. Shape: is_movement(action), asserted.
    void press(Action action, double now);

    /// What was tapped stays in force until kLeastPress is over. Releasing what is not held changes
    /// nothing.
    void release(Action action, double now);

    /// For when the window has lost the keyboard, and with it the end of presses.
    void release_all(double now);

    /// Ends taps that are still in force: the camera goes elsewhere.
    void end_taps();

    /// True if a later advance() will return some motion.
    bool is_any_held() const;

    /// Returns the motion since the last call.
    Motion advance(double now);

 private:
    struct Held {
        bool is_down = false;
        double pressed = 0.0;    // when
        double counted = 0.0;    // until when it is in `sum`
        double until = 0.0;      // when it ends; of no meaning while down
        double sum = 0.0;        // seconds in force that no advance() has returned yet
        bool is_active = false;  // down, or not yet at `until`
    };

    static void count(Held& held, double now);
    static void let_go(Held& held, double now);
    double taken(Action action, double now);
    Held& held(Action action);

    std::array<Held, kMovementCount> held_{};
};

}  // namespace lray::gui
