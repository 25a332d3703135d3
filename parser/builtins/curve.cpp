#include "parser/builtins/curve.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"

namespace lray::parser {

CurvePoint curve_point(std::span<const double> rows, double t) {
    const std::size_t count = rows.size() / 3;
    LRAY_ASSERT(count > 0);
    const auto point = [&](std::size_t i) {
        return DVec3{rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]};
    };
    if (count == 1) return {point(0), DVec3{0.0}};
    const auto last_segment = static_cast<double>(count - 2);
    const double along = std::clamp(t, 0.0, 1.0) * static_cast<double>(count - 1);
    const double segment = std::min(std::floor(along), last_segment);
    const double u = along - segment;
    const auto i = static_cast<std::size_t>(segment);
    const DVec3 b = point(i);
    const DVec3 c = point(i + 1);
    const DVec3 a = i > 0 ? point(i - 1) : 2.0 * b - c;
    const DVec3 d = i + 2 < count ? point(i + 2) : 2.0 * c - b;
    const DVec3 slope_b = (c - a) * 0.5;
    const DVec3 slope_c = (d - b) * 0.5;
    // Hermite's form: the ends are reached exactly.
    const double v = 1.0 - u;
    const DVec3 position = b * (v * v * (1.0 + 2.0 * u)) + slope_b * (u * v * v) +
                           c * (u * u * (3.0 - 2.0 * u)) - slope_c * (u * u * v);
    const DVec3 tangent =
        (c - b) * (6.0 * u * v) + slope_b * (v * (1.0 - 3.0 * u)) + slope_c * (u * (3.0 * u - 2.0));
    return {position, tangent};
}

}  // namespace lray::parser
