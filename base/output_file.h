// The one way to write a file: beside the target, then renamed over it, so that a picture that was
// there before survives every failure.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lray {

/// A file being written. Destroyed without commit(), it leaves the target as it was.
class OutputFile {
 public:
    /// Opens the target for writing, before anything expensive is begun. "-" is stdout; what is
    /// not a regular file (/dev/stdout, a FIFO) is written directly. A symbolic link stays, and
    /// what it points to is written. The permissions are the old file's, else as the umask gives.
    /// Sweeps temporaries that a killed process left beside the target.
    /// Errors: empty, and `error` tells why in words.
    static std::optional<OutputFile> open(const std::string& path, std::string& error);

    OutputFile(OutputFile&&) noexcept;
    OutputFile& operator=(OutputFile&&) noexcept;
    ~OutputFile();

    /// Returns false when the bytes, or those before, could not be written; error() tells why. A
    /// closed pipe is such a failure when SIGPIPE is ignored.
    bool write(std::span<const std::byte> bytes);
    bool write(std::string_view text);

    /// Flushes to the disk and renames over the target; the last call. Returns false as write().
    bool commit();

    const std::string& error() const;

 private:
    struct State;
    explicit OutputFile(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace lray
