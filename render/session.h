// A picture that follows what is asked for: rendered on threads of its own, step by step, while
// camera, size and scene are replaced. No window is needed.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <thread>

#include "bvh/bounding_volume.h"
#include "image/image.h"
#include "image/tone_map.h"
#include "render/live_picture.h"
#include "render/pick.h"
#include "render/prepared_scene.h"
#include "render/progressive_job.h"
#include "render/view.h"

namespace lray::render {

using bvh::BoundingVolume;
using bvh::BoundingVolumes;

struct SessionStatus {
    std::uint64_t change = 0;      // the change (of set_scene(), set_view()) that is worked on
    std::uint32_t square = 0;      // side of the squares shown, in pixels; 0: nothing of it yet
    std::uint32_t passes = 0;      // over all pixels, that are averaged
    std::uint32_t pass_limit = 0;  // then it is done
    double rays_per_second = 0.0;  // of the last step, of all kinds
    bool is_done = false;          // nothing will change by itself
    bool is_paused = false;
    bool is_out_of_memory = false;  // it shows nothing any more

    // Of all views together:
    std::uint64_t total_passes = 0;
    double total_pass_seconds = 0.0;  // that those took, and no squares
};

/// After each change the picture is shown in squares, then in smaller ones (preview.h), with one
/// sample of each light, then of all pixels; from there on each pass adds a sample to each pixel, P = new / n + old (n - 1) / n: the
/// same samples that render() takes, so that n passes show to the bit what it makes of n samples.
/// A change ends the step that is running, at once; but the first step after a change is given
/// kPatience to be complete, so that there is something to see while changes go on without end.
/// All functions may be called by any thread, and none waits for rendering.
class Session {
 public:
    static constexpr std::chrono::milliseconds kPatience{100};

    Session();
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Shows another scene, or another view of the same. Returns the number of the change.
    std::uint64_t set_scene(std::unique_ptr<const PreparedScene> scene, const View& view);
    std::uint64_t set_view(const View& view);

    /// Shows the same light in another way; nothing is rendered anew.
    void set_display(const image::DisplaySettings& display);

    /// Paused, a picture of single pixels gets no more samples; that of a new view becomes one.
    void set_paused(bool is_paused);

    SessionStatus status() const;

    /// Brings a copy of the screen up to date; to be called now and then. Returns the rows that
    /// changed; empty if none did, or as long as there is nothing to show.
    std::optional<RowRange> update(Frame& frame);

    /// Returns the light shown, of the crop if there is one.
    image::Image light() const;

    /// Returns what the view that is worked on shows at a position of the full picture; empty if
    /// that is nothing, or once it is cancelled. Waits for its ray, which may take long.
    std::optional<Pick> pick(DVec2 position_pixel);

    /// Ends a pick of another thread.
    void cancel_pick() { cancel_pick_ = true; }

    /// Returns the cut through the hierarchy of the scene that is worked on (bvh::Accel::volumes());
    /// none without a scene.
    BoundingVolumes volumes(std::uint32_t level, std::size_t max_count) const;

 private:
    struct Change {
        std::unique_ptr<const PreparedScene> scene{};
        std::optional<View> view{};
    };
    using Clock = std::chrono::steady_clock;

    std::uint64_t request(Change change);
    void run();
    void work();
    void apply(Change change, std::uint64_t number);
    void show_picture();
    bool has_work() const;
    void end_outdated_step();
    bool should_stop(bool may_pause);
    void run_step();

    // What is asked for, and what is told of it: guarded by mutex_.
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    Change asked_{};
    std::uint64_t asked_number_ = 0;
    image::DisplaySettings display_{};
    bool is_ending_ = false;
    SessionStatus status_{};

    // What the threads of a step look at.
    std::atomic<bool> cancel_{false};
    std::atomic<bool> is_change_asked_{false};
    std::atomic<bool> is_paused_{false};
    std::atomic<Clock::rep> patience_end_{0};  // until then no change ends the step

    std::mutex pick_mutex_;  // one at a time
    std::atomic<bool> cancel_pick_{false};
    std::atomic<bool> is_scene_leaving_{false};

    // Written by the session's thread alone, under the lock; it reads without.
    mutable std::shared_mutex scene_mutex_;
    std::unique_ptr<const PreparedScene> scene_;
    View view_{};
    mutable std::mutex picture_mutex_;
    std::unique_ptr<LivePicture> picture_;
    PixelRect area_{};  // of the picture, that is averaged

    std::unique_ptr<ProgressiveJob> job_;  // of the session's thread
    double seconds_per_ray_ = 0.0;         // from the camera, all threads together; 0: not known

    std::thread thread_;  // the last: it uses all the others
};

}  // namespace lray::render
