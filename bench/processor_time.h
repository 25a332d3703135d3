// The clocks of the benchmarks.
#pragma once

#include <chrono>
#include <ctime>

namespace lray::bench {

/// Returns the processor time that this process has used on all its threads, in seconds: what else
/// the machine does is not in it, but for the caches it takes away.
inline double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

inline double wall_seconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

}  // namespace lray::bench
