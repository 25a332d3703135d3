// File descriptors: who closes them, and what a failed system call means in words.
#pragma once

#include <string>

namespace lray {

/// Owns a file descriptor. Default-made: none.
class Descriptor {
 public:
    Descriptor() = default;
    explicit Descriptor(int fd) : fd_(fd) {}
    Descriptor(Descriptor&& other) noexcept : fd_(other.release()) {}
    Descriptor& operator=(Descriptor&& other) noexcept;
    ~Descriptor() { close(); }

    bool is_open() const { return fd_ >= 0; }
    int fd() const { return fd_; }

    /// Gives the descriptor away.
    int release();

    /// Returns false when the system reports that what was written is lost (see errno).
    bool close();

 private:
    int fd_ = -1;
};

/// Returns what an errno means, as part of a sentence: "permission denied".
std::string error_words(int error);

}  // namespace lray
