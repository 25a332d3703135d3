#include "base/read_all.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace lray {
namespace {

ReadAll read_growing(int fd, std::uint64_t expected_size, std::uint64_t max_size) {
    constexpr std::uint64_t kMaxChunk = std::uint64_t{1} << 30;
    // One byte more than expected, so that the end is seen without growing.
    std::uint64_t capacity = std::min(expected_size, max_size) + 1;
    std::uint64_t size = 0;
    Text text = Text::uninitialized(capacity);
    while (true) {
        if (size == capacity) {
            if (size > max_size) return {std::nullopt, true, 0};
            capacity = std::min(std::max<std::uint64_t>(capacity * 2, 65536), max_size + 1);
            Text larger = Text::uninitialized(capacity);
            std::memcpy(larger.data(), text.data(), size);
            text = std::move(larger);
        }
        const ssize_t count = ::read(fd, text.data() + size, std::min(capacity - size, kMaxChunk));
        if (count == 0) break;
        if (count > 0) {
            size += static_cast<std::uint64_t>(count);
        } else if (errno != EINTR) {
            return {std::nullopt, false, errno};
        }
    }
    if (size > max_size) return {std::nullopt, true, 0};
    text.truncate(size);
    return {std::move(text), false, 0};
}

}  // namespace

ReadAll read_all(int fd, std::uint64_t expected_size, std::uint64_t max_size) {
    constexpr std::uint64_t kMostDoubled = std::uint64_t{1} << 62;  // sizes stay below 2^64
    max_size = std::min(max_size, kMostDoubled);
    if (expected_size > max_size) return {std::nullopt, true, 0};
    return read_growing(fd, expected_size, max_size);
}

}  // namespace lray
