// A thread beside that of the window, for what takes long.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace lray::gui {

/// Does jobs one after the other. What a job returns is called by the thread that asks for it
/// (poll()), so that only jobs themselves run elsewhere; for a job without memory enough, what was
/// given for that.
class Worker {
 public:
    using Completion = std::function<void()>;
    using Job = std::function<Completion()>;

    Worker();
    ~Worker();  // waits for the job that runs; others are dropped, unless finish() was called
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    void start(Job job, Completion without_memory);

    /// Waits until all jobs are done.
    void finish();

    /// Calls what the jobs that have ended returned, in order.
    void poll();

    /// True while a job runs or waits, or its end was not polled.
    bool is_busy() const;

 private:
    struct Task {
        Job job{};
        Completion without_memory{};
    };

    void run();
    static Completion completion_of(const Task& task);

    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::condition_variable done_;
    std::deque<Task> tasks_;
    std::vector<Completion> completions_;
    bool is_running_ = false;
    bool is_ending_ = false;
    std::thread thread_;
};

}  // namespace lray::gui
