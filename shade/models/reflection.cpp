#include "shade/models/reflection.h"

#include <algorithm>

#include "shade/models/hemisphere.h"

namespace lray::shade {

namespace {

using scene::ReflectionModel;

struct Shares {
    Color diffuse{0.0f};
    Color lobe{0.0f};
};

Shares shares(const MaterialPoint& material, Vec3 wo) {
    switch (material.model) {
        case ReflectionModel::lambert:
            return {material.diffuse, Color{0.0f}};
        case ReflectionModel::phong:
            return {material.diffuse, material.specular * phong_lobe_share(material)};
        case ReflectionModel::blinn_phong:
            return {material.diffuse, material.specular * blinn_phong_lobe_share(material, wo)};
        case ReflectionModel::cook_torrance:
            return {cook_torrance_diffuse_share(material, wo),
                    cook_torrance_lobe_share(material, wo)};
        case ReflectionModel::ward:
            return {material.diffuse, material.specular};
    }
    return {};
}

Vec3 lobe_direction(const MaterialPoint& material, Vec3 wo, DVec2 u) {
    switch (material.model) {
        case ReflectionModel::lambert:
            break;
        case ReflectionModel::phong:
            return phong_lobe_direction(material, wo, u);
        case ReflectionModel::blinn_phong:
            return blinn_phong_lobe_direction(material, wo, u);
        case ReflectionModel::cook_torrance:
            return cook_torrance_lobe_direction(material, wo, u);
        case ReflectionModel::ward:
            return ward_lobe_direction(material, wo, u);
    }
    return cosine_direction(u);
}

float lobe_pdf(const MaterialPoint& material, Vec3 wi, Vec3 wo) {
    switch (material.model) {
        case ReflectionModel::lambert:
            break;
        case ReflectionModel::phong:
            return phong_lobe_pdf(material, wi, wo);
        case ReflectionModel::blinn_phong:
            return blinn_phong_lobe_pdf(material, wi, wo);
        case ReflectionModel::cook_torrance:
            return cook_torrance_lobe_pdf(material, wi, wo);
        case ReflectionModel::ward:
            return ward_lobe_pdf(material, wi, wo);
    }
    return 0.0f;
}

float sum(Color color) {
    return color.r + color.g + color.b;
}

/// Returns the probability of the cosine lobe, the rest being the model's own; none where nothing
/// is reflected.
std::optional<float> diffuse_probability(const MaterialPoint& material, Vec3 wo) {
    const Shares s = shares(material, wo);
    const float diffuse = sum(s.diffuse);
    const float both = diffuse + sum(s.lobe);
    if (!(both > 0.0f)) return std::nullopt;
    return diffuse / both;
}

float mixture_pdf(const MaterialPoint& material, float diffuse, Vec3 wi, Vec3 wo) {
    float pdf = 0.0f;
    if (diffuse > 0.0f) pdf += diffuse * cosine_pdf(wi.z);
    if (diffuse < 1.0f) pdf += (1.0f - diffuse) * lobe_pdf(material, wi, wo);
    return pdf;
}

}  // namespace

std::optional<DirectionSample> sample_reflected(const MaterialPoint& material, Vec3 wo,
                                                double choice, DVec2 u) {
    if (!(wo.z > 0.0f)) return std::nullopt;
    const std::optional<float> diffuse = diffuse_probability(material, wo);
    if (!diffuse) return std::nullopt;
    const Vec3 wi = choice < static_cast<double>(*diffuse) ? cosine_direction(u)
                                                           : lobe_direction(material, wo, u);
    if (!(wi.z > 0.0f)) return std::nullopt;
    const float pdf = mixture_pdf(material, *diffuse, wi, wo);
    if (!(pdf > 0.0f)) return std::nullopt;
    return DirectionSample{wi, pdf};
}

float reflected_pdf(const MaterialPoint& material, Vec3 wi, Vec3 wo) {
    if (!(wi.z > 0.0f && wo.z > 0.0f)) return 0.0f;
    const std::optional<float> diffuse = diffuse_probability(material, wo);
    return diffuse ? mixture_pdf(material, *diffuse, wi, wo) : 0.0f;
}

Color reflected_share(const MaterialPoint& material, Vec3 wo) {
    if (!(wo.z > 0.0f)) return Color{0.0f};
    const Shares s = shares(material, wo);
    return s.diffuse + s.lobe;
}

}  // namespace lray::shade
