#include "shade/transport/dielectric.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/random.h"

namespace lray::shade {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

float reflectance_at(double degrees, double eta) {
    return fresnel_reflectance(static_cast<float>(std::cos(degrees * kDegree)),
                               static_cast<float>(eta));
}

/// Fresnel's equations by the angles, in long double.
struct Polarised {
    long double parallel = 1.0L;
    long double across = 1.0L;
};
Polarised polarised(long double angle_in, long double eta) {
    const long double sine = std::sin(angle_in) / eta;
    if (sine >= 1.0L) return {};
    const long double angle_out = std::asin(sine);
    const long double across = std::sin(angle_in - angle_out) / std::sin(angle_in + angle_out);
    const long double parallel = std::tan(angle_in - angle_out) / std::tan(angle_in + angle_out);
    return {parallel * parallel, across * across};
}

TEST(Fresnel, GlassFromTheFrontReflectsFourPercent) {
    EXPECT_NEAR(reflectance_at(0.0, 1.5), 0.04f, 1e-7f);
    EXPECT_NEAR(reflectance_at(0.0, 1.0 / 1.5), 0.04f, 1e-7f);
}

TEST(Fresnel, GrazingReflectsAll) {
    EXPECT_EQ(fresnel_reflectance(0.0f, 1.5f), 1.0f);
}

TEST(Fresnel, EqualIndicesReflectNothing) {
    for (const float cosine : {0.0f, 1e-6f, 0.3f, 1.0f}) {
        EXPECT_EQ(fresnel_reflectance(cosine, 1.0f), 0.0f);
    }
}

TEST(Fresnel, AtBrewstersAngleHalfOfTheAcrossPartIsReflected) {
    constexpr double kBrewster = 56.309932474020215;  // atan 1.5
    EXPECT_NEAR(static_cast<double>(polarised(kBrewster * kDegree, 1.5L).parallel), 0.0, 1e-15);
    // There the rays are at right angles, and the part across is ((n^2 - 1) / (n^2 + 1))^2.
    const double across = std::pow((1.5 * 1.5 - 1.0) / (1.5 * 1.5 + 1.0), 2.0);
    EXPECT_NEAR(reflectance_at(kBrewster, 1.5), 0.5 * across, 1e-7);
}

TEST(Fresnel, BeyondTheCriticalAngleAllIsReflected) {
    constexpr double kCritical = 41.810314895778596;  // asin(1 / 1.5)
    EXPECT_LT(reflectance_at(kCritical - 0.01, 1.0 / 1.5), 0.96f);
    EXPECT_EQ(reflectance_at(kCritical + 0.01, 1.0 / 1.5), 1.0f);
    EXPECT_EQ(reflectance_at(80.0, 1.0 / 1.5), 1.0f);
}

TEST(Fresnel, AgreesWithTheEquationsAtAllAngles) {
    for (const double eta : {1.0001, 1.33, 1.5, 2.42, 1.0 / 1.33, 1.0 / 1.5, 0.3}) {
        for (double degrees = 0.5; degrees < 90.0; degrees += 0.5) {
            const Polarised expected = polarised(
                std::acos(
                    static_cast<long double>(static_cast<float>(std::cos(degrees * kDegree)))),
                static_cast<long double>(static_cast<float>(eta)));
            EXPECT_NEAR(reflectance_at(degrees, eta),
                        static_cast<double>(0.5L * (expected.parallel + expected.across)), 1e-6)
                << degrees << " degrees, eta " << eta;
        }
    }
}

TEST(Fresnel, IsTheSameFromBothSides) {
    for (double degrees = 1.0; degrees < 90.0; degrees += 1.0) {
        const double out = std::asin(std::sin(degrees * kDegree) / 1.5) / kDegree;
        // Rounding a cosine to float tells the more of the angle behind, the flatter that is.
        EXPECT_NEAR(reflectance_at(degrees, 1.5), reflectance_at(out, 1.0 / 1.5),
                    3e-7 / std::cos(degrees * kDegree));
    }
}

class Directions : public testing::Test {
 protected:
    Vec3 unit_vector() {
        for (;;) {
            const DVec3 v{random_.uniform(-1.0, 1.0), random_.uniform(-1.0, 1.0),
                          random_.uniform(-1.0, 1.0)};
            const double length2 = dot(v, v);
            if (length2 > 0.01 && length2 < 1.0) return Vec3{v / std::sqrt(length2)};
        }
    }

    test::Random random_{17};
};

TEST_F(Directions, RefractedKeepsSnellsLawAndThePlane) {
    int refracted_count = 0;
    for (int i = 0; i < 10'000; ++i) {
        const Vec3 normal = unit_vector();
        Vec3 wo = unit_vector();
        if (dot(wo, normal) < 0.0f) wo = -wo;
        const float eta = static_cast<float>(random_.uniform(0.4, 2.5));
        const DVec3 across_in = cross(DVec3{normal}, DVec3{wo});
        const double sine_in = std::sqrt(dot(across_in, across_in));
        const auto out = refracted(wo, normal, eta);
        if (sine_in / static_cast<double>(eta) > 1.0 + 1e-6) {
            EXPECT_FALSE(out.has_value());
            continue;
        }
        if (!out) continue;  // within a rounding of the critical angle
        ++refracted_count;
        const DVec3 across_out = cross(DVec3{normal}, DVec3{*out});
        EXPECT_NEAR(std::sqrt(dot(across_out, across_out)) * static_cast<double>(eta), sine_in,
                    1e-6);
        EXPECT_LT(dot(*out, normal), 0.0f);
        EXPECT_NEAR(dot(DVec3{*out}, across_in), 0.0, 1e-6) << "it must stay in the plane";
        EXPECT_NEAR(dot(*out, *out), 1.0f, 3e-7f);
    }
    EXPECT_GT(refracted_count, 5000);
}

TEST_F(Directions, RefractedByEqualIndicesGoesStraightOn) {
    for (int i = 0; i < 1000; ++i) {
        const Vec3 normal = unit_vector();
        Vec3 wo = unit_vector();
        if (dot(wo, normal) < 0.0f) wo = -wo;
        const auto out = refracted(wo, normal, 1.0f);
        ASSERT_TRUE(out.has_value());
        EXPECT_EQ(*out, -wo);
    }
}

TEST_F(Directions, MirroredMakesTheSameAngle) {
    for (int i = 0; i < 1000; ++i) {
        const Vec3 normal = unit_vector();
        const Vec3 wo = unit_vector();
        const Vec3 out = mirrored(wo, normal);
        EXPECT_NEAR(dot(out, normal), dot(wo, normal), 3e-7f);
        const Vec3 sum = out + wo;  // along the normal
        const Vec3 off = cross(sum, normal);
        EXPECT_NEAR(dot(off, off), 0.0f, 1e-12f);
    }
}

}  // namespace
}  // namespace lray::shade
