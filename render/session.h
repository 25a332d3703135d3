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
    std::uint64_t scene = 0;       // how many scenes there were, with that which is shown
    bool is_done = false;          // it has all its samples
    bool is_paused = false;
    bool is_idle = true;            // nothing will change by itself
    bool is_out_of_memory = false;  // it shows nothing any more

    // Of all views together:
    std::uint64_t total_passes = 0;
    double total_pass_seconds = 0.0;  // that those took, and no squares
};

using PickTicket = std::uint64_t;

struct PickResult {
    bool is_cancelled = false;
    std::optional<Pick> found{};  // empty if nothing is there
};

/// After each change the picture is shown in squares, then in smaller ones (preview.h), with one
/// sample of each light, then of all pixels; from there on each pass adds a sample to each pixel, P
/// = new / n + old (n - 1) / n: the same samples that render() takes, so that n passes show to the
/// bit what it makes of n samples. A change ends the step that is running, at once; but the first
/// step after a change is given kPatience to be complete, so that there is something to see while
/// changes go on without end. All functions may be called by any thread, and none waits for
/// rendering.
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

    /// Averages another part of the same view; what is around it stays as it is. There must be a
    /// scene.
    std::uint64_t set_crop(const std::optional<PixelRect>& crop);

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

    /// Returns what the view that is worked on shows at a position of the full picture. Waits for
    /// its ray, which may take long, and for picks of other threads.
    /// Shape: each ticket is from a call of its own.
    PickResult pick(DVec2 position_pixel, PickTicket ticket);
    PickTicket pick_ticket() { return ++last_ticket_; }

    /// Ends all picks whose tickets were given so far.
    void cancel_picks();

    /// Returns the cut through the hierarchy of the scene that is worked on
    /// (bvh::Accel::volumes()); none without a scene.
    BoundingVolumes volumes(std::uint32_t level, std::size_t max_count) const;

 private:
    struct Change {
        std::unique_ptr<const PreparedScene> scene{};
        View view{};
        bool needs_squares = false;  // more than the crop is another
    };
    using Clock = std::chrono::steady_clock;

    template <class Edit>
    std::uint64_t ask(const Edit& edit);
    void run();
    void work();
    void apply(Change change, std::uint64_t number);
    std::unique_ptr<const PreparedScene> replace_scene(std::unique_ptr<const PreparedScene> scene);
    void show_picture();
    image::DisplaySettings display() const;
    bool has_work() const;
    void end_outdated_step();
    bool should_stop(bool may_pause);
    void run_step();

    // What is asked for, and what is told of it: guarded by mutex_.
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    Change asked_{};                  // its view is that of the last change
    std::uint64_t asked_number_ = 0;  // of the last change
    image::DisplaySettings display_{};
    bool is_ending_ = false;
    SessionStatus status_{};

    // What the threads of a step look at.
    std::atomic<bool> cancel_{false};
    std::atomic<bool> is_change_asked_{false};
    std::atomic<bool> is_paused_{false};
    std::atomic<Clock::rep> patience_end_{0};  // until then no change ends the step

    std::mutex pick_mutex_;                   // one at a time
    std::atomic<PickTicket> last_ticket_{0};  // that was given
    PickTicket cancelled_ticket_ = 0;         // and all before: guarded by mutex_
    bool is_scene_leaving_ = false;           // likewise
    std::atomic<bool> cancel_pick_{false};

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
