// Assertions: a failed one is our bug, never a user's mistake.
#pragma once

namespace lray {

/// Prints the failed condition with its place and ends the process with exit code 70.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace lray

/// Always on.
#define LRAY_ASSERT(condition) \
    ((condition) ? static_cast<void>(0) : ::lray::assertion_failed(#condition, __FILE__, __LINE__))

/// The same in hot loops: on in debug builds only.
#ifdef NDEBUG
#define LRAY_DCHECK(condition) static_cast<void>(0)
#else
#define LRAY_DCHECK(condition) LRAY_ASSERT(condition)
#endif
