// How much memory the program may take: a scene that wants more ends with a sentence, before the
// machine begins to swap.
#pragma once

#include <cstdint>

namespace lray::cli {

/// Returns 75 % of the machine's memory, or of the control group's if that has less; 0 if neither
/// is known.
std::uint64_t default_memory_limit();

/// Makes allocations beyond `bytes` fail (std::bad_alloc); 0 leaves them as they are. Under
/// AddressSanitizer and ThreadSanitizer, which reserve terabytes, nothing is done.
void limit_memory(std::uint64_t bytes);

}  // namespace lray::cli
