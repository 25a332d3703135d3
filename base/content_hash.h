// A fingerprint of bytes, to tell whether they are the same as at another time. It keeps nobody
// from making two files of one fingerprint on purpose.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace lray {

/// 128 bits of all that was added, in order; how it was cut into pieces does not matter.
class ContentHash {
 public:
    void add(std::span<const std::byte> bytes);
    void add(std::string_view text) { add(std::as_bytes(std::span(text))); }

    /// 32 hexadecimal digits.
    std::string text() const;

    /// 64 of the bits.
    std::uint64_t value() const { return finished()[0]; }

 private:
    using Lanes = std::array<std::uint64_t, 2>;
    static Lanes mixed(Lanes lanes, std::uint64_t word);
    Lanes finished() const;

    Lanes lanes_{0x243f6a8885a308d3u, 0x13198a2e03707344u};  // digits of pi
    std::uint64_t size_ = 0;
    std::array<std::byte, 8> rest_{};  // of the last word, which is not complete
};

}  // namespace lray
