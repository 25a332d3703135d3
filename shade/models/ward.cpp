#include "shade/models/ward.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "shade/models/half_vector.h"
#include "shade/models/hemisphere.h"
#include "shade/models/microfacet.h"

namespace lray::shade {

namespace {

Vec2 alpha_of(const MaterialPoint& material) {
    return glm::max(material.roughness, Vec2{kLeastAlpha});
}

/// Returns exp(-slope^2) / (ax ay), slope that of h in widths: pi times the density of slopes; 0
/// below kLeastHalfZ.
float slope_density(Vec3 h, Vec2 alpha) {
    if (!(h.z > kLeastHalfZ)) return 0.0f;
    const Vec2 slope = Vec2{h.x, h.y} / (h.z * alpha);
    const float exponent = dot(slope, slope);
    constexpr float kNothing = 87.0f;  // e^-87 is next to the least normal float
    return exponent < kNothing ? std::exp(-exponent) / (alpha.x * alpha.y) : 0.0f;
}

}  // namespace

Color ward_reflected(const MaterialPoint& material, const Vec3& wi, const Vec3& wo) {
    const Color matt = material.diffuse * wi.z;
    const Vec3 h = wi + wo;
    const float density = slope_density(h, alpha_of(material));
    if (density == 0.0f) return matt;
    const float z_squared = h.z * h.z;
    const float highlight = density * dot(h, h) / z_squared * (wi.z / z_squared);
    return matt + material.specular * highlight;
}

Vec3 ward_lobe_direction(const MaterialPoint& material, Vec3 wo, DVec2 u) {
    const Vec2 alpha = alpha_of(material);
    // Slopes in widths are a normal distribution in two dimensions.
    const double radius = std::sqrt(-natural_logarithm(1.0 - u.x));
    const float angle = 2.0f * kPi * static_cast<float>(u.y);
    const DVec2 slope = radius * DVec2{static_cast<double>(alpha.x * std::cos(angle)),
                                       static_cast<double>(alpha.y * std::sin(angle))};
    return mirrored_at(wo, glm::normalize(DVec3{slope.x, slope.y, 1.0}));
}

/// exp(-slope^2) / (pi ax ay cos^3 (4 H.V)), with H = I + V of its own length:
/// cos^3 = H.z^3 / |H|^3 and H.V = |H| / 2.
float ward_lobe_pdf(const MaterialPoint& material, Vec3 wi, Vec3 wo) {
    const Vec3 h = wi + wo;
    const float density = slope_density(h, alpha_of(material));
    if (density == 0.0f) return 0.0f;
    return density * kInversePi * 0.5f * dot(h, h) / (h.z * h.z * h.z);
}

}  // namespace lray::shade
