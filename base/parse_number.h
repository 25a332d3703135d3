// Decimal text to numbers, fast and exact: the one routine behind the language's literals and the
// mesh readers. Signs, digit separators and unit suffixes belong to the callers.
#pragma once

#include <array>
#include <bit>
#include <cfloat>
#include <cstdint>
#include <cstring>
#include <limits>

#include "base/source.h"

namespace lray {

/// A run of at most eight decimal digits.
struct DigitRun {
    std::uint32_t value = 0;
    std::uint32_t count = 0;
};

inline constexpr std::size_t kMaxDigitRun = 8;
static_assert(Text::kPadding >= kMaxDigitRun);

/// By the count of a run: what digits before it are multiplied with.
inline constexpr std::array<std::uint32_t, kMaxDigitRun + 1> kRunPowersOfTen = {
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000};

/// Returns the digits that `at` begins with, at most eight, without a branch: the lengths of
/// numbers in a file are what a processor cannot predict.
/// Shape: eight bytes must be readable at `at`, as everywhere in a Text and at its end.
/// Source: Lemire 2021, "Number Parsing at a Gigabyte per Second", sec. 7 (eight digits in three
/// multiplications); shorter runs are shifted so that zeros lead.
inline DigitRun read_digit_run(const char* at) {
    static_assert(std::endian::native == std::endian::little);
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, at, sizeof bytes);
    bytes ^= 0x3030303030303030u;  // '0'..'9' become 0..9, nothing else does
    // The high bit of every byte above 9. A carry may spoil bytes after the first such one only.
    const std::uint64_t others = ((bytes + 0x7676767676767676u) | bytes) & 0x8080808080808080u;
    const auto count = static_cast<std::uint32_t>(std::countr_zero(others)) / 8;
    const std::uint32_t half_shift = 32 - 4 * count;
    bytes = bytes << half_shift << half_shift;  // in two steps, as a shift by 64 is undefined
    bytes = bytes * 10 + (bytes >> 8);
    constexpr std::uint64_t kPairs = 0x000000ff000000ffu;
    constexpr std::uint64_t kFirst = 100 + (std::uint64_t{1'000'000} << 32);
    constexpr std::uint64_t kSecond = 1 + (std::uint64_t{10'000} << 32);
    bytes = ((bytes & kPairs) * kFirst + ((bytes >> 16) & kPairs) * kSecond) >> 32;
    return {static_cast<std::uint32_t>(bytes), count};
}

/// A number found in a text.
struct ParsedNumber {
    double value = 0.0;         // correctly rounded; infinity exactly when it is too large
    const char* end = nullptr;  // behind its last character; null when there is no number

    bool is_found() const { return end != nullptr; }
    bool is_too_large() const { return value > std::numeric_limits<double>::max(); }
};

namespace detail {

inline constexpr std::array<double, 23> kPowersOfTen = {
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// Returns the value of the decimal number that [begin, end) is.
double convert_decimal(const char* begin, const char* end);

}  // namespace detail

/// Returns the longest decimal number that `at` begins with:
///     number   = ( digits [ "." [ digits ] ] | "." digits ) [ exponent ]
///     exponent = ( "e" | "E" ) [ "+" | "-" ] digits
/// `1e` and `1e+` are the number 1 and a rest. Independent of the locale.
/// Shape: `at` points into a Text or at its end.
/// Source: Clinger 1990, "How to Read Floating Point Numbers Accurately": an integer below 2^53
/// times or over a power of ten up to 10^22 is one rounding of two exact doubles.
inline ParsedNumber parse_decimal(const char* at) {
    static_assert(FLT_EVAL_METHOD == 0, "doubles must be computed as doubles");
    const char* const begin = at;
    std::uint64_t mantissa = 0;  // wraps when there are more digits than fit: not used then
    std::size_t digit_count = 0;
    const auto take_digits = [&] {
        DigitRun run;
        do {
            run = read_digit_run(at);
            mantissa = mantissa * kRunPowersOfTen[run.count] + run.value;
            digit_count += run.count;
            at += run.count;
        } while (run.count == kMaxDigitRun);
    };

    take_digits();
    std::size_t fraction_digit_count = 0;
    if (*at == '.') {
        const std::size_t integer_digit_count = digit_count;
        ++at;
        take_digits();
        fraction_digit_count = digit_count - integer_digit_count;
    }
    if (digit_count == 0) return {};

    std::int32_t power_of_ten = 0;
    bool is_long_exponent = false;
    if (*at == 'e' || *at == 'E') {
        const char* exponent = at + 1;
        const bool is_negative = *exponent == '-';
        if (*exponent == '+' || *exponent == '-') ++exponent;
        DigitRun run = read_digit_run(exponent);
        if (run.count > 0) {
            at = exponent + run.count;
            power_of_ten = static_cast<std::int32_t>(run.value);
            if (is_negative) power_of_ten = -power_of_ten;
            while (run.count == kMaxDigitRun) {
                is_long_exponent = true;
                run = read_digit_run(at);
                at += run.count;
            }
        }
    }

    constexpr std::size_t kMaxExactDigitCount = 19;  // 10^19 - 1 < 2^64
    constexpr std::uint64_t kMaxExactMantissa = std::uint64_t{1} << 53;
    constexpr std::int32_t kMaxExactPower = 22;
    if (digit_count <= kMaxExactDigitCount && mantissa <= kMaxExactMantissa && !is_long_exponent) {
        const auto exact = static_cast<double>(mantissa);
        power_of_ten -= static_cast<std::int32_t>(fraction_digit_count);
        if (power_of_ten <= 0 && power_of_ten >= -kMaxExactPower) {
            return {exact / detail::kPowersOfTen[static_cast<std::size_t>(-power_of_ten)], at};
        }
        if (power_of_ten > 0 && power_of_ten <= kMaxExactPower) {
            return {exact * detail::kPowersOfTen[static_cast<std::size_t>(power_of_ten)], at};
        }
    }
    return {detail::convert_decimal(begin, at), at};
}

}  // namespace lray
