// Runs a function on a large stack of its own: how deep the functions of a scene may call each
// other must not depend on the shell's limits.
#pragma once

#include <functional>

namespace lray::parser {

/// Calls the function, with the address that its stack must not grow below, and waits for it. What
/// it throws is thrown again here. Where no thread can be made it runs on the caller's stack.
void run_on_deep_stack(const std::function<void(const char* stack_end)>& function);

}  // namespace lray::parser
