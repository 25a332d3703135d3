// The panel of information.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/assert.h"
#include "gui/panels.h"
#include "gui/text_panel.h"

namespace lray::gui {

namespace {

Box room_of(WindowSize window) {
    constexpr double kMargin = 4.0;
    return {kMargin, kMargin, window.width - kMargin, window.height - kMargin};
}

std::string passes(std::uint64_t count) {
    return fmt::format("{} {}", count, count == 1 ? "pass" : "passes");
}

std::string progress(const HudState& state) {
    switch (state.state) {
        case RenderState::loading:
            return "loading...";
        case RenderState::paused:
            return "paused after " + passes(state.pass_count);
        case RenderState::done:
            return "done, " + passes(state.pass_count);
        case RenderState::rendering:
            if (state.preview_divisor > 1) {
                return fmt::format("preview 1/{}", state.preview_divisor);
            }
            if (state.pass_count == 0) return "first pass";
            if (state.pass_limit) {
                return fmt::format("pass {} of {}", state.pass_count, *state.pass_limit);
            }
            return fmt::format("pass {}", state.pass_count);
    }
    LRAY_ASSERT(false);
}

std::string point(DVec3 p) {
    return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", p.x, p.y, p.z);
}

std::string width_of_view(const scene::Camera& camera) {
    switch (camera.projection) {
        case scene::Projection::perspective:
            return fmt::format("fov {:.4g}", camera.fov * (180.0 / std::numbers::pi));
        case scene::Projection::orthographic:
            return fmt::format("height {:.4g}", camera.height);
        case scene::Projection::panorama:
            return "panorama";
    }
    LRAY_ASSERT(false);
}

std::string_view name_of(image::ToneMap tonemap) {
    switch (tonemap) {
        case image::ToneMap::none:
            return "none";
        case image::ToneMap::reinhard:
            return "reinhard";
        case image::ToneMap::aces:
            return "aces";
    }
    LRAY_ASSERT(false);
}

std::vector<PanelLine> hud_lines(const HudState& state) {
    std::vector<PanelLine> lines;
    const auto add = [&](std::string_view text, Rgba color = kTextColor) {
        lines.push_back({shown_text(text), color});
    };
    std::string first = progress(state);
    if (state.state == RenderState::rendering && state.rays_per_second > 0.0) {
        first += "  " + short_count(state.rays_per_second) + "rays/s";
    }
    add(fmt::format("{}  {} x {}", first, state.resolution.width, state.resolution.height));
    add(fmt::format("position {}  {}", point(state.camera.position), width_of_view(state.camera)));
    add(fmt::format("look_at {}", point(state.camera.look_at)));
    add(fmt::format("{}  speed {:.3g}  exposure {:+.1f}  tone map {}",
                    state.is_flying ? "fly" : "orbit", state.speed, state.exposure,
                    name_of(state.tonemap)),
        kFaintColor);
    std::string last = fmt::format("accel {}  shading {}", state.accel, state.shading);
    if (state.volume_level) last += fmt::format("  volumes of level {}", *state.volume_level);
    add(last + "  H: help", kFaintColor);
    if (state.picked) {
        add(state.picked->name, kAccentColor);
        add(state.picked->place, kAccentColor);
    }
    return lines;
}

}  // namespace

std::string short_count(double count) {
    constexpr std::string_view kUnits[] = {"", "k", "M", "G", "T"};
    if (!(count > 0.0)) return "0 ";
    std::size_t unit = 0;
    // From here on three digits would become 1000 by rounding.
    while (count >= 999.5 && unit + 1 < std::size(kUnits)) {
        count /= 1000.0;
        ++unit;
    }
    const int decimals = count < 9.995 ? 2 : count < 99.95 ? 1 : 0;
    return fmt::format("{:.{}f} {}", count, unit == 0 ? 0 : decimals, kUnits[unit]);
}

void add_hud(Overlay& overlay, const HudState& state, const Font& font, WindowSize window) {
    add_text_panel(overlay, hud_lines(state), room_of(window), font);
}

void add_notice(Overlay& overlay, std::string_view text, const Font& font, WindowSize window) {
    const std::vector<PanelLine> lines{{shown_text(text), kTextColor}};
    Box room = room_of(window);
    room.top = std::max(room.top, room.bottom - panel_size(lines, font).y);
    add_text_panel(overlay, lines, room, font);
}

}  // namespace lray::gui
