#include "shade/models/cook_torrance.h"

#include <algorithm>
#include <cmath>

#include "shade/models/half_vector.h"
#include "shade/models/hemisphere.h"
#include "shade/models/microfacet.h"

namespace lray::shade {

namespace {

float alpha_of(const MaterialPoint& material) {
    const float roughness = material.roughness.x;
    return std::max(roughness * roughness, kLeastAlpha);
}

float fifth_power(float x) {
    const float squared = x * x;
    return squared * squared * x;
}

Color schlick(Color fresnel, float cosine) {
    const Color f0 = glm::min(fresnel, Color{1.0f});
    return f0 + (Color{1.0f} - f0) * fifth_power(1.0f - std::min(cosine, 1.0f));
}

/// Returns pi D(h), h the sum of two directions; 0 below kLeastHalfZ.
float ggx(Vec3 h, float alpha) {
    if (!(h.z > kLeastHalfZ)) return 0.0f;
    const float length_squared = dot(h, h);
    const float cos_squared = h.z * h.z / length_squared;
    const float sin_squared = (h.x * h.x + h.y * h.y) / length_squared;
    const float a2 = alpha * alpha;
    const float d = cos_squared * a2 + sin_squared;  // cos^2 (alpha^2 + tan^2)
    return a2 / (d * d);
}

/// Returns cos (1 + 2 Lambda) of a direction with that z.
float masking(float z, float alpha) {
    const float a2 = alpha * alpha;
    return std::sqrt(a2 + (1.0f - a2) * z * z);
}

/// What passes the smooth surface at that cosine.
Color let_through(const MaterialPoint& material, float cosine) {
    return glm::max(Color{1.0f} - material.specular * schlick(material.fresnel, cosine), 0.0f);
}

}  // namespace

Color cook_torrance_reflected(const MaterialPoint& material, const Vec3& wi, const Vec3& wo) {
    const float alpha = alpha_of(material);
    const Vec3 h = wi + wo;
    // I.H = |I + V| / 2.
    const Color f = schlick(material.fresnel, 0.5f * std::sqrt(dot(h, h)));
    // G / (4 (N.I) (N.V)) of Heitz 2014, eq. 99, without quotients of small numbers; times N.I.
    const float sum = wo.z * masking(wi.z, alpha) + wi.z * masking(wo.z, alpha);
    const float visible = 0.5f * wi.z / std::max(sum, 0x1p-126f);
    const Color matt =
        material.diffuse * let_through(material, wi.z) * let_through(material, wo.z) * wi.z;
    return matt + material.specular * f * (ggx(h, alpha) * visible);
}

// Source: Heitz 2018, "Sampling the GGX Distribution of Visible Normals", listing 1.
Vec3 cook_torrance_lobe_direction(const MaterialPoint& material, Vec3 wo, DVec2 u) {
    const float alpha = alpha_of(material);
    const Vec3 stretched = glm::normalize(Vec3{alpha * wo.x, alpha * wo.y, wo.z});
    const float across = stretched.x * stretched.x + stretched.y * stretched.y;
    const Vec3 t1 = across > 0.0f ? Vec3{-stretched.y, stretched.x, 0.0f} / std::sqrt(across)
                                  : Vec3{1.0f, 0.0f, 0.0f};
    const Vec3 t2 = cross(stretched, t1);
    Vec2 p = on_disk(u);
    const float s = 0.5f * (1.0f + stretched.z);
    p.y = (1.0f - s) * std::sqrt(std::max(1.0f - p.x * p.x, 0.0f)) + s * p.y;
    const float rest = std::sqrt(std::max(1.0f - dot(p, p), 0.0f));
    const Vec3 n = p.x * t1 + p.y * t2 + rest * stretched;
    return mirrored_at(wo, glm::normalize(DVec3(alpha * n.x, alpha * n.y, std::max(n.z, 0.0f))));
}

/// D G1 / (4 N.V), G1 = 2 N.V / (N.V + masking).
float cook_torrance_lobe_pdf(const MaterialPoint& material, Vec3 wi, Vec3 wo) {
    const float alpha = alpha_of(material);
    return ggx(wi + wo, alpha) * (0.5f * kInversePi) / (wo.z + masking(wo.z, alpha));
}

Color cook_torrance_lobe_share(const MaterialPoint& material, Vec3 wo) {
    return material.specular * schlick(material.fresnel, wo.z);
}

Color cook_torrance_diffuse_share(const MaterialPoint& material, Vec3 wo) {
    // The mean of 1 - F over the cosine is 20/21 of it at normal incidence.
    return material.diffuse * let_through(material, wo.z) * let_through(material, 1.0f) *
           (20.0f / 21.0f);
}

}  // namespace lray::shade
