// Counts what is done of a render, on all threads, and tells it now and then.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>

#include "render/render.h"

namespace lray::render {

class ProgressMeter {
 public:
    /// `total` is what there is to do and the limits; nothing of it is done but what was kept.
    ProgressMeter(const RenderProgress& total, const ProgressFunction& on_progress)
        : total_(total), on_progress_(on_progress), done_samples_(total.kept_samples) {}

    void add(std::uint64_t sample_count, std::uint64_t finished_pixels) {
        done_pixels_ += finished_pixels;
        done_samples_ += sample_count;
        if (!on_progress_) return;
        // Whoever finds another thread reporting goes on: nobody waits.
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (!lock.owns_lock()) return;
        const auto now = std::chrono::steady_clock::now();
        if (now < next_report_) return;
        next_report_ = now + kPeriod;
        RenderProgress progress = total_;
        progress.done_samples = done_samples_;
        progress.finished_pixels = done_pixels_;
        progress.seconds = seconds();
        on_progress_(progress);
    }

    /// Since it was made.
    double seconds() const {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
        return passed.count();
    }

 private:
    static constexpr std::chrono::milliseconds kPeriod{100};

    RenderProgress total_{};
    const ProgressFunction& on_progress_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::atomic<std::uint64_t> done_samples_;
    std::atomic<std::uint64_t> done_pixels_{0};
    std::mutex mutex_;
    std::chrono::steady_clock::time_point next_report_{};
};

}  // namespace lray::render
