// Directions of reflection are chosen with the density that is said, and it is worth choosing by.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shade/models/reflection.h"
#include "tests/shade/chi_square.h"
#include "tests/shade/models/directions.h"

namespace lray::shade {
namespace {

using scene::ReflectionModel;

/// Chosen once; a right density gives less in one of a thousand of such tests.
constexpr double kLeastProbability = 1e-3;

void expect_density(const MaterialPoint& material, Vec3 wo, std::uint64_t seed) {
    const auto sampler = [&](double choice, DVec2 u) -> std::optional<Vec3> {
        const auto sample = sample_reflected(material, wo, choice, u);
        if (!sample) return std::nullopt;
        EXPECT_EQ(sample->pdf, reflected_pdf(material, sample->wi, wo));
        return sample->wi;
    };
    const auto density = [&](Vec3 wi) {
        return static_cast<double>(reflected_pdf(material, wi, wo));
    };
    EXPECT_GT(test::chi_square_probability(sampler, density, seed, {0.0, 1.0}), kLeastProbability)
        << "model " << static_cast<int>(material.model) << " shininess " << material.shininess
        << " roughness " << material.roughness.x << " wo.z " << wo.z << " seed " << seed;
}

MaterialPoint material_of(ReflectionModel model) {
    MaterialPoint material;
    material.model = model;
    material.diffuse = Color{0.3f};
    material.specular = Color{0.5f};
    return material;
}

TEST(ReflectionSampling, DensityOfHighlightsIsTheOneSaid) {
    for (const ReflectionModel model : {ReflectionModel::phong, ReflectionModel::blinn_phong}) {
        for (const float shininess : {0.0f, 5.0f, 40.0f}) {
            for (const double degrees : {0.0, 40.0, 75.0}) {
                MaterialPoint material = material_of(model);
                material.shininess = shininess;
                expect_density(material, test::direction(degrees, 20.0), 7);
                material.diffuse = Color{0.0f};
                expect_density(material, test::direction(degrees, 250.0), 8);
            }
        }
    }
}

TEST(ReflectionSampling, DensityOfRoughSurfacesIsTheOneSaid) {
    for (const ReflectionModel model : {ReflectionModel::cook_torrance, ReflectionModel::ward}) {
        for (const Vec2 roughness : {Vec2{0.45f, 0.3f}, Vec2{0.6f, 0.6f}, Vec2{1.0f, 0.4f}}) {
            for (const double degrees : {0.0, 40.0, 80.0}) {
                MaterialPoint material = material_of(model);
                material.roughness = roughness;
                material.fresnel = Color{0.3f, 0.5f, 0.9f};
                expect_density(material, test::direction(degrees, 20.0), 9);
                material.diffuse = Color{0.0f};
                expect_density(material, test::direction(degrees, 250.0), 10);
            }
        }
    }
}

TEST(ReflectionSampling, MattDensityIsTheCosine) {
    const MaterialPoint material = material_of(ReflectionModel::lambert);
    expect_density(material, test::direction(60.0), 11);
    const float pdf = reflected_pdf(material, test::direction(60.0), test::direction(10.0));
    EXPECT_NEAR(pdf, 0.5 * std::numbers::inv_pi, 1e-7);
}

TEST(ReflectionSampling, BlackReflectsNothing) {
    for (const ReflectionModel model : test::kModels) {
        MaterialPoint material = material_of(model);
        material.diffuse = material.specular = Color{0.0f};
        EXPECT_FALSE(sample_reflected(material, test::direction(30.0), 0.5, {0.5, 0.5}));
        EXPECT_EQ(reflected_pdf(material, test::direction(10.0), test::direction(30.0)), 0.0f);
        EXPECT_EQ(reflected_share(material, test::direction(30.0)), Color{0.0f});
    }
}

TEST(ReflectionSampling, SmallestAndLargestNumbersChooseUnitDirections) {
    const double last = 1.0 - 0x1p-32;
    for (const ReflectionModel model : test::kModels) {
        for (const float smooth : {0.0f, 1.0f}) {
            MaterialPoint material = material_of(model);
            material.roughness = Vec2{1.0f - smooth};
            material.shininess = 10000.0f * smooth;
            for (const double degrees : {0.0, 45.0, 89.999}) {
                for (const DVec2 u : {DVec2{0.0, 0.0}, DVec2{last, last}, DVec2{0.0, last},
                                      DVec2{last, 0.0}, DVec2{0.5, 0.5}}) {
                    for (const double choice : {0.0, last}) {
                        const auto sample =
                            sample_reflected(material, test::direction(degrees), choice, u);
                        if (!sample) continue;
                        EXPECT_NEAR(glm::length(sample->wi), 1.0f, 3e-7f);
                        EXPECT_GT(sample->wi.z, 0.0f);
                        EXPECT_GT(sample->pdf, 0.0f);
                        EXPECT_TRUE(std::isfinite(sample->pdf));
                    }
                }
            }
        }
    }
}

/// The mean of what samples bring is what is reflected in all; how far the greatest is above it is
/// the noise.
struct Weights {
    double mean = 0.0;
    double most = 0.0;
};

Weights weights(const MaterialPoint& material, Vec3 wo, std::uint64_t seed) {
    test::Random random(seed);
    Weights weights;
    constexpr int kCount = 100'000;
    for (int i = 0; i < kCount; ++i) {
        const double choice = random.uniform();
        const double u = random.uniform();
        const auto sample = sample_reflected(material, wo, choice, {u, random.uniform()});
        if (!sample) continue;
        const double weight = static_cast<double>(reflected(material, sample->wi, wo).g) *
                              std::numbers::inv_pi / static_cast<double>(sample->pdf);
        weights.mean += weight / kCount;
        weights.most = std::max(weights.most, weight);
    }
    return weights;
}

TEST(ReflectionSampling, NoSampleIsMuchBrighterThanTheMean) {
    for (const ReflectionModel model : test::kModels) {
        for (const float smooth : {0.0f, 0.3f, 0.7f, 1.0f}) {
            MaterialPoint material = material_of(model);
            material.roughness = Vec2{1.0f - smooth, 0.8f - 0.8f * smooth};
            material.shininess = 1000.0f * smooth * smooth;
            for (const double degrees : {0.0, 45.0, 80.0}) {
                const Weights w = weights(material, test::direction(degrees), 12);
                EXPECT_LT(w.most, 8.0 * w.mean)
                    << static_cast<int>(model) << " " << smooth << " " << degrees;
            }
        }
    }
}

TEST(ReflectionSampling, ShareIsAboutWhatIsReflected) {
    for (const ReflectionModel model : test::kModels) {
        for (const float smooth : {0.2f, 0.6f, 1.0f}) {
            MaterialPoint material = material_of(model);
            material.roughness = Vec2{1.0f - smooth};
            material.shininess = 1000.0f * smooth;
            for (const double degrees : {0.0, 50.0}) {
                const Vec3 wo = test::direction(degrees);
                const double share = static_cast<double>(reflected_share(material, wo).g);
                const double mean = weights(material, wo, 13).mean;
                EXPECT_GT(share, 0.7 * mean) << static_cast<int>(model) << " " << smooth;
                EXPECT_LT(share, 1.6 * mean) << static_cast<int>(model) << " " << smooth;
            }
        }
    }
}

}  // namespace
}  // namespace lray::shade
