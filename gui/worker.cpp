#include "gui/worker.h"

#include <new>
#include <stdexcept>
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

void Worker::start(Job job, Completion without_memory) {
    {
        const std::lock_guard lock(mutex_);
        tasks_.push_back({std::move(job), std::move(without_memory)});
    }
    wake_.notify_all();
}

void Worker::finish() {
    std::unique_lock lock(mutex_);
    done_.wait(lock, [&] { return !is_running_ && tasks_.empty(); });
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
    return is_running_ || !tasks_.empty() || !completions_.empty();
}

Worker::Completion Worker::completion_of(const Task& task) {
    try {
        return task.job();
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    return task.without_memory;
}

void Worker::run() {
    for (;;) {
        Task task;
        {
            std::unique_lock lock(mutex_);
            is_running_ = false;
            done_.notify_all();
            wake_.wait(lock, [&] { return is_ending_ || !tasks_.empty(); });
            if (is_ending_) return;
            task = std::move(tasks_.front());
            tasks_.pop_front();
            is_running_ = true;
        }
        Completion complete = completion_of(task);
        const std::lock_guard lock(mutex_);
        completions_.push_back(std::move(complete));
    }
}

}  // namespace lray::gui
