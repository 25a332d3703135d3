// Fuzzes the PNG reader, as the bytes are and with the checksums of chunks made right: else hardly
// anything that is changed would be looked at.
#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tests/fuzz/fuzz_picture.h"

namespace {

std::uint32_t number_at(std::span<const std::uint8_t> bytes) {
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 |
           std::uint32_t{bytes[2]} << 8 | bytes[3];
}

/// Puts the checksum of each chunk behind it.
void mend_checksums(std::span<std::uint8_t> file) {
    constexpr std::size_t kSignatureSize = 8;
    constexpr std::size_t kChunkFrame = 12;  // length, kind and checksum
    std::span<std::uint8_t> rest = file.subspan(std::min(kSignatureSize, file.size()));
    while (rest.size() >= kChunkFrame) {
        const std::size_t length = number_at(rest);
        if (length > rest.size() - kChunkFrame) return;
        const auto sum = static_cast<std::uint32_t>(
            crc32(0, rest.data() + 4, static_cast<unsigned>(length + 4)));
        for (std::size_t i = 0; i < 4; ++i) {
            rest[length + 8 + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
        }
        rest = rest.subspan(length + kChunkFrame);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    lray::fuzz::read_picture(std::as_bytes(std::span(data, size)));
    std::vector<std::uint8_t> file(data, data + size);
    mend_checksums(file);
    lray::fuzz::read_picture(std::as_bytes(std::span(file)));
    return 0;
}
