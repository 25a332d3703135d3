#include "gui/worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

namespace lray::gui {
namespace {

using namespace std::chrono_literals;

void wait_for(Worker& worker) {
    while (worker.is_busy()) {
        worker.poll();
        std::this_thread::sleep_for(1ms);
    }
}

TEST(Worker, DoesJobsInOrderAndCompletesThemHere) {
    Worker worker;
    const std::thread::id here = std::this_thread::get_id();
    std::vector<int> order;
    for (int i = 0; i < 20; ++i) {
        worker.start(
            [&, i]() -> Worker::Completion {
                EXPECT_NE(std::this_thread::get_id(), here);
                return [&, i] {
                    EXPECT_EQ(std::this_thread::get_id(), here);
                    order.push_back(i);
                };
            },
            {});
    }
    wait_for(worker);
    ASSERT_EQ(order.size(), 20u);
    for (int i = 0; i < 20; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
}

TEST(Worker, ACompletionMayStartTheNextJob) {
    Worker worker;
    int count = 0;
    std::function<void()> next = [&] {
        if (++count < 5) worker.start([&]() -> Worker::Completion { return next; }, {});
    };
    next();
    wait_for(worker);
    EXPECT_EQ(count, 5);
}

TEST(Worker, ItsEndWaitsForTheJobThatRunsAndDropsTheOthers) {
    std::atomic<int> done{0};
    std::atomic<bool> has_begun{false};
    {
        Worker worker;
        worker.start(
            [&]() -> Worker::Completion {
                has_begun = true;
                std::this_thread::sleep_for(20ms);
                ++done;
                return {};
            },
            {});
        while (!has_begun) std::this_thread::sleep_for(1ms);
        for (int i = 0; i < 5; ++i) {
            worker.start(
                [&]() -> Worker::Completion {
                    ++done;
                    return {};
                },
                {});
        }
    }
    EXPECT_EQ(done, 1);
}

TEST(Worker, FinishWaitsForAll) {
    std::atomic<int> done{0};
    Worker worker;
    for (int i = 0; i < 5; ++i) {
        worker.start(
            [&]() -> Worker::Completion {
                std::this_thread::sleep_for(1ms);
                ++done;
                return {};
            },
            {});
    }
    worker.finish();
    EXPECT_EQ(done, 5);
}

TEST(Worker, WithoutMemoryTheOtherCompletionIsCalled) {
    Worker worker;
    int told = 0;
    worker.start([]() -> Worker::Completion { throw std::bad_alloc(); }, [&] { ++told; });
    worker.start([]() -> Worker::Completion { throw std::length_error("long"); }, [&] { ++told; });
    wait_for(worker);
    EXPECT_EQ(told, 2);
}

}  // namespace
}  // namespace lray::gui
