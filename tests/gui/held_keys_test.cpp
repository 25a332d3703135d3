#include "gui/held_keys.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace lray::gui {
namespace {

TEST(HeldKeys, AHeldKeyCountsFromItsPress) {
    HeldKeys keys;
    keys.press(Action::forward, 10.0);
    EXPECT_NEAR(keys.advance(10.05).forward, 0.05, 1e-12);
    EXPECT_NEAR(keys.advance(10.2).forward, 0.15, 1e-12);
    keys.release(Action::forward, 10.25);
    EXPECT_NEAR(keys.advance(10.5).forward, 0.05, 1e-12);
    EXPECT_TRUE(keys.advance(10.6).is_none());
}

TEST(HeldKeys, EveryMovementHasItsWay) {
    const struct {
        Action action;
        double Motion::*part;
        double sign;
    } kCases[] = {
        {Action::forward, &Motion::forward, 1.0},    {Action::back, &Motion::forward, -1.0},
        {Action::turn_left, &Motion::yaw, 1.0},      {Action::turn_right, &Motion::yaw, -1.0},
        {Action::strafe_left, &Motion::right, -1.0}, {Action::strafe_right, &Motion::right, 1.0},
        {Action::go_up, &Motion::up, 1.0},           {Action::go_down, &Motion::up, -1.0},
    };
    for (const auto& one : kCases) {
        HeldKeys keys;
        keys.press(one.action, 0.0);
        Motion motion = keys.advance(0.125);
        EXPECT_EQ(motion.*one.part, 0.125 * one.sign) << static_cast<int>(one.action);
        motion.*one.part = 0.0;
        EXPECT_TRUE(motion.is_none()) << static_cast<int>(one.action);
    }
}

TEST(HeldKeys, OppositeKeysCancelOut) {
    HeldKeys keys;
    keys.press(Action::forward, 0.0);
    keys.press(Action::back, 0.0);
    EXPECT_EQ(keys.advance(0.2).forward, 0.0);
}

TEST(HeldKeys, ATapCountsItsLeastTimeSpreadOverTheFollowingCalls) {
    HeldKeys keys;
    keys.press(Action::turn_left, 1.0);
    keys.release(Action::turn_left, 1.01);
    EXPECT_TRUE(keys.is_any_held());
    EXPECT_NEAR(keys.advance(1.04).yaw, 0.04, 1e-12);
    EXPECT_TRUE(keys.is_any_held());
    EXPECT_NEAR(keys.advance(1.08).yaw, 0.04, 1e-12);
    EXPECT_NEAR(keys.advance(1.2).yaw, HeldKeys::kLeastPress - 0.08, 1e-12);
    EXPECT_FALSE(keys.is_any_held());
    EXPECT_TRUE(keys.advance(1.3).is_none());
}

TEST(HeldKeys, PressingWhatIsHeldOrReleasingWhatIsNotChangesNothing) {
    HeldKeys keys;
    keys.release(Action::go_up, 0.0);
    EXPECT_FALSE(keys.is_any_held());
    keys.press(Action::go_up, 0.0);
    keys.press(Action::go_up, 0.1);
    keys.press(Action::go_up, 0.15);
    EXPECT_NEAR(keys.advance(0.2).up, 0.2, 1e-12);
    keys.release(Action::go_up, 0.2);
    keys.release(Action::go_up, 0.25);
    EXPECT_TRUE(keys.advance(0.3).is_none());
}

TEST(HeldKeys, PressedAgainWhileATapIsInForceCountsOnce) {
    HeldKeys keys;
    keys.press(Action::forward, 0.0);
    keys.release(Action::forward, 0.01);
    keys.press(Action::forward, 0.05);
    EXPECT_NEAR(keys.advance(0.2).forward, 0.2, 1e-12);
    keys.release(Action::forward, 0.2);
    EXPECT_FALSE(keys.is_any_held());
}

TEST(HeldKeys, LosingTheKeyboardEndsAllAtOnce) {
    HeldKeys keys;
    keys.press(Action::forward, 0.0);
    keys.press(Action::strafe_right, 0.0);
    keys.release(Action::strafe_right, 0.01);
    keys.release_all(0.15);
    const Motion motion = keys.advance(1.0);
    EXPECT_NEAR(motion.forward, 0.15, 1e-12);
    EXPECT_NEAR(motion.right, HeldKeys::kLeastPress, 1e-12);
    EXPECT_FALSE(keys.is_any_held());
    EXPECT_TRUE(keys.advance(2.0).is_none());
}

TEST(HeldKeys, TapsEndWhereTheyAreAndHeldKeysGoOn) {
    HeldKeys keys;
    keys.press(Action::forward, 0.0);
    keys.press(Action::strafe_right, 0.0);
    keys.release(Action::strafe_right, 0.01);
    keys.end_taps();
    const Motion motion = keys.advance(0.08);
    EXPECT_NEAR(motion.forward, 0.08, 1e-12);
    EXPECT_EQ(motion.right, 0.0);
    EXPECT_TRUE(keys.is_any_held());
}

TEST(HeldKeys, AComputerThatSleptDoesNotShootOff) {
    HeldKeys keys;
    keys.press(Action::forward, 0.0);
    EXPECT_EQ(keys.advance(3600.0).forward, HeldKeys::kLongestAdvance);
    EXPECT_NEAR(keys.advance(3600.1).forward, 0.1, 1e-9);
}

TEST(HeldKeys, AClockThatGoesBackCountsNothing) {
    HeldKeys keys;
    keys.press(Action::forward, 10.0);
    EXPECT_EQ(keys.advance(9.0).forward, 0.0);
    EXPECT_NEAR(keys.advance(10.1).forward, 0.1, 1e-12);
}

TEST(HeldKeys, HowOftenItIsAskedDoesNotMatter) {
    constexpr std::uint64_t kSeed = 53;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    for (int round = 0; round < 200; ++round) {
        HeldKeys often;
        HeldKeys seldom;
        double often_sum = 0.0;
        double seldom_sum = 0.0;
        double now = 0.0;
        for (int i = 0; i < 100; ++i) {
            now += random.uniform(0.0, 0.02);
            switch (random.below(3)) {
                case 0:
                    often.press(Action::forward, now);
                    seldom.press(Action::forward, now);
                    break;
                case 1:
                    often.release(Action::forward, now);
                    seldom.release(Action::forward, now);
                    break;
                default:
                    break;
            }
            often_sum += often.advance(now).forward;
            if (i % 8 == 0) seldom_sum += seldom.advance(now).forward;
        }
        seldom_sum += seldom.advance(now).forward;
        EXPECT_NEAR(often_sum, seldom_sum, 1e-9);
    }
}

}  // namespace
}  // namespace lray::gui
