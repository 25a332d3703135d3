// What sanitizers do to the process that they are built into.
#pragma once

// gcc defines a macro, clang answers a question.
#if defined(__has_feature)
#define LRAY_HAS_FEATURE(name) __has_feature(name)
#else
#define LRAY_HAS_FEATURE(name) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || \
    LRAY_HAS_FEATURE(address_sanitizer) || LRAY_HAS_FEATURE(thread_sanitizer)
#define LRAY_RESERVES_TERABYTES 1
#else
#define LRAY_RESERVES_TERABYTES 0
#endif

namespace lray {

/// True if memory cannot be limited by addresses: they reserve terabytes, most of it never used.
inline constexpr bool kReservesTerabytes = LRAY_RESERVES_TERABYTES != 0;

}  // namespace lray
