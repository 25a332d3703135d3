// How veins and rings look across: how much of colour `b` there is on the way from one to the next,
// which runs from 0 to 1. With integrals, so that the mean over any width is known.
#pragma once

namespace lray::scene {

/// A vein at 0 and 1, sharp in its middle, that loses itself in the stone.
struct MarbleProfile {
    static constexpr double value(double t) {
        const double off = 1.0 - 2.0 * t;  // 1 at one vein, -1 at the next
        const double cube = off * off * off;
        return off < 0.0 ? -cube : cube;
    }
    static constexpr double integral(double to) {
        const double off = 1.0 - 2.0 * to;
        const double part = 0.125 * off * off * off * off;
        return off < 0.0 ? 0.125 + part : 0.125 - part;
    }
};

/// Wood grows darker through the year, and sets in light again in spring.
struct WoodProfile {
    static constexpr double kWinter = 0.85;

    static constexpr double value(double t) {
        if (t < kWinter) return t / kWinter;
        return (1.0 - t) / (1.0 - kWinter);
    }
    static constexpr double integral(double to) {
        if (to < kWinter) return 0.5 * to * to / kWinter;
        return 0.5 - 0.5 * (1.0 - to) * (1.0 - to) / (1.0 - kWinter);
    }
};

}  // namespace lray::scene
