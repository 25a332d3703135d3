// Reads the values of options: each function stores one. All return an empty string, or what is
// wrong as the end of a sentence that begins with the option's name.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.h"

namespace lray::cli {

/// Reads a whole number from `low` to `high` into `target`.
template <class Integer>
std::string store_number(Integer& target, std::string_view text, std::uint64_t low,
                         std::uint64_t high = std::numeric_limits<Integer>::max());

std::string store_level(Options& options, std::string_view text);
std::string store_samples(Options& options, std::string_view text);
std::string store_sample_range(Options& options, std::string_view text);
std::string store_time(Options& options, std::string_view text);
std::string store_duration(double& seconds, std::string_view text);
std::string store_noise(Options& options, std::string_view text);
std::string store_sampler(Options& options, std::string_view text);
std::string store_size(Options& options, std::string_view text);
std::string store_crop(Options& options, std::string_view text);
std::string store_accel(Options& options, std::string_view text);
std::string store_quality(Options& options, std::string_view text);
std::string store_shading(Options& options, std::string_view text);
std::string store_stats(Options& options, std::string_view text);
std::string store_format(Options& options, std::string_view text);
std::string store_png_bits(Options& options, std::string_view text);
std::string store_threshold(Options& options, std::string_view text);
std::string store_color(Options& options, std::string_view text);
std::string store_diagnostics(Options& options, std::string_view text);
std::string store_definition(Options& options, std::string_view text);
std::string store_frame(Options& options, std::string_view text);
std::string store_frames(Options& options, std::string_view text);
std::string store_explained(Options& options, std::string_view text);
std::string store_warning_level(Options& options, std::string_view text, WarningLevel level);
std::string store_path(std::string& target, std::string_view text);
std::string store_directory(std::vector<std::string>& target, std::string_view text);

/// Returns those of `names` that whoever wrote this may have meant, the likeliest first.
std::vector<std::string_view> meant_names(std::string_view written,
                                          std::span<const std::string_view> names);

/// Reads a whole number without a sign; empty if it is none.
std::optional<std::uint64_t> parse_number(std::string_view text);

/// Reads a decimal number, with an exponent or without; empty if it is none.
std::optional<double> parse_decimal(std::string_view text);

/// What is wrong with a number that must lie in this range.
std::string wrong_number(std::string_view text, std::uint64_t low, std::uint64_t high,
                         std::uint64_t largest);

template <class Integer>
std::string store_number(Integer& target, std::string_view text, std::uint64_t low,
                         std::uint64_t high) {
    const auto number = parse_number(text);
    if (!number || *number < low || *number > high) {
        return wrong_number(text, low, high, std::numeric_limits<Integer>::max());
    }
    target = static_cast<Integer>(*number);
    return {};
}

}  // namespace lray::cli
