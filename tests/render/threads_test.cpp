#include "render/threads.h"

#include <gtest/gtest.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

namespace lray::render {
namespace {

TEST(Threads, ZeroIsAllProcessors) {
    EXPECT_EQ(thread_count_of(0), static_cast<std::uint32_t>(tbb::info::default_concurrency()));
    EXPECT_EQ(thread_count_of(5), 5u);
}

TEST(Threads, WorkUsesNoMoreThreadsThanAsked) {
    for (const std::uint32_t count : {1u, 2u, 3u}) {
        int seen = 0;
        with_threads(count, [&] { seen = tbb::this_task_arena::max_concurrency(); });
        EXPECT_EQ(seen, static_cast<int>(count));
    }
}

}  // namespace
}  // namespace lray::render
