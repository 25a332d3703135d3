// What keys and gestures do.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "base/assert.h"
#include "gui/navigation.h"
#include "gui/viewer.h"
#include "render/fit_camera.h"

namespace lray::gui {

namespace {

constexpr double kTurnSpeed = std::numbers::pi / 3.0;  // radians a second
constexpr double kDragTurn = std::numbers::pi;         // radians over the window's height
constexpr double kWheelFactor = 0.85;                  // of the distance, for each notch
constexpr double kWheelPause = 0.5;                    // seconds between two moves of the wheel
constexpr double kExposureStep = 0.5;                  // stops
constexpr double kMaxExposure = 32.0;                  // stops, either way
constexpr double kLeastSpeed = 1.0 / 1024.0;
constexpr double kGreatestSpeed = 1024.0;
constexpr double kMessageSeconds = 4.0;

constexpr std::array kToneMaps{image::ToneMap::none, image::ToneMap::reinhard,
                               image::ToneMap::aces};

}  // namespace

void Viewer::tell(std::string message, double now) {
    message_ = std::move(message);
    message_end_ = now + kMessageSeconds;
    needs_redraw_ = true;
}

void Viewer::act(Bound bound, double now) {
    needs_redraw_ = true;
    switch (bound.action) {
        case Action::none:
            needs_redraw_ = false;
            return;
        case Action::forward:
        case Action::back:
        case Action::turn_left:
        case Action::turn_right:
        case Action::strafe_left:
        case Action::strafe_right:
        case Action::go_up:
        case Action::go_down:
            LRAY_ASSERT(false);  // are held
        case Action::faster:
            speed_ = std::min(2.0 * speed_, kGreatestSpeed);
            return tell(fmt::format("speed {}", speed_), now);
        case Action::slower:
            speed_ = std::max(0.5 * speed_, kLeastSpeed);
            return tell(fmt::format("speed {}", speed_), now);
        case Action::orbit_or_fly:
            is_flying_ = !is_flying_;
            return tell(
                is_flying_ ? "fly: dragging looks around" : "orbit: dragging turns the scene", now);
        case Action::frame_all:
            return jump_to(render::framed(camera_, bounds_, size_), now);
        case Action::scene_camera:
            return jump_to(scene_view_.camera, now);
        case Action::recall_view:
            return recall_view(bound.number, now);
        case Action::store_view:
            return store_view(bound.number, now);
        case Action::undo:
            return step_through_history(true, now);
        case Action::redo:
            return step_through_history(false, now);
        case Action::exposure_up:
            exposure_ = std::min(exposure_ + kExposureStep, kMaxExposure);
            return show_display();
        case Action::exposure_down:
            exposure_ = std::max(exposure_ - kExposureStep, -kMaxExposure);
            return show_display();
        case Action::next_tone_map:
            return use_next_tone_map();
        case Action::next_shading:
            return choose_shading(1);
        case Action::previous_shading:
            return choose_shading(-1);
        case Action::next_volumes:
            return show_volumes(1, now);
        case Action::previous_volumes:
            return show_volumes(-1, now);
        case Action::pause:
            return session_.set_paused(!session_.status().is_paused);
        case Action::print_camera:
            program_.print(program_.camera_text(camera_));
            return tell("the camera is printed in the terminal", now);
        case Action::save_picture:
            return save();
        case Action::reload:
            return load();
        case Action::hud:
            shows_hud_ = !shows_hud_;
            return;
        case Action::help:
            shows_help_ = !shows_help_;
            return;
        case Action::quit:
            return end(ViewerState::closed);
        case Action::previous_slider:
            return sliders_.select_previous();
        case Action::next_slider:
            return sliders_.select_next();
        case Action::slider_down:
            sliders_.step(-1);
            return use_sliders();
        case Action::slider_up:
            sliders_.step(1);
            return use_sliders();
    }
    LRAY_ASSERT(false);
}

void Viewer::jump_to(const scene::Camera& camera, double now) {
    begin_move(Move::jump, now);
    held_.end_taps();
    set_camera(camera);
}

void Viewer::step_through_history(bool is_undo, double now) {
    const auto other = is_undo ? history_.undo(camera_) : history_.redo(camera_);
    last_move_ = Move::none;
    held_.end_taps();
    if (other) return set_camera(*other);
    tell(is_undo ? "nothing to undo" : "nothing to redo", now);
}

void Viewer::use_next_tone_map() {
    const image::ToneMap used = tonemap_.value_or(scene_view_.render_options.display.tonemap);
    const auto at = std::find(kToneMaps.begin(), kToneMaps.end(), used);
    tonemap_ = kToneMaps[static_cast<std::size_t>(at - kToneMaps.begin() + 1) % kToneMaps.size()];
    show_display();
}

void Viewer::recall_view(int number, double now) {
    const auto view = views_.find(number);
    if (view == views_.end()) {
        return tell(fmt::format("there is no view {}; Shift+F{} stores one", number, number), now);
    }
    scene::Camera camera = view->second;
    camera.name = camera_.name;
    jump_to(camera, now);
}

void Viewer::store_view(int number, double now) {
    views_[number] = camera_;
    const Outcome outcome = program_.write_views(views_);
    tell(outcome.is_done ? fmt::format("view {} {}", number, outcome.sentence) : outcome.sentence,
         now);
}

/// Keeps the view that is about to be left, once for each move.
void Viewer::begin_move(Move move, double now) {
    const bool goes_on =
        move == Move::wheel && last_move_ == move && now - last_move_time_ < kWheelPause;
    if (!goes_on) history_.remember(camera_);
    last_move_ = move;
    last_move_time_ = now;
}

void Viewer::set_camera(const scene::Camera& camera) {
    camera_ = camera;
    show();
}

void Viewer::fly(const Motion& motion, double now) {
    last_move_time_ = now;
    const double speed = speed_ * base_speed(bounds_, camera_);
    const scene::Camera there =
        moved(camera_, speed * DVec3{motion.right, motion.up, motion.forward});
    set_camera(motion.yaw == 0.0 ? there : turned(there, kTurnSpeed * motion.yaw, 0.0));
}

void Viewer::apply(const Gesture& gesture, double now) {
    const double per_pixel = kDragTurn / size_.height;
    switch (gesture.kind) {
        case GestureKind::none:
            return;
        case GestureKind::click:
            return pick(gesture.at);
        case GestureKind::orbit: {
            // The scene follows the mouse around its middle; the head turns to where it goes.
            const DVec2 turn = -per_pixel * gesture.delta;
            const auto turn_camera = is_flying_ ? turned : orbited;
            if (!is_drag_remembered_) begin_move(Move::drag, now);
            is_drag_remembered_ = true;
            return set_camera(turn_camera(camera_, turn.x, turn.y));
        }
        case GestureKind::pan:
            if (!is_drag_remembered_) begin_move(Move::drag, now);
            is_drag_remembered_ = true;
            return set_camera(panned(camera_, gesture.delta, size_));
        case GestureKind::wheel:
            begin_move(Move::wheel, now);
            return set_camera(
                dollied(camera_, gesture.delta.y > 0.0 ? kWheelFactor : 1.0 / kWheelFactor));
        case GestureKind::crop_drawn:
            crop_drawn_ = gesture;
            needs_redraw_ = true;
            return;
        case GestureKind::crop_chosen:
            crop_drawn_.reset();
            crop_ = touched_pixels(gesture.from, gesture.at, size_);
            return show_crop();
        case GestureKind::crop_cleared:
            crop_drawn_.reset();
            needs_redraw_ = true;
            if (!crop_) return;
            crop_.reset();
            return show_crop();
    }
    LRAY_ASSERT(false);
}

void Viewer::pick(DVec2 at) {
    session_.cancel_picks();  // of earlier clicks
    const auto job = [this, at, ticket = session_.pick_ticket(), load = loads_] {
        const render::PickResult result = session_.pick(at + DVec2{0.5}, ticket);
        return [this, result, load] {
            if (!result.is_cancelled && load == loads_) show_pick(result.found);
        };
    };
    picker_.start(job, [this] { tell("there is not enough memory to look it up", now_); });
}

void Viewer::show_pick(const std::optional<render::Pick>& found) {
    needs_redraw_ = true;
    picked_.reset();
    if (!found) return;
    const std::string placed =
        found->placed_at.empty() ? "" : fmt::format(", placed at {}", found->placed_at);
    picked_ = PickedObject{found->name, found->place + placed};
    program_.print(fmt::format("{}: {}{}", found->place, found->name, placed));
}

void Viewer::save() {
    const auto job = [this, display = shown_display()] {
        const Outcome outcome = program_.save(session_.light(), display);
        return [this, outcome] { tell(outcome.sentence, now_); };
    };
    saver_.start(job, [this] { tell("there is not enough memory to save the picture", now_); });
}

/// Shows the cut through the hierarchy one level deeper or higher; before the first and behind the
/// last there is none.
void Viewer::show_volumes(int step, double now) {
    const std::uint32_t count = session_.volumes(0, 1).level_count;
    if (count == 0) return tell("there is no hierarchy to show", now);
    const int last = static_cast<int>(std::min(count, 1000u)) - 1;
    const int before =
        volume_level_ ? static_cast<int>(*volume_level_) : (step > 0 ? -1 : last + 1);
    const int level = before + step;
    volume_level_.reset();
    if (level >= 0 && level <= last) volume_level_ = static_cast<std::uint32_t>(level);
    find_volumes();
}

}  // namespace lray::gui
