// Ways to write one thing: programs that differ in form alone give the same world, to the bit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/parser/program.h"

namespace lray::test {
namespace {

/// Text that is equal for equal worlds, to the last bit.
std::string world_of(std::string_view text, const parser::LoadSettings& settings = {},
                     const std::vector<Companion>& companions = {}) {
    const Ran loaded = run(text, settings, companions);
    if (!loaded.loaded.scene) {
        ADD_FAILURE() << text << "\n" << loaded.told();
        return {};
    }
    Diagnostics diagnostics;
    const auto world = scene::flatten(*loaded.loaded.scene, {}, diagnostics);
    if (!world) return "no world";
    std::string result;
    const auto vec = [&](const Vec3& v) {
        result += fmt::format("{:a} {:a} {:a} ", v.x, v.y, v.z);
    };
    const auto frame = [&](const scene::AffineFrame& f) {
        vec(f.origin);
        for (int i = 0; i < 3; ++i) vec(f.object_from_world[i]);
    };
    const auto object = [&](scene::PrimitiveKind kind, std::size_t i) {
        const scene::Object& of = world->object(world->object_of(scene::PrimitiveId(kind, i)));
        vec(world->materials[of.material].diffuse.constant);
        result += '\n';
    };
    for (std::size_t i = 0; i < world->spheres.size(); ++i) {
        vec(world->spheres[i].center);
        result += fmt::format("{:a} ", world->spheres[i].radius);
        object(scene::PrimitiveKind::sphere, i);
    }
    for (std::size_t i = 0; i < world->boxes.size(); ++i) {
        frame(world->boxes[i].frame);
        object(scene::PrimitiveKind::box, i);
    }
    for (std::size_t i = 0; i < world->triangles.size(); ++i) {
        for (const auto at : world->triangles[i].vertices) vec(world->vertices[at]);
        object(scene::PrimitiveKind::triangle, i);
    }
    return result;
}

/// A random shape; `i` is what its numbers depend on.
class Shapes {
 public:
    explicit Shapes(unsigned seed) : random_(seed) {}

    std::string shape(std::string_view i) {
        const std::string p = fmt::format("[{}, {}, {}]", number(i), number(i), number(i));
        const std::string step = fmt::format("scale: {}, rotate_y: {}, translate: {}",
                                             1 + below(5) * 0.37, number(i), p);
        switch (below(4)) {
            case 0:
                return fmt::format("sphere {{ radius: {}, center: {} }}", 1 + below(9) / 7.0, p);
            case 1:
                return fmt::format("box {{ {}, material {{ diffuse: [0.{}, 0.5, 0.2] }} }}", step,
                                   1 + below(8));
            case 2:
                return fmt::format("triangle {{ a: {}, b: [90, 1, 0], c: [0, 50, {}] }}", p,
                                   60 + below(9));
            default:
                return fmt::format("group {{ {}\n sphere {{ }}\n box {{ center: {} }} }}", step, p);
        }
    }

    unsigned below(unsigned count) { return static_cast<unsigned>(random_() % count); }

 private:
    std::string number(std::string_view i) {
        return fmt::format("{} + {} * {}", below(100) / 9.0, i, 1 + below(50) / 7.0);
    }

    std::mt19937 random_;
};

class SameWorld : public ::testing::TestWithParam<unsigned> {
 protected:
    static constexpr unsigned kRounds = 4;
    unsigned seed() const { return GetParam(); }

    std::string body(std::string_view i) const {
        Shapes shapes(seed());
        std::string text;
        for (int k = 0; k < 5; ++k) text += shapes.shape(i) + "\n";
        return text;
    }
    std::string in_loop() const {
        return fmt::format("for i in range({}) {{\n{}}}\n", kRounds, body("i"));
    }
};

TEST_P(SameWorld, WhenALoopIsUnrolled) {
    std::string unrolled;
    std::string in_while = "var k = 0\nwhile k < 4 {\n let i = k\n" + body("i") + " k = k + 1\n}\n";
    for (unsigned i = 0; i < kRounds; ++i) unrolled += body(std::to_string(i));
    const std::string expected = world_of(in_loop());
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(expected, world_of(unrolled)) << "seed " << seed();
    EXPECT_EQ(expected, world_of(in_while)) << "seed " << seed();
}

TEST_P(SameWorld, WhenFunctionsAndComponentsAreWrittenOut) {
    const std::string inlined = "for i in range(4) {\n" + body("(2 * i + 1)") + "}\n";
    const std::string with_fn =
        "fn odd(i) = 2 * i + 1\nfor i in range(4) {\n" + body("odd(i)") + "}\n";
    const std::string expected = world_of(inlined);
    EXPECT_EQ(expected, world_of(with_fn)) << "seed " << seed();
    const std::string component = "component c(q) {\n" + body("q") + "}\n";
    const std::string uses = "for i in range(4) { c { q: 2 * i + 1 } }\n";
    parser::LoadSettings settings;
    EXPECT_EQ(expected, world_of(component + uses)) << "seed " << seed();
    EXPECT_EQ(expected, world_of(uses + component)) << "seed " << seed();
    settings.use_memo = false;
    EXPECT_EQ(expected, world_of(component + uses, settings)) << "seed " << seed();
    EXPECT_EQ(expected, world_of("import \"lib.lrs\"\nfor i in range(4) { lib.c { q: 2 * i + 1 } }",
                                 {}, {{"lib.lrs", component}}))
        << "seed " << seed();
}

TEST_P(SameWorld, WhenNamesFilesAndPathsOfReadingDiffer) {
    const std::string expected = world_of(in_loop());
    EXPECT_EQ(expected, world_of("for other in range(4) {\n" + body("other") + "}\n"));
    const std::string literal = body("3");
    parser::LoadSettings settings;
    settings.use_literal_fast_path = false;
    const std::string plain = world_of(literal);
    EXPECT_EQ(plain, world_of(literal, settings)) << "seed " << seed();
    EXPECT_EQ(plain, world_of("include \"part.lrs\"", {}, {{"part.lrs", literal}}));
    EXPECT_EQ(plain, world_of("group { include \"part.lrs\" }", {}, {{"part.lrs", literal}}));
}

INSTANTIATE_TEST_SUITE_P(Seeds, SameWorld, ::testing::Range(1u, 21u));

}  // namespace
}  // namespace lray::test
