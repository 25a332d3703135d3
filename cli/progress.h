// Progress of a render as text: a bar on a terminal, lines elsewhere. Writes nothing itself.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "render/render.h"

namespace lray::cli {

enum class ProgressStyle : std::uint8_t { silent, bar, lines };

class Progress {
 public:
    /// The label names the picture if there are several: "frame 3 of 8".
    explicit Progress(ProgressStyle style, std::string label = {})
        : style_(style), label_(std::move(label)) {}

    /// Returns what to write at the begin: the label, if there is one.
    std::string begin();

    /// Returns what to write before a hierarchy is built: nothing if it will be quick.
    std::string building(std::uint64_t primitive_count);

    /// Returns what to write now, often nothing: the share done and the time left, and of a render
    /// that is not of a fixed number of samples how many there are and how many pixels are done. A
    /// bar appears once the render has lasted half a second and is redrawn in its line; a line
    /// comes each 10 % or 30 s, the first not before the render has lasted two seconds.
    std::string update(const render::RenderProgress& progress, double elapsed_seconds);

    /// Returns what to write at the end: erases the bar.
    std::string finish() const;

 private:
    std::string whole_line(const std::string& text);
    std::string bar(const render::RenderProgress& progress, double elapsed_seconds) const;

    ProgressStyle style_ = ProgressStyle::silent;
    std::string label_;
    bool is_bar_drawn_ = false;
    double last_line_seconds_ = 0.0;
    int last_line_tenth_ = 0;
};

/// Returns a duration as people read it: "0:07", "12:34", "1:02:03".
std::string format_duration(double seconds);

}  // namespace lray::cli
