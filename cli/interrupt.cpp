#include "cli/interrupt.h"

#include <csignal>

namespace lray::cli {

namespace {

// Signal handlers reach nothing but globals. Both are lock-free, hence safe there.
std::atomic<bool> g_stop_requested{false};
std::atomic<int> g_signal{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

extern "C" void on_signal(int number) {
    g_signal = number;
    g_stop_requested = true;
}

void catch_signal(int number) {
    struct sigaction before {};
    if (sigaction(number, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) return;
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, nullptr);
}

}  // namespace

void catch_interrupts() {
    catch_signal(SIGINT);
    catch_signal(SIGTERM);
}

const std::atomic<bool>& stop_requested() {
    return g_stop_requested;
}

std::optional<ExitCode> interrupt_exit_code() {
    switch (g_signal.load()) {
        case SIGINT:
            return ExitCode::interrupted;
        case SIGTERM:
            return ExitCode::terminated;
        default:
            return std::nullopt;
    }
}

void ignore_broken_pipes() {
    std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace lray::cli
