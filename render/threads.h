// How many threads a stage may use: building a hierarchy and rendering keep to the same number.
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstdint>

namespace lray::render {

/// Returns how many threads `asked` stands for: 0 is one for each processor.
std::uint32_t thread_count_of(std::uint32_t asked);

/// Calls `work` where whatever it does in parallel uses at most so many threads; 0 is all.
template <class Work>
void with_threads(std::uint32_t asked, const Work& work) {
    const std::uint32_t count = thread_count_of(asked);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
    tbb::task_arena arena(static_cast<int>(count));
    arena.execute(work);
}

}  // namespace lray::render
