// Text that goes to a file piece by piece.
#pragma once

#include <cstddef>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "base/output_file.h"

namespace lray::bench {

/// Errors: what could not be written is told by finish(), and the file's error() tells why.
class TextWriter {
 public:
    explicit TextWriter(OutputFile& file) : file_(file) {}

    template <class... Args>
    void print(fmt::format_string<Args...> format, Args... args) {
        fmt::vformat_to(std::back_inserter(buffer_), fmt::string_view(format),
                        fmt::make_format_args(args...));
        if (buffer_.size() >= kPiece) flush();
    }

    void add(std::string_view bytes) {
        buffer_.append(bytes);
        if (buffer_.size() >= kPiece) flush();
    }

    /// Returns false if anything could not be written; the last call.
    bool finish() {
        flush();
        return is_good_ && file_.commit();
    }

 private:
    static constexpr std::size_t kPiece = std::size_t{1} << 20;

    void flush() {
        is_good_ = is_good_ && file_.write(std::string_view(buffer_.data(), buffer_.size()));
        buffer_.clear();
    }

    OutputFile& file_;
    fmt::memory_buffer buffer_;
    bool is_good_ = true;
};

}  // namespace lray::bench
