#include "render/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <random>
#include <thread>
#include <vector>

#include "base/angle.h"
#include "image/srgb.h"
#include "render/render.h"
#include "tests/parser/loaded.h"
#include "tests/support/wait_until.h"

namespace lray::render {
namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;
using namespace std::chrono_literals;

constexpr std::size_t kStripes = 37;

/// A pattern over all directions, so that every pixel's colour tells where its ray went.
class PatternAccel : public bvh::Accel {
 public:
    explicit PatternAccel(std::function<void(bvh::TraceCounts&)> on_ray = {})
        : on_ray_(std::move(on_ray)) {}

    bvh::Hit nearest_hit(const Ray& ray, Interval, bvh::TraceCounts& counts) const override {
        ++counts.rays;
        if (on_ray_) on_ray_(counts);
        const float cell = std::floor(ray.dir.x * 91.0f) + 5.0f * std::floor(ray.dir.y * 53.0f);
        const auto stripe = static_cast<std::size_t>(std::fabs(cell)) % (kStripes + 1);
        if (stripe == kStripes) return {};  // a miss: the background
        return {1.0f, 0.0f, 0.0f, PrimitiveId(PrimitiveKind::sphere, stripe)};
    }
    bool any_hit(const Ray& ray, Interval interval, bvh::TraceCounts& counts) const override {
        return !nearest_hit(ray, interval, counts).is_none();
    }
    bvh::AccelStats stats() const override { return {}; }

 private:
    std::function<void(bvh::TraceCounts&)> on_ray_;
};

std::unique_ptr<PreparedScene> pattern(float red,
                                       std::function<void(bvh::TraceCounts&)> on_ray = {}) {
    scene::World world;
    auto& object_ids = world.object_ids[static_cast<std::size_t>(PrimitiveKind::sphere)];
    for (std::size_t i = 0; i < kStripes; ++i) {
        object_ids.emplace_back(i);
        world.objects.emplace_back();
        world.objects.back().material = static_cast<std::uint32_t>(i);
        world.materials.emplace_back();
        world.materials.back().diffuse = Color{red, 0.02f * static_cast<float>(i), 0.01f};
    }
    auto scene = std::make_unique<PreparedScene>(Sources{}, scene::Scene{}, std::move(world));
    scene->accel = std::make_unique<PatternAccel>(std::move(on_ray));
    return scene;
}

View usual_view() {
    View view;
    view.camera.fov = radians(80.0);
    view.render_options.resolution = {101, 67};
    view.render_options.samples = {0, 6};
    view.render_options.position = PixelPosition::random;
    view.render_options.seed = 7;
    view.render_options.shading.background = {0.25f, 0.5f, 1.0f};
    view.render_options.thread_count = 2;
    return view;
}

View turned(View view, double angle) {
    view.camera.look_at = view.camera.position + DVec3{std::sin(angle), 0.0, -std::cos(angle)};
    return view;
}

image::Image rendered(const PreparedScene& scene, const View& view) {
    const std::atomic<bool> cancel{false};
    return render(scene.world, *scene.accel, view.camera, view.render_options, {}, cancel).image;
}

/// Waits until the session's state is as wished for.
template <class Condition>
testing::AssertionResult reaches(Session& session, Condition condition) {
    Frame frame;
    const auto update_and_ask = [&] {
        session.update(frame);
        return condition(session.status());
    };
    if (test::wait_until(update_and_ask, 1ms, 60s)) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "not within a minute";
}

testing::AssertionResult ends(Session& session, std::uint64_t change) {
    return reaches(session, [&](const SessionStatus& status) {
        return status.change == change && status.is_done;
    });
}

std::vector<std::uint8_t> shown(const image::Image& light, const image::DisplaySettings& settings) {
    const image::Image screen = image::displayed(light, settings);
    std::vector<std::uint8_t> codes(screen.pixels.size() * 3);
    image::encode_row(screen.pixels, settings.gamma, codes);
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < codes.size(); i += 3) {
        bytes.insert(bytes.end(), {codes[i], codes[i + 1], codes[i + 2], 255});
    }
    return bytes;
}

TEST(Session, PassesAverageToThePictureOfAsManySamples) {
    const auto reference = pattern(0.5f);
    Session session;
    EXPECT_TRUE(ends(session, session.set_scene(pattern(0.5f), usual_view())));
    const image::Image expected = rendered(*reference, usual_view());
    EXPECT_EQ(session.light().pixels, expected.pixels);
    EXPECT_EQ(session.status().passes, 6u);
    EXPECT_EQ(session.status().pass_limit, 6u);
    EXPECT_EQ(session.status().square, 1u);
    Frame frame;
    const auto rows = session.update(frame);
    ASSERT_TRUE(rows.has_value());
    EXPECT_EQ(rows->begin, 0u);
    EXPECT_EQ(rows->end, 67u);
    EXPECT_EQ(frame.bytes, shown(expected, {}));
    EXPECT_FALSE(session.update(frame).has_value()) << "nothing changed since";
}

TEST(Session, NothingIsShownBeforeThereIsAScene) {
    Session session;
    Frame frame;
    EXPECT_FALSE(session.update(frame).has_value());
    EXPECT_TRUE(session.light().pixels.empty());
    EXPECT_EQ(session.status().square, 0u);
    session.set_display({.exposure = 1.0});
}

TEST(Session, ARangeOfSamplesIsAveragedAlone) {
    View view = usual_view();
    view.render_options.samples = {3, 5};
    Session session;
    EXPECT_TRUE(ends(session, session.set_scene(pattern(0.5f), view)));
    EXPECT_EQ(session.light().pixels, rendered(*pattern(0.5f), view).pixels);
    EXPECT_EQ(session.status().passes, 2u);
}

TEST(Session, AnotherViewStartsTheAverageAnew) {
    const auto reference = pattern(0.5f);
    Session session;
    EXPECT_TRUE(ends(session, session.set_scene(pattern(0.5f), usual_view())));
    const View other = turned(usual_view(), 0.7);
    EXPECT_TRUE(ends(session, session.set_view(other)));
    EXPECT_EQ(session.light().pixels, rendered(*reference, other).pixels);
}

TEST(Session, AnotherSceneReplacesTheFirst) {
    Session session;
    session.set_scene(pattern(0.5f), usual_view());
    EXPECT_TRUE(ends(session, session.set_scene(pattern(0.25f), usual_view())));
    EXPECT_EQ(session.light().pixels, rendered(*pattern(0.25f), usual_view()).pixels);
}

TEST(Session, AnotherSizeGivesAFrameOfThatSize) {
    Session session;
    Frame frame;
    EXPECT_TRUE(ends(session, session.set_scene(pattern(0.5f), usual_view())));
    session.update(frame);
    View view = usual_view();
    for (const scene::Resolution size : {scene::Resolution{1, 1}, scene::Resolution{200, 3},
                                         usual_view().render_options.resolution}) {
        view.render_options.resolution = size;
        EXPECT_TRUE(ends(session, session.set_view(view)));
        EXPECT_TRUE(session.update(frame).has_value());
        EXPECT_EQ(frame.resolution, size);
        EXPECT_EQ(frame.bytes, shown(rendered(*pattern(0.5f), view), {}));
    }
}

TEST(Session, AFrameIsBroughtUpToDateAfterThereAndBack) {
    Session session;
    Frame frame;
    EXPECT_TRUE(ends(session, session.set_scene(pattern(0.5f), usual_view())));
    session.update(frame);
    View other = turned(usual_view(), 0.3);
    other.render_options.resolution = {50, 67};
    session.set_view(other);
    EXPECT_TRUE(ends(session, session.set_view(turned(usual_view(), 0.3))));
    EXPECT_TRUE(session.update(frame).has_value());
    EXPECT_EQ(frame.bytes, shown(rendered(*pattern(0.5f), turned(usual_view(), 0.3)), {}));
}

TEST(Session, ADisplayIsShownWithoutAnotherRay) {
    std::atomic<int> ray_count{0};
    View view = usual_view();
    Session session;
    EXPECT_TRUE(ends(session, session.set_scene(pattern(2.0f, [&](auto&) { ++ray_count; }), view)));
    const int before = ray_count;
    const image::DisplaySettings display{-1.5, image::ToneMap::aces, image::Gamma::srgb};
    Frame frame;
    session.update(frame);
    session.set_display(display);
    EXPECT_TRUE(session.update(frame).has_value());
    EXPECT_EQ(frame.bytes, shown(rendered(*pattern(2.0f), view), display));
    EXPECT_EQ(ray_count, before);
    session.set_display(display);
    EXPECT_FALSE(session.update(frame).has_value()) << "it is shown so already";
}

TEST(Session, ADisplayOutlivesAChangeOfSize) {
    View view = usual_view();
    view.render_options.display.exposure = 1.0;
    Session session;
    session.set_scene(pattern(0.2f), view);
    view.render_options.resolution = {64, 48};
    EXPECT_TRUE(ends(session, session.set_view(view)));
    Frame frame;
    session.update(frame);
    EXPECT_EQ(frame.bytes, shown(rendered(*pattern(0.2f), view), view.render_options.display));
}

TEST(Session, ACropAloneIsAveraged) {
    View view = usual_view();
    view.render_options.crop = PixelRect{13, 5, 60, 66};
    std::atomic<int> ray_count{0};
    Session session;
    EXPECT_TRUE(ends(session, session.set_scene(pattern(0.5f, [&](auto&) { ++ray_count; }), view)));
    EXPECT_EQ(session.light().pixels, rendered(*pattern(0.5f), view).pixels);
    EXPECT_LT(ray_count, 101 * 67 * 2 + 47 * 61 * 6);

    View single = view;  // what is around it
    single.render_options.crop.reset();
    single.render_options.samples = {0, 1};
    const std::vector<std::uint8_t> around = shown(rendered(*pattern(0.5f), single), {});
    Frame frame;
    session.update(frame);
    for (std::size_t y = 0; y < 67; ++y) {
        for (std::size_t x = 0; x < 101; ++x) {
            if (x >= 13 && x < 60 && y >= 5 && y < 66) continue;
            const auto at = static_cast<std::ptrdiff_t>(4 * (y * 101 + x));
            ASSERT_TRUE(
                std::equal(around.begin() + at, around.begin() + at + 4, frame.bytes.begin() + at))
                << x << ", " << y;
        }
    }
}

TEST(Session, PausedThereIsOnePassAndNoRayMore) {
    std::atomic<int> ray_count{0};
    Session session;
    session.set_paused(true);
    session.set_scene(pattern(0.5f, [&](auto&) { ++ray_count; }), usual_view());
    EXPECT_TRUE(reaches(session, [](const SessionStatus& status) { return status.passes == 1; }));
    const int before = ray_count;
    std::this_thread::sleep_for(30ms);
    EXPECT_EQ(ray_count, before);
    EXPECT_TRUE(session.status().is_paused);
    EXPECT_FALSE(session.status().is_done);
    session.set_paused(false);
    EXPECT_TRUE(reaches(session, [](const SessionStatus& status) { return status.is_done; }));
    EXPECT_EQ(session.light().pixels, rendered(*pattern(0.5f), usual_view()).pixels);
}

TEST(Session, PausedInAPassItGoesOnWithTheSameSamples) {
    View view = usual_view();
    view.render_options.samples = {0, 40};
    Session session;
    session.set_scene(pattern(0.5f), view);
    for (int i = 0; i < 50; ++i) {
        session.set_paused(i % 2 == 0);
        std::this_thread::sleep_for(1ms);
    }
    session.set_paused(false);
    EXPECT_TRUE(reaches(session, [](const SessionStatus& status) { return status.is_done; }));
    EXPECT_EQ(session.light().pixels, rendered(*pattern(0.5f), view).pixels);
}

// Where the camera is inside of something is found by a ray too.
TEST(Session, ACameraInTheMidstOfEndlesslyManyThingsIsLeft) {
    test::Loaded loaded = test::load_text(
        "environment { color: white }\nsphere { material { transmit: white, ior: 1.5 } }\n");
    auto world = scene::flatten(*loaded.scene, {}, loaded.diagnostics);
    auto scene = std::make_unique<PreparedScene>(std::move(loaded.sources),
                                                 std::move(*loaded.scene), std::move(*world));
    std::atomic<bool> is_met{false};
    scene->accel = std::make_unique<PatternAccel>([&](bvh::TraceCounts& counts) {
        is_met = true;
        while (counts.cancel == nullptr || !*counts.cancel) std::this_thread::sleep_for(1ms);
        counts.is_ended = true;
    });
    scene->lit = std::make_unique<shade::LitWorld>(scene->world, *scene->accel);
    View view = usual_view();
    view.render_options.shading.shader = shade::Shader::full;
    Session session;
    session.set_scene(std::move(scene), view);
    EXPECT_TRUE(reaches(session, [&](const SessionStatus&) { return is_met.load(); }));
    EXPECT_TRUE(ends(session, session.set_scene(pattern(0.5f), usual_view())));
}

/// A ball in the light of a sky that asks for so many samples.
std::unique_ptr<PreparedScene> lit_ball(int light_samples) {
    test::Loaded loaded =
        test::load_text("environment { color: #8090a0, samples: " + std::to_string(light_samples) +
                        " }\nsphere { radius: 2 }\n");
    auto world = scene::flatten(*loaded.scene, {}, loaded.diagnostics);
    auto scene = std::make_unique<PreparedScene>(std::move(loaded.sources),
                                                 std::move(*loaded.scene), std::move(*world));
    scene->accel = bvh::build(scene->world, {});
    scene->lit = std::make_unique<shade::LitWorld>(scene->world, *scene->accel);
    return scene;
}

View lit_view() {
    View view = usual_view();
    view.camera.position = {0.0, 0.0, 8.0};
    view.render_options.shading.shader = shade::Shader::full;
    return view;
}

TEST(Session, SquaresTakeOneSampleOfEachLightAndPassesAll) {
    Session session;
    session.set_paused(true);
    session.set_scene(lit_ball(16), lit_view());
    EXPECT_TRUE(reaches(session, [](const SessionStatus& status) { return status.square == 1; }));
    EXPECT_EQ(session.status().passes, 0u);
    const auto single = lit_ball(1);
    View view = lit_view();
    view.render_options.samples = {0, 1};
    view.render_options.lit = single->lit.get();
    EXPECT_EQ(session.light().pixels, rendered(*single, view).pixels);

    session.set_paused(false);
    EXPECT_TRUE(reaches(session, [](const SessionStatus& status) { return status.is_done; }));
    const auto reference = lit_ball(16);
    view = lit_view();
    view.render_options.lit = reference->lit.get();
    EXPECT_EQ(session.light().pixels, rendered(*reference, view).pixels);
}

TEST(Session, SmallNoiseEndsIt) {
    View view = usual_view();
    view.render_options.samples = {0, 400};
    view.render_options.limits.noise = 0.03;
    Session session;
    EXPECT_TRUE(ends(session, session.set_scene(pattern(0.5f), view)));
    EXPECT_EQ(session.light().pixels, rendered(*pattern(0.5f), view).pixels);
}

TEST(Session, TimeEndsItAfterAWholePass) {
    View view = usual_view();
    view.render_options.samples = {0, Film::kMaxSamples};
    view.render_options.limits.seconds = 0.02;
    Session session;
    EXPECT_TRUE(ends(session, session.set_scene(pattern(0.5f), view)));
    view.render_options.samples = {0, session.status().passes};
    view.render_options.limits = {};
    EXPECT_EQ(session.light().pixels, rendered(*pattern(0.5f), view).pixels);
}

/// No step is ever left in peace, and each takes longer than the time between two changes.
void expect_shown_while_moving(std::chrono::microseconds ray_time) {
    View view = usual_view();
    Session session;
    session.set_scene(pattern(0.5f, [&](auto&) { std::this_thread::sleep_for(ray_time); }), view);
    int shown_count = 0;
    Frame frame;
    for (int i = 0; i < 20'000 && shown_count < 3; ++i) {
        session.set_view(turned(view, 0.01 * i));
        std::this_thread::sleep_for(1ms);
        if (session.update(frame)) ++shown_count;
    }
    EXPECT_EQ(shown_count, 3);
}

TEST(Session, AFirstStepIsShownWhileChangesGoOn) {
    expect_shown_while_moving(50us);
}

TEST(Session, AFirstStepThatIsNeverCompleteIsShownInParts) {
    expect_shown_while_moving(10ms);
}

TEST(Session, AnotherCropLeavesTheRestAsItIs) {
    Session session;
    EXPECT_TRUE(ends(session, session.set_scene(pattern(0.5f), usual_view())));
    const std::vector<std::uint8_t> before = shown(rendered(*pattern(0.5f), usual_view()), {});
    EXPECT_TRUE(ends(session, session.set_crop(PixelRect{0, 0, 10, 10})));
    Frame frame;
    session.update(frame);
    EXPECT_EQ(frame.bytes, before) << "the same samples again";
    EXPECT_EQ(session.light().width, 10u);
    EXPECT_TRUE(ends(session, session.set_crop(std::nullopt)));
    EXPECT_EQ(session.light().width, 101u);
}

TEST(Session, ACropChosenBeforeAViewIsThereShowsTheViewAroundIt) {
    std::atomic<bool> is_held_up{false};
    std::atomic<bool> is_met{false};
    const auto on_ray = [&](bvh::TraceCounts&) {
        is_met = is_met || is_held_up;
        do {  // so slow that squares come first
            std::this_thread::sleep_for(100us);
        } while (is_held_up);
    };
    View view = usual_view();
    view.render_options.samples = {0, 1};
    Session session;
    EXPECT_TRUE(ends(session, session.set_scene(pattern(0.5f, on_ray), view)));
    is_held_up = true;
    const View other = turned(view, 0.7);
    session.set_view(other);
    EXPECT_TRUE(reaches(session, [&](const SessionStatus&) { return is_met.load(); }));
    const std::uint64_t change = session.set_crop(PixelRect{0, 0, 10, 10});
    is_held_up = false;
    EXPECT_TRUE(ends(session, change));
    const std::vector<std::uint8_t> around = shown(rendered(*pattern(0.5f), other), {});
    Frame frame;
    session.update(frame);
    const auto below_the_crop = static_cast<std::ptrdiff_t>(std::size_t{4} * 101 * 10);
    EXPECT_TRUE(std::equal(around.begin() + below_the_crop, around.end(),
                           frame.bytes.begin() + below_the_crop));
}

TEST(Session, ACancelledPickIsNoneOfTheNext) {
    std::atomic<bool> is_endless{true};
    std::atomic<bool> is_met{false};
    View view = usual_view();
    view.render_options.samples = {0, 1};
    Session session;
    EXPECT_TRUE(ends(session, session.set_scene(pattern(0.5f), view)));
    const auto endless = [&](bvh::TraceCounts& counts) {
        is_met = true;
        while (is_endless && !*counts.cancel) std::this_thread::sleep_for(1ms);
        counts.is_ended = is_endless;
    };
    session.set_paused(true);
    session.set_scene(pattern(0.5f, endless), view);
    const PickTicket outdated = session.pick_ticket();
    session.cancel_picks();
    EXPECT_TRUE(session.pick({50.0, 30.0}, outdated).is_cancelled) << "before it began";
    EXPECT_TRUE(reaches(session, [&](const SessionStatus&) { return is_met.load(); }));
    const PickTicket ticket = session.pick_ticket();
    std::thread waiting([&] { EXPECT_TRUE(session.pick({50.0, 30.0}, ticket).is_cancelled); });
    std::this_thread::sleep_for(5ms);
    session.cancel_picks();
    waiting.join();
    is_endless = false;
}

// A ray may meet endlessly many instances: it ends when it is told to, and only then.
TEST(Session, ARayWithoutEndIsLeftForTheNextView) {
    std::atomic<bool> is_met{false};
    const auto endless = [&](bvh::TraceCounts& counts) {
        is_met = true;
        while (!*counts.cancel) std::this_thread::sleep_for(1ms);
        counts.is_ended = true;
    };
    Session session;
    session.set_scene(pattern(0.5f, endless), usual_view());
    EXPECT_TRUE(reaches(session, [&](const SessionStatus&) { return is_met.load(); }));
    EXPECT_TRUE(ends(session, session.set_scene(pattern(0.5f), usual_view())));
    EXPECT_EQ(session.light().pixels, rendered(*pattern(0.5f), usual_view()).pixels);
    session.set_scene(pattern(0.5f, endless), usual_view());  // and it ends with the session
}

TEST(Session, ThousandChangesLeadToTheLastOne) {
    std::mt19937 random(11);
    const auto below = [&](std::uint32_t count) {
        return static_cast<std::uint32_t>(random() % count);
    };
    Session session;
    View view = usual_view();
    session.set_scene(pattern(0.1f), view);
    Frame frame;
    float red = 0.1f;
    std::uint64_t change = 0;
    for (int i = 0; i < 1000; ++i) {
        switch (below(8)) {
            case 0:
                view.render_options.resolution = {1 + below(120), 1 + below(90)};
                view.render_options.crop.reset();
                break;
            case 1: {
                const auto [width, height] = view.render_options.resolution;
                view.render_options.crop = PixelRect{0, 0, 1 + below(width), 1 + below(height)};
                break;
            }
            case 2:
                view.render_options.display.exposure = 0.1 * below(20);
                session.set_display(view.render_options.display);
                break;
            case 3:
                session.set_paused(below(2) == 0);
                break;
            default:
                view = turned(view, 0.001 * below(6000));
                break;
        }
        if (below(10) == 0) {
            red = 0.01f * static_cast<float>(below(100));
            change = session.set_scene(pattern(red), view);
        } else {
            change = session.set_view(view);
        }
        if (below(3) == 0) session.update(frame);
        if (below(5) == 0) session.light();
        if (below(4) == 0) std::this_thread::sleep_for(std::chrono::microseconds(below(2000)));
    }
    session.set_paused(false);
    EXPECT_TRUE(ends(session, change));
    EXPECT_EQ(session.light().pixels, rendered(*pattern(red), view).pixels);
}

}  // namespace
}  // namespace lray::render
