#include "parser/evaluate/deep_stack.h"

#include <pthread.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>

namespace lray::parser {

namespace {

/// Only what is used becomes memory.
constexpr std::size_t kStackSize = std::size_t{512} << 20;

/// What is left for functions that are called without looking at the stack: expressions nested to
/// the limit, the system's library.
constexpr std::size_t kReserve = std::size_t{2} << 20;

struct Task {
    const std::function<void(const char*)>& function;
    std::exception_ptr thrown{};
};

const char* stack_end(std::size_t size) {
    const char here = 0;
    const auto address = reinterpret_cast<std::uintptr_t>(&here);
    return reinterpret_cast<const char*>(address - std::min<std::uintptr_t>(size, address));
}

void* run(void* argument) {
    Task& task = *static_cast<Task*>(argument);
    try {
        task.function(stack_end(kStackSize - kReserve));
    } catch (...) {
        task.thrown = std::current_exception();
    }
    return nullptr;
}

}  // namespace

void run_on_deep_stack(const std::function<void(const char*)>& function) {
    Task task{function, nullptr};
    pthread_attr_t attributes;
    pthread_t thread{};
    bool is_running = false;
    if (pthread_attr_init(&attributes) == 0) {
        is_running = pthread_attr_setstacksize(&attributes, kStackSize) == 0 &&
                     pthread_create(&thread, &attributes, run, &task) == 0;
        pthread_attr_destroy(&attributes);
    }
    if (!is_running) {
        constexpr std::size_t kUsualStack = std::size_t{8} << 20;
        rlimit limit{};
        const bool is_known = getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur < kUsualStack;
        const std::size_t size = is_known ? static_cast<std::size_t>(limit.rlim_cur) : kUsualStack;
        function(stack_end(size / 2));
        return;
    }
    pthread_join(thread, nullptr);
    if (task.thrown) std::rethrow_exception(task.thrown);
}

}  // namespace lray::parser
