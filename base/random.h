// Random numbers that are functions of keys: the same keys give the same number on every machine,
// in any order and on any thread. There is no state to share or to advance.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace lray {

/// Mixes 64 bits so that each bit of the result depends on each bit of x; a bijection.
/// Source: Steele, Lea, Flood 2014, "Fast Splittable Pseudorandom Number Generators" (SplitMix64),
/// with the constants of Stafford's variant 13.
constexpr std::uint64_t mix_bits(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// A number chosen by keys: `KeyedRandom{}.with(seed).with(i).number()`.
class KeyedRandom {
 public:
    constexpr KeyedRandom() = default;

    [[nodiscard]] constexpr KeyedRandom with_bits(std::uint64_t key) const {
        return KeyedRandom(mix_bits(state_ + key));
    }
    /// -0 is the same key as 0.
    [[nodiscard]] constexpr KeyedRandom with(double key) const {
        return with_bits(std::bit_cast<std::uint64_t>(key == 0.0 ? 0.0 : key));
    }
    /// Source: Fowler, Noll, Vo, "The FNV Non-Cryptographic Hash Algorithm": FNV-1a, 64 bits.
    [[nodiscard]] constexpr KeyedRandom with(std::string_view key) const {
        std::uint64_t hash = 0xcbf29ce484222325u;
        for (const char c : key) {
            hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
        }
        return with_bits(hash);
    }

    constexpr std::uint64_t bits() const { return state_; }

    /// Uniform in [0, 1), a multiple of 2^-53.
    constexpr double number() const { return static_cast<double>(state_ >> 11) * 0x1p-53; }

 private:
    explicit constexpr KeyedRandom(std::uint64_t state) : state_(state) {}

    std::uint64_t state_ = 0x9e3779b97f4a7c15u;
};

}  // namespace lray
