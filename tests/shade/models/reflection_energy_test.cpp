// Rough surfaces reflect light both ways alike, and no more of it than arrives.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "shade/models/reflection.h"
#include "tests/shade/models/directions.h"

namespace lray::shade {
namespace {

using scene::ReflectionModel;

constexpr std::array kPhysical = {ReflectionModel::lambert, ReflectionModel::cook_torrance,
                                  ReflectionModel::ward};

/// What is reflected of light from wo's direction: the integral of f cos over all others, by
/// samples that are spread evenly (Hammersley's points).
double albedo(const MaterialPoint& material, Vec3 wo) {
    constexpr std::uint32_t kSide = 1 << 14;
    double sum = 0.0;
    for (std::uint32_t i = 0; i < kSide; ++i) {
        double reversed = 0.0;
        for (std::uint32_t bit = 0; bit < 14; ++bit) {
            if ((i >> bit & 1u) != 0) reversed += std::ldexp(1.0, -static_cast<int>(bit) - 1);
        }
        const double choice = std::fmod(i * std::numbers::phi, 1.0);
        const DVec2 u{(i + 0.5) / kSide, reversed};
        const auto sample = sample_reflected(material, wo, choice, u);
        if (!sample) continue;
        sum += static_cast<double>(reflected(material, sample->wi, wo).g) /
               static_cast<double>(sample->pdf);
    }
    return sum * std::numbers::inv_pi / kSide;
}

/// The same by quadrature over the hemisphere, without the samplers.
double albedo_by_quadrature(const MaterialPoint& material, Vec3 wo) {
    constexpr int kZ = 500;
    constexpr int kTurn = 500;
    double sum = 0.0;
    for (int i = 0; i < kZ; ++i) {
        const double z = (i + 0.5) / kZ;
        const double sine = std::sqrt(1.0 - z * z);
        for (int j = 0; j < kTurn; ++j) {
            const double angle = 2.0 * std::numbers::pi * (j + 0.5) / kTurn;
            const Vec3 wi{sine * std::cos(angle), sine * std::sin(angle), z};
            sum += static_cast<double>(reflected(material, wi, wo).g);
        }
    }
    return 2.0 * sum / (kZ * kTurn);
}

MaterialPoint rough(ReflectionModel model, Vec2 roughness) {
    MaterialPoint material;
    material.model = model;
    material.roughness = roughness;
    material.specular = Color{1.0f};
    material.fresnel = Color{1.0f};
    return material;
}

TEST(ReflectionEnergy, LightGoesBothWaysAlike) {
    test::Random random(1);
    for (const ReflectionModel model : kPhysical) {
        for (int i = 0; i < 20'000; ++i) {
            MaterialPoint material =
                rough(model, {random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)});
            material.diffuse = Color{0.7f, 0.2f, 0.0f};
            material.specular = Color{0.9f, 0.5f, 0.1f};
            material.fresnel = Color{0.04f, 0.3f, 0.9f};
            const Vec3 a = test::hemisphere_direction(random);
            const Vec3 b = test::hemisphere_direction(random);
            const Color there = reflected(material, a, b) / a.z;
            const Color back = reflected(material, b, a) / b.z;
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(there[c], back[c], 4e-6f * (std::abs(there[c]) + 1e-3f)) << i;
            }
        }
    }
}

TEST(ReflectionEnergy, NoMoreIsReflectedThanArrives) {
    for (const ReflectionModel model : {ReflectionModel::cook_torrance, ReflectionModel::ward}) {
        for (const float x : {0.0f, 0.1f, 0.3f, 0.5f, 0.8f, 1.0f}) {
            for (const float y : {0.05f, 0.4f, 1.0f}) {
                if (model == ReflectionModel::cook_torrance && y != 1.0f) continue;
                for (const double degrees : {0.0, 20.0, 45.0, 60.0, 75.0, 85.0, 89.0}) {
                    for (const double turn : {0.0, 30.0, 90.0}) {
                        const double all =
                            albedo(rough(model, {x, y}), test::direction(degrees, turn));
                        EXPECT_LT(all, 1.002) << static_cast<int>(model) << " roughness " << x
                                              << " " << y << " degrees " << degrees << " " << turn;
                        EXPECT_GT(all, 0.2);
                    }
                }
            }
        }
    }
}

TEST(ReflectionEnergy, HighlightAndMattLayerTogetherReflectNoMoreThanArrives) {
    for (const float fresnel : {0.0f, 0.02f, 0.04f, 0.1f, 0.3f, 0.5f, 0.8f, 1.0f}) {
        for (const float roughness : {0.0f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f}) {
            for (const double degrees : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0, 89.5}) {
                MaterialPoint material = rough(ReflectionModel::cook_torrance, Vec2{roughness});
                material.diffuse = Color{1.0f};
                material.fresnel = Color{fresnel};
                EXPECT_LT(albedo(material, test::direction(degrees)), 1.002)
                    << "fresnel " << fresnel << " roughness " << roughness << " " << degrees;
            }
        }
    }
}

TEST(ReflectionEnergy, SmoothMirrorReflectsAll) {
    for (const ReflectionModel model : {ReflectionModel::cook_torrance, ReflectionModel::ward}) {
        for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
            EXPECT_NEAR(albedo(rough(model, Vec2{0.0f}), test::direction(degrees)), 1.0, 3e-3)
                << static_cast<int>(model) << " " << degrees;
        }
    }
}

TEST(ReflectionEnergy, SamplesGiveWhatQuadratureGives) {
    for (const ReflectionModel model : test::kModels) {
        for (const double degrees : {0.0, 50.0, 80.0}) {
            MaterialPoint material = rough(model, {0.5f, 0.35f});
            material.diffuse = Color{0.4f};
            material.specular = Color{0.6f};
            material.fresnel = Color{0.2f};
            const Vec3 wo = test::direction(degrees, 33.0);
            const double exact = albedo_by_quadrature(material, wo);
            EXPECT_NEAR(albedo(material, wo), exact, 0.01 * exact)
                << static_cast<int>(model) << " " << degrees;
        }
    }
}

TEST(ReflectionEnergy, ClearCoatDarkensWhatIsBelowIt) {
    MaterialPoint material = rough(ReflectionModel::cook_torrance, Vec2{0.3f});
    material.diffuse = Color{1.0f};
    material.fresnel = Color{0.04f};
    const double with_coat = albedo(material, test::direction(0.0));
    material.fresnel = Color{0.0f};
    material.specular = Color{0.0f};
    EXPECT_NEAR(albedo(material, test::direction(0.0)), 1.0, 1e-3);
    EXPECT_GT(with_coat, 0.85);
    EXPECT_LT(with_coat, 0.95);
}

}  // namespace
}  // namespace lray::shade
