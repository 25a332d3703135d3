#include "image/tone_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/srgb.h"

namespace lray::image {
namespace {

TEST(ExposureFactor, WholeStopsAreExactAndOthersCloseToExp2) {
    for (int stops = -64; stops <= 64; ++stops) {
        EXPECT_EQ(exposure_factor(stops), std::ldexp(1.0, stops));
    }
    for (int step = -6400; step <= 6400; ++step) {
        const double stops = step / 100.0;
        const double expected = std::exp2(stops);
        EXPECT_NEAR(exposure_factor(stops), expected, 1e-15 * expected) << stops;
    }
}

TEST(Display, WithoutExposureAndToneMapLightStaysAsItIs) {
    const Display display({});
    for (const Color light :
         {Color{0.0f}, Color{0.1f, 1.0f, 7.5f}, Color{-1.0f, 1e-30f, 65504.0f}}) {
        EXPECT_EQ(display.shown(light), light);
    }
}

TEST(Display, AStopIsTwiceTheLight) {
    const Display brighter({.exposure = 1.0});
    EXPECT_EQ(brighter.shown({0.1f, 0.25f, 3.0f}), Color(0.2f, 0.5f, 6.0f));
    const Display darker({.exposure = -2.0});
    EXPECT_EQ(darker.shown({0.5f, 1.0f, 4.0f}), Color(0.125f, 0.25f, 1.0f));
}

TEST(Display, ReinhardKeepsTheDarkAndNeverReachesWhite) {
    const Display display({.tonemap = ToneMap::reinhard});
    EXPECT_EQ(display.shown({0.0f, 1.0f, 3.0f}), Color(0.0f, 0.5f, 0.75f));
    EXPECT_NEAR(display.shown(Color{0.001f}).r, 0.000999f, 1e-7f);
    EXPECT_LT(display.shown(Color{65504.0f}).r, 1.0f);
}

// Values of the published curve, worked out by hand.
TEST(Display, AcesIsThePublishedCurve) {
    const Display display({.tonemap = ToneMap::aces});
    EXPECT_EQ(display.shown(Color{0.0f}).r, 0.0f);
    EXPECT_NEAR(display.shown(Color{0.18f}).r, 0.086724 / 0.324932, 1e-6);
    EXPECT_NEAR(display.shown(Color{1.0f}).r, 2.54 / 3.16, 1e-6);
    EXPECT_NEAR(display.shown(Color{65504.0f}).r, 2.51 / 2.43, 1e-4);
}

TEST(Display, CurvesRiseAndTakeAnyLight) {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    for (const ToneMap tonemap : {ToneMap::reinhard, ToneMap::aces}) {
        for (const double exposure : {-64.0, 0.0, 0.3, 64.0}) {
            const Display display({exposure, tonemap, Gamma::srgb});
            float last = -1.0f;
            for (const float light :
                 {-kInf, -1.0f, 0.0f, 1e-9f, 0.01f, 0.5f, 1.0f, 9.0f, 65504.0f, 1e38f, kInf}) {
                const float shown = display.shown(Color{light}).g;
                EXPECT_TRUE(std::isfinite(shown)) << light;
                EXPECT_GE(shown, last) << light;
                last = shown;
            }
            EXPECT_EQ(display.shown(Color{-3.0f}), Color(0.0f));
        }
    }
}

/// What a file holds of a light, in [0, 1].
double coded(const DisplaySettings& settings, double light) {
    const float shown = Display(settings).shown(Color{static_cast<float>(light)}).r;
    if (settings.gamma == Gamma::linear) return std::clamp(static_cast<double>(shown), 0.0, 1.0);
    return static_cast<double>(srgb_encode(shown));
}

TEST(Display, DisplayedErrorIsTheSlopeOfWhatIsCoded) {
    for (const ToneMap tonemap : {ToneMap::none, ToneMap::reinhard, ToneMap::aces}) {
        for (const Gamma gamma : {Gamma::srgb, Gamma::linear}) {
            for (const double exposure : {-1.5, 0.0, 2.0}) {
                const DisplaySettings settings{exposure, tonemap, gamma};
                const Display display(settings);
                for (const double mean : {0.0005, 0.01, 0.04, 0.1, 0.2}) {
                    const double step = 0.02 * mean;
                    const double slope =
                        (coded(settings, mean + step) - coded(settings, mean - step)) / (2 * step);
                    EXPECT_NEAR(display.displayed_error(mean, 1e-5), 1e-5 * slope,
                                2e-3 * 1e-5 * slope + 1e-10)
                        << exposure << ", " << mean;
                }
            }
        }
    }
}

TEST(Display, BeyondWhiteOnlyWhatReachesBackCounts) {
    const Display display({.gamma = Gamma::linear});
    EXPECT_EQ(display.displayed_error(3.0, 1.0), 0.0);
    EXPECT_EQ(display.displayed_error(1.5, 0.75), 0.25);
    EXPECT_EQ(display.displayed_error(1.0, 0.75), 0.75);
    EXPECT_EQ(display.displayed_error(-0.5, 0.75), 0.25);
    EXPECT_EQ(display.displayed_error(0.5, 0.0), 0.0);
}

TEST(Displayed, EveryPixelIsShown) {
    Image picture(2, 1);
    picture.at(0, 0) = Color{1.0f, 3.0f, 0.0f};
    picture.at(1, 0) = Color{0.0f, 0.0f, 1.0f};
    const Image shown = displayed(picture, {.tonemap = ToneMap::reinhard});
    EXPECT_EQ(shown.at(0, 0), Color(0.5f, 0.75f, 0.0f));
    EXPECT_EQ(shown.at(1, 0), Color(0.0f, 0.0f, 0.5f));
}

}  // namespace
}  // namespace lray::image
