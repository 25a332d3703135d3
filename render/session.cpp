#include "render/session.h"

#include <new>
#include <stdexcept>
#include <utility>

#include "base/assert.h"
#include "render/preview.h"
#include "render/threads.h"

namespace lray::render {

namespace {

constexpr std::uint64_t kMeasuredSamples = 64;  // fewer do not tell how fast rays are

}  // namespace

Session::Session() : thread_([this] { run(); }) {}

Session::~Session() {
    {
        const std::lock_guard lock(mutex_);
        is_ending_ = true;
        cancel_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

std::uint64_t Session::set_scene(std::unique_ptr<const PreparedScene> scene, const View& view) {
    LRAY_ASSERT(scene != nullptr);
    return ask([&] {
        asked_.scene.swap(scene);  // one that nobody has seen ends without the lock
        asked_.view = view;
        asked_.needs_squares = true;
    });
}

std::uint64_t Session::set_view(const View& view) {
    return ask([&] {
        asked_.view = view;
        asked_.needs_squares = true;
    });
}

std::uint64_t Session::set_crop(const std::optional<PixelRect>& crop) {
    return ask([&] { asked_.view.render_options.crop = crop; });
}

/// Edits what is asked for, and sees to it that it is taken up.
template <class Edit>
std::uint64_t Session::ask(const Edit& edit) {
    std::uint64_t number = 0;
    {
        const std::lock_guard lock(mutex_);
        edit();
        display_ = asked_.view.render_options.display;
        number = ++asked_number_;
        is_change_asked_ = true;
    }
    end_outdated_step();
    wake_.notify_all();
    return number;
}

void Session::set_display(const image::DisplaySettings& display) {
    {
        const std::lock_guard lock(mutex_);
        display_ = display;
        asked_.view.render_options.display = display;
    }
    const std::lock_guard lock(picture_mutex_);
    if (picture_) picture_->set_display(display);
}

void Session::set_paused(bool is_paused) {
    {
        const std::lock_guard lock(mutex_);
        is_paused_ = is_paused;
        status_.is_paused = is_paused;
        status_.is_idle = false;  // until the session's thread has looked
    }
    wake_.notify_all();
}

SessionStatus Session::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

std::optional<RowRange> Session::update(Frame& frame) {
    end_outdated_step();  // a single ray may take so long that no thread asks
    const std::lock_guard lock(picture_mutex_);
    return picture_ ? picture_->copy_changes(frame) : std::nullopt;
}

image::Image Session::light() const {
    const std::lock_guard lock(picture_mutex_);
    return picture_ ? picture_->light(area_) : image::Image{};
}

PickResult Session::pick(DVec2 position_pixel, PickTicket ticket) {
    const std::lock_guard one_at_a_time(pick_mutex_);
    {
        const std::lock_guard lock(mutex_);
        if (ticket <= cancelled_ticket_ || is_scene_leaving_) return {.is_cancelled = true};
        cancel_pick_ = false;  // from here on it is set by whoever cancels
    }
    const std::shared_lock lock(scene_mutex_);
    if (!scene_) return {};
    PickResult result;
    result.found =
        render::pick(scene_->scene, scene_->world, *scene_->accel, scene_->sources, view_.camera,
                     view_.render_options.resolution, position_pixel, cancel_pick_);
    result.is_cancelled = cancel_pick_;
    return result;
}

void Session::cancel_picks() {
    const std::lock_guard lock(mutex_);
    cancelled_ticket_ = last_ticket_;
    cancel_pick_ = true;
}

BoundingVolumes Session::volumes(std::uint32_t level, std::size_t max_count) const {
    const std::shared_lock lock(scene_mutex_);
    return scene_ ? scene_->accel->volumes(level, max_count) : BoundingVolumes{};
}

void Session::run() {
    try {
        work();
        return;
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    const std::lock_guard lock(mutex_);
    status_.is_done = true;
    status_.is_out_of_memory = true;
}

/// Whether the session's thread has something to do, beside changes. Called with the lock.
bool Session::has_work() const {
    return job_ && !job_->is_done() && !(is_paused_ && job_->shows_every_pixel());
}

void Session::work() {
    for (;;) {
        std::optional<Change> change;
        std::uint64_t number = 0;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [&] {
                status_.is_idle = !is_change_asked_ && !has_work();
                return is_ending_ || !status_.is_idle;
            });
            if (is_ending_) return;
            if (is_change_asked_) {
                change = Change{std::move(asked_.scene), asked_.view,
                                std::exchange(asked_.needs_squares, false)};
                number = asked_number_;
                is_change_asked_ = false;
                cancel_ = false;
                const Clock::time_point end = Clock::now() + kPatience;
                patience_end_ = end.time_since_epoch().count();
            }
        }
        if (change) apply(std::move(*change), number);
        run_step();
    }
}

void Session::apply(Change change, std::uint64_t number) {
    // What is around a crop may still be in squares, or of the view before.
    const bool needs_squares = change.needs_squares || (job_ && !job_->shows_every_pixel());
    job_.reset();
    std::unique_ptr<const PreparedScene> outdated;
    if (change.scene) outdated = replace_scene(std::move(change.scene));
    LRAY_ASSERT(scene_ != nullptr);
    {
        const std::unique_lock lock(scene_mutex_);
        view_ = std::move(change.view);
    }
    show_picture();
    std::uint32_t square = 0;
    if (needs_squares) square = first_square(seconds_per_ray_, view_.whole().pixel_count());
    job_ = std::make_unique<ProgressiveJob>(*scene_, view_, square, cancel_);
    const std::lock_guard lock(mutex_);
    status_.change = number;
    status_.square = 0;
    status_.passes = 0;
    status_.pass_limit = job_->pass_limit();
    status_.is_done = false;
}

/// Picks look at the old scene no more, nor at the new one with a view of the old.
std::unique_ptr<const PreparedScene> Session::replace_scene(
    std::unique_ptr<const PreparedScene> scene) {
    {
        const std::lock_guard lock(mutex_);
        is_scene_leaving_ = true;
        cancelled_ticket_ = last_ticket_;
        cancel_pick_ = true;
        ++status_.scene;
    }
    {
        const std::unique_lock lock(scene_mutex_);
        scene_.swap(scene);
    }
    const std::lock_guard lock(mutex_);
    is_scene_leaving_ = false;
    seconds_per_ray_ = 0.0;
    return scene;
}

/// Sees to it that there is a picture of the view's size, shown as it was asked for last.
void Session::show_picture() {
    const scene::Resolution resolution = view_.render_options.resolution;
    std::unique_ptr<LivePicture> other;
    if (!picture_ || picture_->resolution() != resolution) {
        other =
            std::make_unique<LivePicture>(resolution, view_.render_options.display, picture_.get());
    }
    const std::lock_guard lock(picture_mutex_);
    if (other) picture_.swap(other);
    picture_->set_display(display());  // which may be newer than the view
    area_ = view_.area();
}

image::DisplaySettings Session::display() const {
    const std::lock_guard lock(mutex_);
    return display_;
}

/// Cancels what runs once a change waits for it, unless it is given time.
void Session::end_outdated_step() {
    if (!is_change_asked_ || Clock::now().time_since_epoch().count() < patience_end_) return;
    const std::lock_guard lock(mutex_);
    if (is_change_asked_) cancel_ = true;  // not that of the step that took it up meanwhile
}

/// Asked by the threads of a step between tiles.
bool Session::should_stop(bool may_pause) {
    end_outdated_step();
    return cancel_ || (may_pause && is_paused_);
}

void Session::run_step() {
    const std::uint32_t square = job_->next_square();
    const bool is_pass = job_->is_pass_next();
    const bool may_pause = job_->shows_every_pixel();
    const StepControl control{[&] { return should_stop(may_pause); }, cancel_,
                              Clock::time_point(Clock::duration(patience_end_))};
    StepOutcome outcome;
    with_threads(view_.render_options.thread_count,
                 [&] { outcome = job_->run_step(*picture_, control); });
    patience_end_ = 0;
    const bool has_usual_rays = !is_pass || !job_->has_quick_rays();  // as those of squares
    if (has_usual_rays && outcome.sample_count >= kMeasuredSamples) {
        const double seconds = outcome.seconds / static_cast<double>(outcome.sample_count);
        seconds_per_ray_ = seconds_per_ray_ > 0.0 ? 0.5 * (seconds_per_ray_ + seconds) : seconds;
    }
    if (!outcome.is_complete) return;
    const std::lock_guard lock(mutex_);
    if (is_pass) {
        ++status_.total_passes;
        status_.total_pass_seconds += outcome.seconds;
    }
    status_.square = square;
    status_.passes = job_->pass_count();
    status_.is_done = job_->is_done();
    status_.rays_per_second = static_cast<double>(outcome.ray_count) / outcome.seconds;
}

}  // namespace lray::render
