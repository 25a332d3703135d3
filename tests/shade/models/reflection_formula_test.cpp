// The models of Lambert, Phong and Blinn against their formulas, worked out in long double.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "shade/models/reflection.h"
#include "tests/shade/models/directions.h"

namespace lray::shade {
namespace {

using scene::ReflectionModel;
using Real = long double;

struct Exact {
    Real x = 0.0L;
    Real y = 0.0L;
    Real z = 0.0L;

    Exact unit() const {
        const Real length = std::sqrt(x * x + y * y + z * z);
        return {x / length, y / length, z / length};
    }
    Vec3 rounded() const {
        return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
    }
};

Real dot(const Exact& a, const Exact& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Exact random_exact(test::Random& random, Real least_z) {
    for (;;) {
        const Exact e{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                      random.uniform(-1.0, 1.0)};
        if (dot(e, e) <= 1.0L && dot(e, e) > 0.01L && e.unit().z > least_z) return e.unit();
    }
}

/// A direction next to another one: highlights are narrow.
Exact near(test::Random& random, const Exact& e, Real width) {
    return Exact{e.x + width * random.uniform(-1.0, 1.0), e.y + width * random.uniform(-1.0, 1.0),
                 e.z + width * random.uniform(-1.0, 1.0)}
        .unit();
}

Real blinn_phong(Real diffuse, Real specular, Real s, const Exact& wi, const Exact& wo) {
    if (wi.z <= 0.0L) return 0.0L;
    const Exact h = Exact{wi.x + wo.x, wi.y + wo.y, wi.z + wo.z}.unit();
    return diffuse * wi.z + specular * std::pow(std::max(h.z, 0.0L), s);
}

Real phong(Real diffuse, Real specular, Real s, const Exact& wi, const Exact& wo) {
    if (wi.z <= 0.0L) return 0.0L;
    const Real cosine = dot(Exact{-wi.x, -wi.y, wi.z}, wo);
    if (cosine <= 0.0L) return diffuse * wi.z;
    return diffuse * wi.z + specular * std::pow(cosine, s);
}

MaterialPoint material_of(ReflectionModel model, float shininess) {
    MaterialPoint material;
    material.model = model;
    material.shininess = shininess;
    material.diffuse = Color{0.75f, 0.5f, 0.0f};
    material.specular = Color{0.25f, 0.5f, 1.0f};
    return material;
}

/// The most that reflected() is off from the formula, where directions are rounded to float. Near
/// the horizon the half vector is that of two directions that nearly cancel each other, and their
/// rounding turns it the more the shorter their sum is: what is off counts times its length there.
template <class Formula>
Real most_off(ReflectionModel model, float shininess, std::uint64_t seed, const Formula& formula) {
    test::Random random(seed);
    const MaterialPoint material = material_of(model, shininess);
    Real most = 0.0L;
    for (int i = 0; i < 100'000; ++i) {
        const Exact wo = random_exact(random, 0.0L);
        const Exact mirror{-wo.x, -wo.y, wo.z};
        const Real width = 4.0L / std::sqrt(shininess + 1.0L);
        const Exact wi = i % 4 == 0 ? random_exact(random, 0.0L) : near(random, mirror, width);
        if (std::abs(wi.z) < 1e-7L) continue;  // the side of the horizon is not known in float
        const Color color = reflected(material, wi.rounded(), wo.rounded());
        const Exact sum{wi.x + wo.x, wi.y + wo.y, wi.z + wo.z};
        const Real share = std::min(std::sqrt(dot(sum, sum)), 1.0L);
        for (int c = 0; c < 3; ++c) {
            const Real exact =
                formula(material.diffuse[c], material.specular[c], shininess, wi, wo);
            most = std::max(most, share * std::abs(exact - static_cast<Real>(color[c])));
        }
    }
    return most;
}

TEST(ReflectionFormula, BlinnPhongIsTheFormulaUpToHighExponents) {
    for (const float s : {0.0f, 0.5f, 1.0f, 7.0f, 32.0f, 100.5f, 128.0f}) {
        EXPECT_LT(most_off(ReflectionModel::blinn_phong, s, 1, blinn_phong), 1e-6L) << s;
    }
    EXPECT_LT(most_off(ReflectionModel::blinn_phong, 1000.0f, 2, blinn_phong), 4e-6L);
    EXPECT_LT(most_off(ReflectionModel::blinn_phong, 10000.0f, 3, blinn_phong), 1e-5L);
}

TEST(ReflectionFormula, PhongIsTheFormulaUpToHighExponents) {
    for (const float s : {1.0f, 7.0f, 32.0f}) {
        EXPECT_LT(most_off(ReflectionModel::phong, s, 4, phong), 1e-6L) << s;
    }
    // The mirror direction turns by all that a direction is off, not by half of it.
    EXPECT_LT(most_off(ReflectionModel::phong, 128.0f, 5, phong), 2e-6L);
    EXPECT_LT(most_off(ReflectionModel::phong, 10000.0f, 6, phong), 2e-5L);
}

TEST(ReflectionFormula, LambertIsTheCosine) {
    const MaterialPoint material = material_of(ReflectionModel::lambert, 32.0f);
    const Color color = reflected(material, Vec3{0.6f, 0.0f, 0.8f}, Vec3{0.0f, 0.0f, 1.0f});
    EXPECT_EQ(color, (Color{0.75f, 0.5f, 0.0f} * 0.8f));
}

TEST(ReflectionFormula, BehindAndAlongTheSurfaceNothingIsReflected) {
    const Vec3 up{0.0f, 0.6f, 0.8f};
    for (const ReflectionModel model : test::kModels) {
        const MaterialPoint material = material_of(model, 0.0f);
        for (const Vec3 other : {Vec3{0.6f, 0.0f, -0.8f}, Vec3{0.0f, 0.0f, -1.0f},
                                 Vec3{1.0f, 0.0f, 0.0f}, Vec3{0.0f, -1.0f, -0.0f}}) {
            EXPECT_EQ(reflected(material, other, up), Color{0.0f});
            EXPECT_EQ(reflected(material, up, other), Color{0.0f});
            EXPECT_EQ(reflected_pdf(material, other, up), 0.0f);
            EXPECT_EQ(reflected_pdf(material, up, other), 0.0f);
            EXPECT_FALSE(sample_reflected(material, other, 0.5, DVec2{0.5, 0.5}));
            EXPECT_EQ(reflected_share(material, other), Color{0.0f});
        }
    }
}

TEST(ReflectionFormula, WithoutShininessTheHighlightIsEverywhere) {
    const MaterialPoint material = material_of(ReflectionModel::blinn_phong, 0.0f);
    const Vec3 wi = glm::normalize(Vec3{1.0f, 0.0f, 1e-3f});
    const Vec3 wo = glm::normalize(Vec3{-0.7f, 0.7f, 1e-4f});
    EXPECT_EQ(reflected(material, wi, wo).b, 1.0f);
}

TEST(ReflectionFormula, HighlightEndsBelowTheLeastFloatWithoutTrouble) {
    const MaterialPoint material = material_of(ReflectionModel::blinn_phong, 10000.0f);
    const Vec3 wi = glm::normalize(Vec3{1.0f, 0.0f, 1e-30f});
    EXPECT_EQ(reflected(material, wi, Vec3{0.0f, 0.0f, 1.0f}).b, 0.0f);
}

TEST(ReflectionFormula, ValuesStayFiniteInEveryCorner) {
    const std::array corners = {0.0f,  1e-45f, 1e-38f, 1e-30f, 1e-20f, 1e-10f, 1e-7f,
                                1e-5f, 1e-3f,  0.1f,   0.5f,   0.999f, 1.0f};
    for (const ReflectionModel model : test::kModels) {
        for (const float roughness : {0.0f, 0.03f, 1.0f}) {
            for (const float shininess : {0.0f, 1.0f, 10000.0f}) {
                MaterialPoint material = material_of(model, shininess);
                material.roughness = Vec2{roughness, 1.0f - roughness};
                material.fresnel = Color{0.0f, 0.5f, 1.0f};
                for (const float zi : corners) {
                    for (const float zo : corners) {
                        for (const float side : {-1.0f, 1.0f}) {
                            const Vec3 wi{std::sqrt(1.0f - zi * zi), 0.0f, zi};
                            const Vec3 wo{side * std::sqrt(1.0f - zo * zo), 0.0f, zo};
                            const Color color = reflected(material, wi, wo);
                            const float pdf = reflected_pdf(material, wi, wo);
                            const float sum = color.r + color.g + color.b + pdf;
                            EXPECT_TRUE(std::isfinite(sum) && sum >= 0.0f)
                                << static_cast<int>(model) << " " << roughness << " " << shininess
                                << " " << zi << " " << zo << " " << side << " " << pdf;
                        }
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace lray::shade
