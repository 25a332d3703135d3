// The lattice of whole numbers that noise stands on: which cell a coordinate is in, and a hash for
// each cell.
#pragma once

#include <cmath>
#include <cstdint>

#include "base/random.h"

namespace lray {

/// The cell of one coordinate, and the place inside it.
struct LatticeCell {
    std::uint64_t index = 0;  // modulo 2^64
    double inside = 0.0;      // in [0, 1]

    explicit LatticeCell(double x) {
        const double cell = std::floor(x);
        inside = x - cell;  // NaN for NaN and infinities
        // Coordinates from 2^53 on are whole; what is too large for an index shares cell 0.
        constexpr double kTooLarge = 0x1p62;
        if (std::fabs(cell) < kTooLarge) {
            index = static_cast<std::uint64_t>(static_cast<std::int64_t>(cell));
        }
    }
};

// Odd, with bits like those of noise: the fractions of sqrt(2), sqrt(3) and sqrt(5).
inline constexpr std::uint64_t kLatticeX = 0x6a09e667f3bcc909u;
inline constexpr std::uint64_t kLatticeY = 0xbb67ae8584caa73bu;
inline constexpr std::uint64_t kLatticeZ = 0x3c6ef372fe94f82bu;

constexpr std::uint64_t lattice_hash(std::uint64_t seed, std::uint64_t i, std::uint64_t j = 0,
                                     std::uint64_t k = 0) {
    return mix_bits(seed + i * kLatticeX + j * kLatticeY + k * kLatticeZ);
}

/// Three independent numbers in [0, 1) of 64 bits.
constexpr double first_third(std::uint64_t bits) {
    return static_cast<double>(bits >> 43) * 0x1p-21;
}
constexpr double second_third(std::uint64_t bits) {
    return static_cast<double>((bits >> 22) & 0x1fffffu) * 0x1p-21;
}
constexpr double last_third(std::uint64_t bits) {
    return static_cast<double>((bits >> 1) & 0x1fffffu) * 0x1p-21;
}

}  // namespace lray
