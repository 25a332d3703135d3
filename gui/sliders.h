// The params of a scene as sliders in the window: layout, mouse and keys. What becomes of a new
// value is the caller's business.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "gui/overlay.h"
#include "gui/slider_value.h"

namespace lray::gui {

class Sliders {
 public:
    /// Replaces all of them. The selected one, and the one that is dragged, stay so by name; what
    /// is dragged keeps its value.
    void set(std::vector<Slider> sliders);

    /// Gives each its place, in the top right corner; those around the selected one where not all
    /// have room. To be called when the window, the font or the sliders have changed.
    void lay_out(WindowSize window, const Font& font);

    /// Returns which slider lies there.
    std::optional<std::size_t> at(DVec2 position) const;

    /// True if the press is meant for a slider, which is selected and takes the value there.
    bool press(DVec2 position);
    /// Moves the slider that was pressed, wherever the mouse is. True if there is one.
    bool drag(DVec2 position);
    void release() { dragged_.reset(); }
    bool is_dragging() const { return dragged_.has_value(); }

    /// Around at the ends.
    void select_next() { select_by(1); }
    void select_previous() { select_by(sliders_.size() - 1); }
    /// Moves the selected one up (direction 1) or down (-1).
    void step(int direction);

    /// True if a value has changed since the last call.
    bool take_change();

    void draw(Overlay& overlay) const;

    bool is_empty() const { return sliders_.empty(); }
    const std::vector<Slider>& all() const { return sliders_; }
    std::optional<std::size_t> selected() const;

 private:
    void select_by(std::size_t count);
    void assign(std::size_t index, double value);
    Box row(std::size_t index) const;
    Box track(std::size_t index) const;
    void draw_slider(Overlay& overlay, std::size_t index) const;

    std::vector<Slider> sliders_{};
    std::size_t selected_ = 0;
    std::optional<std::size_t> dragged_{};
    bool is_changed_ = false;

    WindowSize window_{};
    Font font_{};
    Box panel_{};
    std::size_t first_shown_ = 0;
    std::size_t shown_count_ = 0;
};

}  // namespace lray::gui
