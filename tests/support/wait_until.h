// Waiting for what other threads or programs do.
#pragma once

#include <chrono>
#include <thread>

namespace lray::test {

/// Asks every few milliseconds whether the condition holds, and returns whether it came to that.
/// What counts is how often was asked: while the machine stands still, no time passes.
template <class Condition>
bool wait_until(Condition condition, std::chrono::milliseconds period,
                std::chrono::seconds limit = std::chrono::seconds(30)) {
    for (auto left = limit / period; left > 0; --left) {
        if (condition()) return true;
        std::this_thread::sleep_for(period);
    }
    return condition();
}

}  // namespace lray::test
