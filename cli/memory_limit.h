// How much memory the program may take: a scene that wants more ends with a sentence, before the
// machine begins to swap.
#pragma once

#include <cstdint>
#include <optional>

#include "cli/exit_code.h"

namespace lray::cli {

/// Returns what was asked for; otherwise 75 % of the machine's memory, or of the control group's
/// if that has less; 0 if neither is known.
std::uint64_t memory_limit(std::optional<std::uint64_t> wanted);

/// False in builds with sanitizers that reserve terabytes.
extern const bool kCanLimitMemory;

/// Makes allocations beyond `bytes` fail (std::bad_alloc), if that can be done; 0 leaves them as
/// they are.
void limit_memory(std::uint64_t bytes);

/// What is said when an allocation has failed.
Failure out_of_memory();

}  // namespace lray::cli
