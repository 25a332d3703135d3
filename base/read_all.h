// Reading a descriptor to its end, within a bound.
#pragma once

#include <cstdint>
#include <optional>

#include "base/source.h"

namespace lray {

struct ReadAll {
    std::optional<Text> text{};
    bool is_too_large = false;
    int error = 0;  // errno
};

/// Reads to the end, also when there is less or more than `expected_size`. Read, not mapped: a
/// mapping of a file that someone else shortens kills the process.
/// Errors: no text, and the reason; std::bad_alloc. Never more than `max_size` + 1 bytes are
/// reserved.
ReadAll read_all(int fd, std::uint64_t expected_size, std::uint64_t max_size);

}  // namespace lray
