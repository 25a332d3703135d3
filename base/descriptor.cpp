#include "base/descriptor.h"

#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace lray {

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
    if (this != &other) {
        close();
        fd_ = other.release();
    }
    return *this;
}

int Descriptor::release() {
    return std::exchange(fd_, -1);
}

bool Descriptor::close() {
    if (fd_ < 0) return true;
    // Never repeated: Linux has closed the descriptor even when a signal interrupted the call.
    return ::close(release()) == 0 || errno == EINTR;
}

std::string error_words(int error) {
    std::string words = std::generic_category().message(error);
    const bool starts_upper = words.size() > 1 && words[0] >= 'A' && words[0] <= 'Z' &&
                              words[1] >= 'a' && words[1] <= 'z';
    if (starts_upper) words[0] = static_cast<char>(words[0] - 'A' + 'a');
    return words;
}

}  // namespace lray
