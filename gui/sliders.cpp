#include "gui/sliders.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gui/text_panel.h"

namespace lray::gui {

namespace {

constexpr double kMargin = 4.0;
constexpr double kColumns = 28.0;     // of a name and its value
constexpr double kTrackHeight = 6.0;  // below them
constexpr double kGap = 4.0;          // between two sliders

constexpr Rgba kTrackColor{0.30f, 0.32f, 0.36f, 1.0f};
constexpr Rgba kFilledColor{0.45f, 0.65f, 0.95f, 1.0f};

double row_height(const Font& font) {
    return font.height + kTrackHeight + kGap;
}

std::optional<std::size_t> find(const std::vector<Slider>& sliders, const std::string& name) {
    const auto found = std::ranges::find(sliders, name, &Slider::name);
    if (found == sliders.end()) return {};
    return static_cast<std::size_t>(found - sliders.begin());
}

}  // namespace

void Sliders::set(std::vector<Slider> sliders) {
    const std::vector<Slider> before = std::exchange(sliders_, {});
    for (Slider& slider : sliders) sliders_.push_back(in_order(std::move(slider)));
    const auto now_at = [&](std::size_t index) {
        return index < before.size() ? find(sliders_, before[index].name) : std::nullopt;
    };
    selected_ = now_at(selected_).value_or(0);
    if (dragged_) {
        const std::size_t index = *dragged_;
        dragged_ = now_at(index);
        if (dragged_) {
            sliders_[*dragged_].value = before[index].value;
            sliders_[*dragged_] = in_order(std::move(sliders_[*dragged_]));
        }
    }
    lay_out(window_, font_);
}

void Sliders::lay_out(WindowSize window, const Font& font) {
    window_ = window;
    font_ = font;
    const double width = std::min(kColumns * font.width + 2.0 * kPanelPadding,
                                  static_cast<double>(window.width) - 2.0 * kMargin);
    const double room = window.height - 2.0 * kMargin - 2.0 * kPanelPadding;
    const auto rows_in = [&](double height) {
        return height > 0.0 ? static_cast<std::size_t>(height / row_height(font)) : 0;
    };
    shown_count_ = std::min(rows_in(room), sliders_.size());
    // A line says which are shown if not all are.
    const bool is_part = shown_count_ < sliders_.size();
    if (is_part) shown_count_ = std::min(rows_in(room - font.height), sliders_.size());
    if (columns_in(width - 2.0 * kPanelPadding, font) == 0) shown_count_ = 0;
    if (shown_count_ == 0) {
        panel_ = {};
        return;
    }
    // No farther than needed: what the mouse has pressed stays below it.
    first_shown_ = std::clamp(
        first_shown_, selected_ >= shown_count_ ? selected_ - shown_count_ + 1 : 0, selected_);
    first_shown_ = std::min(first_shown_, sliders_.size() - shown_count_);
    const double height = static_cast<double>(shown_count_) * row_height(font) +
                          (is_part ? font.height : 0.0) + 2.0 * kPanelPadding;
    panel_ = {window.width - kMargin - width, kMargin, window.width - kMargin, kMargin + height};
}

/// Below the line that says which are shown. Shape: a slider that is shown.
Box Sliders::row(std::size_t index) const {
    const double rows_height = static_cast<double>(shown_count_) * row_height(font_);
    const double top = panel_.bottom - kPanelPadding - rows_height +
                       static_cast<double>(index - first_shown_) * row_height(font_);
    return {panel_.left + kPanelPadding, top, panel_.right - kPanelPadding,
            top + row_height(font_)};
}

Box Sliders::track(std::size_t index) const {
    const Box whole = row(index);
    return {whole.left, whole.top + font_.height, whole.right,
            whole.top + font_.height + kTrackHeight};
}

std::optional<std::size_t> Sliders::at(DVec2 position) const {
    for (std::size_t i = first_shown_; i < first_shown_ + shown_count_; ++i) {
        Box box = row(i);
        box.left = panel_.left;  // the ends of a track are hard to hit
        box.right = panel_.right;
        if (box.contains(position)) return i;
    }
    return {};
}

bool Sliders::press(DVec2 position) {
    const auto index = at(position);
    if (!index) return shown_count_ > 0 && panel_.contains(position);
    selected_ = *index;
    dragged_ = index;
    return drag(position);
}

bool Sliders::drag(DVec2 position) {
    if (!dragged_) return false;
    const Box box = track(*dragged_);
    assign(*dragged_, value_at(sliders_[*dragged_], (position.x - box.left) / box.width()));
    return true;
}

void Sliders::select_by(std::size_t count) {
    if (sliders_.empty()) return;
    selected_ = (selected_ + count) % sliders_.size();
    lay_out(window_, font_);
}

void Sliders::step(int direction) {
    if (sliders_.empty()) return;
    assign(selected_, stepped_value(sliders_[selected_], direction));
}

void Sliders::assign(std::size_t index, double value) {
    if (sliders_[index].value == value) return;
    sliders_[index].value = value;
    is_changed_ = true;
}

bool Sliders::take_change() {
    return std::exchange(is_changed_, false);
}

std::optional<std::size_t> Sliders::selected() const {
    if (sliders_.empty()) return {};
    return selected_;
}

void Sliders::draw_slider(Overlay& overlay, std::size_t index) const {
    const Slider& slider = sliders_[index];
    const Box box = row(index);
    const std::size_t columns = columns_in(box.width(), font_);
    const Rgba color = index == selected_ ? kAccentColor : kTextColor;
    // The value is what one looks at: the name has what it leaves.
    const std::string value = cut_text(shown_text(value_text(slider)), columns);
    const std::size_t left = columns - value.size();
    const std::string name = cut_text(shown_text(slider.name), left > 0 ? left - 1 : 0);
    if (!name.empty()) overlay.add_text({box.left, box.top}, name, color);
    overlay.add_text({box.right - static_cast<double>(value.size()) * font_.width, box.top}, value,
                     color);
    const Box whole = track(index);
    Box filled = whole;
    filled.right = whole.left + fraction_of(slider) * whole.width();
    overlay.add_box(whole, kTrackColor);
    overlay.add_box(filled, index == selected_ ? kAccentColor : kFilledColor);
}

void Sliders::draw(Overlay& overlay) const {
    if (shown_count_ == 0) return;
    overlay.add_box(panel_, kPanelColor);
    if (shown_count_ < sliders_.size()) {
        const std::string shown = fmt::format("parameters {}-{} of {}", first_shown_ + 1,
                                              first_shown_ + shown_count_, sliders_.size());
        overlay.add_text({panel_.left + kPanelPadding, panel_.top + kPanelPadding},
                         cut_text(shown, columns_in(panel_.width() - 2.0 * kPanelPadding, font_)),
                         kFaintColor);
    }
    for (std::size_t i = first_shown_; i < first_shown_ + shown_count_; ++i) {
        draw_slider(overlay, i);
    }
}

}  // namespace lray::gui
