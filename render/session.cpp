#include "render/session.h"

#include <new>
#include <stdexcept>
#include <utility>

#include "base/assert.h"
#include "render/preview.h"
#include "render/threads.h"

namespace lray::render {

namespace {

constexpr std::uint64_t kMeasuredSamples = 256;  // fewer do not tell how fast rays are

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
    return request({std::move(scene), view});
}

std::uint64_t Session::set_view(const View& view) {
    return request({nullptr, view});
}

std::uint64_t Session::request(Change change) {
    std::unique_ptr<const PreparedScene> outdated;  // that nobody has seen: ends without the lock
    std::uint64_t number = 0;
    {
        const std::lock_guard lock(mutex_);
        if (change.scene) {
            outdated = std::move(asked_.scene);
            asked_.scene = std::move(change.scene);
        }
        asked_.view = std::move(change.view);
        display_ = asked_.view->render_options.display;
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
    }
    const std::lock_guard lock(picture_mutex_);
    if (picture_) picture_->set_display(display);
}

void Session::set_paused(bool is_paused) {
    {
        const std::lock_guard lock(mutex_);
        is_paused_ = is_paused;
        status_.is_paused = is_paused;
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

std::optional<Pick> Session::pick(DVec2 position_pixel) {
    const std::lock_guard one_at_a_time(pick_mutex_);
    cancel_pick_ = false;
    if (is_scene_leaving_) return std::nullopt;  // from here on it is cancelled if that happens
    const std::shared_lock lock(scene_mutex_);
    if (!scene_) return std::nullopt;
    return render::pick(scene_->scene, scene_->world, *scene_->accel, scene_->sources, view_.camera,
                        view_.render_options.resolution, position_pixel, cancel_pick_);
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
        Change change;
        std::uint64_t number = 0;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [&] { return is_ending_ || is_change_asked_ || has_work(); });
            if (is_ending_) return;
            if (is_change_asked_) {
                change = std::exchange(asked_, {});
                number = asked_number_;
                is_change_asked_ = false;
                cancel_ = false;
                const Clock::time_point end = Clock::now() + kPatience;
                patience_end_ = end.time_since_epoch().count();
            }
        }
        if (number != 0) apply(std::move(change), number);
        run_step();
    }
}

void Session::apply(Change change, std::uint64_t number) {
    job_.reset();
    std::unique_ptr<const PreparedScene> outdated;
    {
        is_scene_leaving_ = true;
        cancel_pick_ = true;
        const std::unique_lock lock(scene_mutex_);
        is_scene_leaving_ = false;
        if (change.scene) outdated = std::exchange(scene_, std::move(change.scene));
        LRAY_ASSERT(scene_ != nullptr && change.view);
        view_ = std::move(*change.view);
    }
    show_picture();
    const RenderOptions& options = view_.render_options;
    const std::uint64_t pixel_count =
        std::uint64_t{options.resolution.width} * options.resolution.height;
    if (outdated) seconds_per_ray_ = 0.0;
    job_ = std::make_unique<ProgressiveJob>(*scene_, view_,
                                            first_square(seconds_per_ray_, pixel_count));
    const std::lock_guard lock(mutex_);
    status_.change = number;
    status_.square = 0;
    status_.passes = 0;
    status_.pass_limit = job_->pass_limit();
    status_.is_done = false;
}

/// Sees to it that there is a picture of the view's size, shown as it was asked for last.
void Session::show_picture() {
    image::DisplaySettings display;
    {
        const std::lock_guard lock(mutex_);
        display = display_;
    }
    const RenderOptions& options = view_.render_options;
    std::unique_ptr<LivePicture> other;
    if (!picture_ || picture_->resolution() != options.resolution) {
        other = std::make_unique<LivePicture>(options.resolution, display, picture_.get());
    }
    const std::lock_guard lock(picture_mutex_);
    if (other) {
        picture_.swap(other);
    } else {
        picture_->set_display(display);
    }
    area_ = options.crop.value_or(
        PixelRect{0, 0, options.resolution.width, options.resolution.height});
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
