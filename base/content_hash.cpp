#include "base/content_hash.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace lray {

namespace {

constexpr std::size_t kWordSize = 8;

std::uint64_t word_at(const std::byte* bytes) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, kWordSize);
    return word;
}

/// Source: Stafford 2011, "Better Bit Mixing", mix 13: every bit reaches every bit.
std::uint64_t scattered(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

}  // namespace

/// Two multiplications by odd numbers, which lose nothing; the shift brings high bits down again.
ContentHash::Lanes ContentHash::mixed(Lanes lanes, std::uint64_t word) {
    lanes[0] = (lanes[0] ^ word) * 0x9e3779b97f4a7c15u;
    lanes[0] ^= lanes[0] >> 32;
    lanes[1] = (lanes[1] + word) * 0xd6e8feb86659fd93u;
    lanes[1] ^= lanes[1] >> 29;
    return lanes;
}

void ContentHash::add(std::span<const std::byte> bytes) {
    const std::size_t begun = size_ % kWordSize;
    size_ += bytes.size();
    if (begun != 0) {
        const std::size_t count = std::min(kWordSize - begun, bytes.size());
        std::copy_n(bytes.begin(), count, rest_.begin() + static_cast<std::ptrdiff_t>(begun));
        if (begun + count < kWordSize) return;
        lanes_ = mixed(lanes_, word_at(rest_.data()));
        bytes = bytes.subspan(count);
    }
    Lanes lanes = lanes_;
    for (; bytes.size() >= kWordSize; bytes = bytes.subspan(kWordSize)) {
        lanes = mixed(lanes, word_at(bytes.data()));
    }
    lanes_ = lanes;
    std::copy(bytes.begin(), bytes.end(), rest_.begin());
}

ContentHash::Lanes ContentHash::finished() const {
    std::array<std::byte, kWordSize> last{};
    std::copy_n(rest_.begin(), size_ % kWordSize, last.begin());
    const Lanes lanes = mixed(mixed(lanes_, word_at(last.data())), size_);
    return {scattered(lanes[0]), scattered(lanes[1])};
}

std::string ContentHash::text() const {
    const Lanes lanes = finished();
    return fmt::format("{:016x}{:016x}", lanes[0], lanes[1]);
}

}  // namespace lray
