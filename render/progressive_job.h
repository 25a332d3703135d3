// One view on its way from squares to an average of many samples, step by step.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "image/tone_map.h"
#include "render/block.h"
#include "render/live_picture.h"
#include "render/prepared_scene.h"
#include "render/sample_tracer.h"
#include "render/squares.h"
#include "render/view.h"

namespace lray::render {

/// What may end a step early, and when its picture is seen.
struct StepControl {
    std::function<bool()> should_stop{};  // asked by any thread, between tiles
    const std::atomic<bool>& cancel;      // looked at between batches of rays
    /// Until then the results of a step are kept back, and shown once it is complete: parts of two
    /// views side by side look torn.
    std::chrono::steady_clock::time_point show_from{};
};

struct StepOutcome {
    bool is_complete = true;
    std::uint64_t sample_count = 0;  // rays from the camera
    std::uint64_t ray_count = 0;     // of all kinds
    double seconds = 0.0;
};

class ProgressiveJob {
 public:
    /// Begins with squares of that side, a power of two; 0: with the first pass. The scene must
    /// outlive it. Once `cancel` is set it is of no use.
    ProgressiveJob(const PreparedScene& scene, const View& view, std::uint32_t first_square,
                   const std::atomic<bool>& cancel);

    bool is_done() const { return is_done_; }

    /// True once no pixel stands for others any more: that much is worth while even of a view that
    /// is not averaged.
    bool shows_every_pixel() const {
        return pass_count_ > 0 || (is_pass_next() && has_quick_rays_);
    }

    /// True if rays of squares cost less than those of passes: they take one sample of each light.
    bool has_quick_rays() const { return has_quick_rays_; }

    /// True if the next step adds to the average, false if it shows squares.
    bool is_pass_next() const { return square_ == 0; }
    std::uint32_t next_square() const { return is_pass_next() ? 1 : square_; }

    /// Complete ones; with a limit of noise pixels may have had fewer samples.
    std::uint32_t pass_count() const { return pass_count_; }
    std::uint32_t pass_limit() const { return view_.render_options.samples.count(); }

    /// Does the next step, on all threads of the task arena it is called in. One that was stopped
    /// is taken up again by the next call where it was left; after a cancel the job is of no more
    /// use.
    StepOutcome run_step(LivePicture& picture, const StepControl& control);

 private:
    struct Step;
    using Tile = std::vector<Block>;

    void run_squares(Step& step) const;
    void run_pass(Step& step);

    View view_{};
    SampleTracer tracer_;
    SampleTracer quick_tracer_;  // of squares
    bool has_quick_rays_ = false;
    std::uint32_t square_ = 0;       // of the next step; 0: a pass
    std::uint32_t last_square_ = 2;  // of those before the passes
    std::uint32_t pass_count_ = 0;   // that are complete
    double pass_seconds_ = 0.0;      // that they took
    std::uint64_t finished_pixels_ = 0;
    bool is_done_ = false;
    std::vector<Tile> tiles_{};  // empty until they are reached
};

}  // namespace lray::render
