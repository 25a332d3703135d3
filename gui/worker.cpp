#include "gui/worker.h"

#include <utility>

namespace lray::gui {

Worker::Worker() : thread_([this] { run(); }) {}

Worker::~Worker() {
    {
        const std::lock_guard lock(mutex_);
        is_ending_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

void Worker::start(Job job) {
    {
        const std::lock_guard lock(mutex_);
        jobs_.push_back(std::move(job));
    }
    wake_.notify_all();
}

void Worker::poll() {
    std::vector<Completion> completions;
    {
        const std::lock_guard lock(mutex_);
        completions.swap(completions_);
    }
    for (const Completion& complete : completions) {
        if (complete) complete();
    }
}

bool Worker::is_busy() const {
    const std::lock_guard lock(mutex_);
    return is_running_ || !jobs_.empty() || !completions_.empty();
}

void Worker::run() {
    for (;;) {
        Job job;
        {
            std::unique_lock lock(mutex_);
            is_running_ = false;
            wake_.wait(lock, [&] { return is_ending_ || !jobs_.empty(); });
            if (is_ending_) return;
            job = std::move(jobs_.front());
            jobs_.pop_front();
            is_running_ = true;
        }
        Completion complete = job();
        const std::lock_guard lock(mutex_);
        completions_.push_back(std::move(complete));
    }
}

}  // namespace lray::gui
