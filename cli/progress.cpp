#include "cli/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/assert.h"

namespace lray::cli {

namespace {

constexpr double kBarAfterSeconds = 0.5;
constexpr double kLinesAfterSeconds = 2.0;
constexpr double kLinePeriodSeconds = 30.0;
constexpr int kBarWidth = 40;
// Building the slowest hierarchy over fewer takes less than about half a second.
constexpr std::uint64_t kSlowBuildCount = 100'000;
constexpr const char* kEraseLine = "\r\x1b[K";

/// The time left if the rest is as slow as what is done; "?" before anything is.
std::string time_left(double share, double elapsed_seconds) {
    if (!(share > 0.0)) return "?";
    return format_duration(elapsed_seconds * (1.0 - share) / share);
}

}  // namespace

std::string Progress::begin() {
    return label_.empty() ? std::string{} : whole_line(label_);
}

std::string Progress::building(std::uint64_t primitive_count) {
    if (primitive_count < kSlowBuildCount) return {};
    return whole_line(fmt::format("{}{}building the hierarchy of {} primitives", label_,
                                  label_.empty() ? "" : ": ", primitive_count));
}

std::string Progress::whole_line(const std::string& text) {
    switch (style_) {
        case ProgressStyle::silent:
            return {};
        case ProgressStyle::bar:
            is_bar_drawn_ = true;
            return kEraseLine + text;
        case ProgressStyle::lines:
            return text + "\n";
    }
    LRAY_ASSERT(false);
}

std::string Progress::update(const render::RenderProgress& progress, double elapsed_seconds) {
    if (progress.total_samples == 0) return {};
    const double share =
        static_cast<double>(progress.done_samples) / static_cast<double>(progress.total_samples);
    switch (style_) {
        case ProgressStyle::silent:
            return {};
        case ProgressStyle::bar:
            if (elapsed_seconds < kBarAfterSeconds) return {};
            is_bar_drawn_ = true;
            return bar(share, elapsed_seconds);
        case ProgressStyle::lines:
            break;
    }
    const int tenth = static_cast<int>(10.0 * share);
    const bool is_due =
        tenth > last_line_tenth_ || elapsed_seconds - last_line_seconds_ >= kLinePeriodSeconds;
    if (!is_due || elapsed_seconds < kLinesAfterSeconds) return {};
    last_line_tenth_ = tenth;
    last_line_seconds_ = elapsed_seconds;
    return fmt::format("{}{}{:.0f} %, {} left\n", label_, label_.empty() ? "" : ": ",
                       std::floor(100.0 * share), time_left(share, elapsed_seconds));
}

std::string Progress::finish() const {
    return is_bar_drawn_ ? kEraseLine : std::string{};
}

std::string Progress::bar(double share, double elapsed_seconds) const {
    const int full = std::clamp(static_cast<int>(share * kBarWidth), 0, kBarWidth);
    return fmt::format("{}{}{}[{:#<{}}{:.<{}}] {:3.0f} %  {} left", kEraseLine, label_,
                       label_.empty() ? "" : " ", "", full, "", kBarWidth - full,
                       std::floor(100.0 * share), time_left(share, elapsed_seconds));
}

std::string format_duration(double seconds) {
    // A render that would take longer than this says no more than that.
    constexpr double kMaxSeconds = 1e9;
    const auto whole = static_cast<std::int64_t>(std::ceil(std::clamp(seconds, 0.0, kMaxSeconds)));
    const std::int64_t hours = whole / 3600;
    const std::int64_t minutes = whole / 60 % 60;
    if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
    return fmt::format("{}:{:02}", minutes, whole % 60);
}

}  // namespace lray::cli
