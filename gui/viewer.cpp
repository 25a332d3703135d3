// Events and time; what follows from them is in viewer_actions.cpp and viewer_scene.cpp.
#include "gui/viewer.h"

#include <algorithm>
#include <utility>

#include "gui/navigation.h"

namespace lray::gui {

namespace {

// Seconds between two looks at the picture: while it is moved, while it grows, and at rest. What
// has rested for long changes little from one pass to the next.
constexpr double kMovingPeriod = 1.0 / 60.0;
constexpr double kSlowestPeriod = 0.2;
constexpr double kPeriodGrowth = 0.02;  // of the time since the last change
constexpr double kRestingPeriod = 0.1;
constexpr double kLoadingPeriod = 0.03;

/// The same part of a picture of another size.
std::optional<render::PixelRect> scaled(const std::optional<render::PixelRect>& part,
                                        scene::Resolution from, scene::Resolution to) {
    if (!part || from == to) return part;
    const auto down = [](std::uint32_t at, std::uint32_t size, std::uint32_t other) {
        return static_cast<std::uint32_t>(std::uint64_t{at} * other / size);
    };
    const auto up = [&](std::uint32_t at, std::uint32_t size, std::uint32_t other) {
        return other - down(size - at, size, other);
    };
    return render::PixelRect{
        std::min(down(part->x0, from.width, to.width), to.width - 1),
        std::min(down(part->y0, from.height, to.height), to.height - 1),
        std::max(up(part->x1, from.width, to.width), 1u),
        std::max(up(part->y1, from.height, to.height), 1u),
    };
}

bool is_same_progress(const render::SessionStatus& a, const render::SessionStatus& b) {
    return a.change == b.change && a.square == b.square && a.passes == b.passes &&
           a.is_done == b.is_done && a.is_paused == b.is_paused;
}

}  // namespace

Viewer::Viewer(LoadedScene first, Program program, KeyboardLayout layout, const Font& font,
               scene::Resolution size, double now)
    : program_(std::move(program)),
      layout_(layout),
      font_(font),
      size_(size),
      change_time_(now),
      now_(now) {
    crop_ = scaled(first.view.render_options.crop, first.view.render_options.resolution, size);
    camera_ = first.view.camera;
    scene_view_ = first.view;
    views_ = program_.read_views();
    take(std::move(first));
    if (!watch_.problem().empty()) tell(watch_.problem(), now);
}

Viewer::~Viewer() {
    finish();
}

void Viewer::finish() {
    session_.cancel_picks();
    saver_.finish();
}

void Viewer::resize(scene::Resolution size) {
    if (size == size_) return;
    crop_ = scaled(crop_, size_, size);
    size_ = size;
    crop_drawn_.reset();
    mouse_.cancel();
    sliders_.lay_out(window(), font_);
    show();
}

void Viewer::press(const Key& key, double now) {
    now_ = now;
    const Bound bound = action_of(key, layout_);
    repeated_.reset();
    if (is_movement(bound.action)) {
        if (!held_.is_any_held()) begin_move(Move::keys, now);
        held_.press(bound.action, now);
        return;
    }
    act(bound, now);
    constexpr double kDelay = 0.4;
    if (repeats(bound.action)) repeated_ = Repeated{key, bound, now + kDelay};
}

void Viewer::release(const Key& key, double now) {
    now_ = now;
    const Action action = movement_of(key, layout_);
    if (is_movement(action)) held_.release(action, now);
    repeated_.reset();
}

void Viewer::release_all_keys(double now) {
    held_.release_all(now);
    repeated_.reset();
}

void Viewer::repeat_actions(double now) {
    constexpr double kPeriod = 0.06;
    if (!repeated_ || now < repeated_->next) return;
    repeated_->next = now + kPeriod;
    act(repeated_->bound, now);
}

void Viewer::press(MouseButton button, DVec2 at, bool is_shift, double now) {
    now_ = now;
    if (button == MouseButton::left && shows_hud_ && sliders_.press(at)) {
        use_sliders();
        return;
    }
    is_drag_remembered_ = false;
    apply(mouse_.press(button, at, is_shift), now);
}

void Viewer::move(DVec2 at, double now) {
    now_ = now;
    if (sliders_.drag(at)) return use_sliders();
    apply(mouse_.move(at), now);
}

void Viewer::release(MouseButton button, DVec2 at, double now) {
    now_ = now;
    if (button == MouseButton::left && sliders_.is_dragging()) return sliders_.release();
    apply(mouse_.release(button, at), now);
}

Tick Viewer::tick(double now) {
    now_ = now;
    loader_.poll();
    picker_.poll();
    saver_.poll();
    if (program_.is_interrupted()) end(ViewerState::interrupted);
    if (watch_.poll(now)) load();
    repeat_actions(now);
    const Motion motion = held_.advance(now);
    if (!motion.is_none()) fly(motion, now);

    const render::SessionStatus status = session_.status();
    if (status.is_out_of_memory) end(ViewerState::out_of_memory);
    if (status.scene != seen_.scene) find_volumes();
    if (!is_same_progress(status, seen_)) needs_redraw_ = true;
    seen_ = status;
    const scene::Resolution size_before = frame_.resolution;
    if (const auto rows = session_.update(frame_)) {
        needs_redraw_ = true;
        // Rows that nobody has drawn yet may be of a frame of another size.
        if (!changed_rows_ || frame_.resolution != size_before) changed_rows_ = rows;
        changed_rows_->begin = std::min(changed_rows_->begin, rows->begin);
        changed_rows_->end = std::max(changed_rows_->end, rows->end);
    }
    if (!message_.empty() && now >= message_end_) {
        message_.clear();
        needs_redraw_ = true;
    }

    return {std::exchange(needs_redraw_, false), seconds_to_next_tick(),
            std::exchange(wanted_size_, std::nullopt)};
}

double Viewer::seconds_to_next_tick() const {
    const bool is_moving = has_held_keys() || mouse_.is_held() || sliders_.is_dragging();
    if (is_moving) return kMovingPeriod;
    const double seconds = is_at_rest() ? kRestingPeriod
                                        : std::clamp(kPeriodGrowth * (now_ - change_time_),
                                                     kMovingPeriod, kSlowestPeriod);
    const bool is_busy = is_loading_ || picker_.is_busy() || saver_.is_busy();
    return is_busy ? std::min(seconds, kLoadingPeriod) : seconds;
}

bool Viewer::is_at_rest() const {
    return seen_.change == change_ && seen_.is_idle && !is_loading_;
}

std::optional<render::RowRange> Viewer::take_changed_rows() {
    return std::exchange(changed_rows_, std::nullopt);
}

}  // namespace lray::gui
