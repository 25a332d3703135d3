// A process that gives up all it does not need before it looks at what a stranger has made.
#pragma once

#include <cstdint>

namespace lray::import {

/// Leaves the process its standard streams, memory and time up to these limits, and reading,
/// writing and memory as the only calls to the system: no file, process or connection can be
/// opened, nothing new executed. What is asked for all the same fails (files) or ends the process
/// by SIGSYS. Where the system lacks Landlock or seccomp the rest still holds. With a sanitizer,
/// which reserves terabytes, memory has no limit.
/// Errors: false if one of the limits that every system has cannot be set.
bool confine(std::uint64_t max_bytes, std::uint64_t max_seconds);

}  // namespace lray::import
