#include "shade/textures/color_stops.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"

namespace lray::shade {

namespace {

bool is_finite(DVec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

ColorStops::ColorStops(std::span<const scene::ColorStop> stops) {
    LRAY_ASSERT(!stops.empty());
    stops_.reserve(stops.size());
    for (const scene::ColorStop& stop : stops) {
        Stop next{stop.at, DVec3{stop.color}, DVec3{0.0}};
        if (!stops_.empty()) {
            const Stop& last = stops_.back();
            next.integral = last.integral + 0.5 * (next.at - last.at) * (last.color + next.color);
        }
        stops_.push_back(next);
    }
}

ColorStops::Place ColorStops::place(double at) const {
    const Stop* const behind = stops_.data() + stops_.size();
    const Stop* const next = std::upper_bound(
        stops_.data(), behind, at, [](double place, const Stop& stop) { return place < stop.at; });
    // NaN is less than nothing, which would put it behind the last.
    if (next == stops_.data() || std::isnan(at)) {
        return {stops_.data(), std::isnan(at) ? 0.0 : at - stops_.front().at, 0.0};
    }
    const Stop& stop = next[-1];
    const double past = at - stop.at;
    return {&stop, past, next == behind ? 0.0 : past / (next->at - stop.at)};
}

DVec3 ColorStops::value(double at) const {
    const Place here = place(at);
    if (!(here.share > 0.0)) return here.stop->color;
    return mix(here.stop->color, here.stop[1].color, here.share);
}

DVec3 ColorStops::integral(double to) const {
    const Place here = place(to);
    const DVec3 color = here.stop->color;
    if (!(here.share > 0.0)) return here.stop->integral + here.past * color;
    return here.stop->integral +
           here.past * (color + 0.5 * here.share * (here.stop[1].color - color));
}

DVec3 ColorStops::mean(double at, double width) const {
    // Differences of integrals lose digits by as much as the width is less than the length.
    constexpr double kNarrow = 0x1p-20;
    const double length =
        std::max(std::fabs(at - stops_.front().at), std::fabs(at - stops_.back().at));
    if (!(width > kNarrow * length)) return value(at);
    const DVec3 mean = (integral(at + 0.5 * width) - integral(at - 0.5 * width)) / width;
    return is_finite(mean) ? mean : value(at);
}

}  // namespace lray::shade
