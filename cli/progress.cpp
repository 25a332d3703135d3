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

double share_of(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// How much is done: of the time, if that is what ends it and nothing does before; else of the
/// pixels, if each has its own number of samples; else of the samples.
double share_done(const render::RenderProgress& progress) {
    const double samples = share_of(progress.done_samples, progress.total_samples);
    const double pixels = share_of(progress.finished_pixels, progress.total_pixels);
    if (progress.limits.seconds) {
        const double time = std::min(progress.seconds / *progress.limits.seconds, 1.0);
        return std::max({samples, time});
    }
    return progress.limits.noise ? pixels : samples;
}

/// The time left if the rest is as slow as what is done; "?" before anything is.
std::string time_left(const render::RenderProgress& progress, double elapsed_seconds) {
    const double share = share_done(progress);
    if (progress.limits.seconds && share < 1.0) {
        const double rest = std::max(*progress.limits.seconds - progress.seconds, 0.0);
        const double samples = share_of(progress.done_samples, progress.total_samples);
        const double of_samples =
            samples > 0.0 ? progress.seconds * (1.0 - samples) / samples : rest;
        return format_duration(std::min(rest, of_samples));
    }
    const double there =
        progress.limits.noise ? 0.0 : share_of(progress.kept_samples, progress.total_samples);
    if (!(share > there)) return "?";
    return format_duration(elapsed_seconds * (1.0 - share) / (share - there));
}

/// What beside the time says how good the picture is already.
std::string quality(const render::RenderProgress& progress) {
    if (!progress.limits.is_any()) return {};
    std::string text = fmt::format(
        ", {:.1f} samples a pixel",
        share_of(progress.done_samples, std::max<std::uint64_t>(progress.total_pixels, 1)));
    if (progress.limits.noise) {
        const double share = share_of(progress.finished_pixels, progress.total_pixels);
        text += fmt::format(", {:.0f} % of the pixels done", std::floor(100.0 * share));
    }
    return text;
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
    const double share = share_done(progress);
    switch (style_) {
        case ProgressStyle::silent:
            return {};
        case ProgressStyle::bar:
            if (elapsed_seconds < kBarAfterSeconds) return {};
            is_bar_drawn_ = true;
            return bar(progress, elapsed_seconds);
        case ProgressStyle::lines:
            break;
    }
    const int tenth = static_cast<int>(10.0 * share);
    const bool is_due =
        tenth > last_line_tenth_ || elapsed_seconds - last_line_seconds_ >= kLinePeriodSeconds;
    if (!is_due || elapsed_seconds < kLinesAfterSeconds) return {};
    last_line_tenth_ = tenth;
    last_line_seconds_ = elapsed_seconds;
    return fmt::format("{}{}{:.0f} %, {} left{}\n", label_, label_.empty() ? "" : ": ",
                       std::floor(100.0 * share), time_left(progress, elapsed_seconds),
                       quality(progress));
}

std::string Progress::finish() const {
    return is_bar_drawn_ ? kEraseLine : std::string{};
}

std::string Progress::bar(const render::RenderProgress& progress, double elapsed_seconds) const {
    const double share = share_done(progress);
    const int full = std::clamp(static_cast<int>(share * kBarWidth), 0, kBarWidth);
    return fmt::format("{}{}{}[{:#<{}}{:.<{}}] {:3.0f} %  {} left{}", kEraseLine, label_,
                       label_.empty() ? "" : " ", "", full, "", kBarWidth - full,
                       std::floor(100.0 * share), time_left(progress, elapsed_seconds),
                       quality(progress));
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
