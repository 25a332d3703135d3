#include "base/parse_number.h"

#include <charconv>
#include <system_error>

#include "base/assert.h"

namespace lray::detail {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Returns true if a number that is out of a double's range is so because it is large: if its
/// first significant digit stands before the decimal point.
bool is_large(const char* begin, const char* end) {
    // All of this in 64 bits: a text has less than 2^32 bytes.
    std::int64_t magnitude = 0;
    bool in_fraction = false;
    bool is_significant = false;
    const char* at = begin;
    for (; at < end && (is_digit(*at) || *at == '.'); ++at) {
        if (*at == '.') {
            in_fraction = true;
            continue;
        }
        is_significant = is_significant || *at != '0';
        if (is_significant && !in_fraction) ++magnitude;
        if (!is_significant && in_fraction) --magnitude;
    }
    if (!is_significant) return false;
    if (at == end) return magnitude > 0;

    ++at;
    const bool is_negative = *at == '-';
    if (*at == '+' || *at == '-') ++at;
    constexpr std::int64_t kEnough = std::int64_t{1} << 40;  // beyond any count of digits
    std::int64_t exponent = 0;
    for (; at < end && exponent < kEnough; ++at) exponent = exponent * 10 + (*at - '0');
    return (is_negative ? magnitude - exponent : magnitude + exponent) > 0;
}

}  // namespace

double convert_decimal(const char* begin, const char* end) {
    double value = 0.0;
    const std::from_chars_result result = std::from_chars(begin, end, value);
    // from_chars does not say on which side a number is out of range.
    if (result.ec == std::errc::result_out_of_range) {
        return is_large(begin, end) ? std::numeric_limits<double>::infinity() : 0.0;
    }
    LRAY_ASSERT(result.ec == std::errc{} && result.ptr == end);
    return value;
}

}  // namespace lray::detail
