// Memory of values while loops and calls run: what is dropped is given back, what is in use stays
// right. Ran under AddressSanitizer these tests see each read of memory that was given back.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "tests/parser/program.h"

namespace lray::test {
namespace {

/// So little that only what is given back makes room for these programs.
std::string told_in(std::uint64_t value_bytes, std::string_view scene) {
    parser::LoadSettings settings;
    settings.limits.value_bytes = value_bytes;
    return told_by(scene, settings);
}

TEST(ValueMemory, IsGivenBackByLoops) {
    EXPECT_EQ(told_in(200'000, R"(
var p = [0, 0, 0]
for i in range(100000) {
  let v = [i, 1, 2] + [1, 2, 3]
  p = p + [1, 0, v.y - 2]
}
print(p)
)"),
              "[100000, 0, 100000]\n");
    EXPECT_EQ(told_in(1'000'000, R"(
var xs = []
for i in range(2000) { xs = concat(xs, [i]) }
print(len(xs), sum(xs))
var rows = []
for i in range(1000) { rows = concat(rows, [[i, i]]) }
print(len(rows), rows[999])
)"),
              "2000 1999000\n1000 [999, 999]\n");
    EXPECT_EQ(told_in(300'000, R"(
var s = ""
var r = record { n: 0, last: [] }
var f = fn(x) = x
var i = 0
while i < 20000 {
  i = i + 1
  s = str(i, ":", s)
  if len(s) > 100 { s = slice([s], 0)[0] + "!" }
  if len(s) > 200 { s = "" }
  r = r { n: r.n + 1, last: [i, "x", i] }
  let k = [i, i]
  f = fn(x) = [x, k.x]
}
print(len(s) <= 200, r.n, r.last, f(1))
)"),
              "true 20000 [20000, \"x\", 20000] [1, 20000]\n");
}

TEST(ValueMemory, IsGivenBackByCalls) {
    EXPECT_EQ(told_in(1'000'000, R"(
fn squares(n) = [for i in range(n): i * i]
fn busy(n) {
  var last = []
  for i in range(n) { last = squares(300) }
  return last
}
print(busy(3000)[299])
print(len(map(range(1000), fn(i) = sum(squares(100)))))
print(len([for i in range(200000) if [i, i, i].x < 0: i]))
fn deep(n) = if n == 0 then [0] else concat(deep(n - 1), [sum(squares(200))])
print(len(deep(200)))
)"),
              "89401\n1000\n0\n201\n");
}

TEST(ValueMemory, WhatIsSharedStaysShared) {
    // 1 MB in all; copied for each use it would be 10 GB.
    EXPECT_EQ(told_in(30'000'000, R"(
fn texts() {
  var s = "0123456789abcdef"
  for i in range(14) { s = s + s }
  return [for i in range(10000): record { text: s }]
}
let ts = texts()
print(len(ts), len(ts[9999].text))
fn numbers() {
  let big = [for i in range(20000): i]
  return [for i in range(10000): record { all: big }]
}
let ns = numbers()
print(len(ns), ns[9999].all[19999])
)"),
              "10000 262144\n10000 19999\n");
    // Parts that overlap cannot stay shared: they are paid for.
    EXPECT_NE(told_in(30'000'000, R"(
fn parts() {
  let big = [for i in range(20000): i]
  return [for i in range(10000): record { part: slice(big, i) }]
}
print(len(parts()))
)")
                  .find("E0516"),
              std::string::npos);
    EXPECT_NE(told_in(30'000'000, R"(
component c(xs) { sphere { } }
let big = [for i in range(20000): [i, true]]
for i in range(10000) { let n = c { xs: big }
  n { } }
)")
                  .find("E0516"),
              std::string::npos);
}

TEST(ValueMemory, ValuesNestToALimitAndNotFurther) {
    const std::string wrap = "var a = [true]\nfor i in range({}) {{ a = [a] }}\nprint(len(a))";
    EXPECT_EQ(told_by(fmt::format(fmt::runtime(wrap), 199)), "1\n");
    EXPECT_EQ(told_by(fmt::format(fmt::runtime(wrap), 200)),
              "E0514 2:27 lists are nested more than 200 deep\n");
    EXPECT_EQ(told_by("var a = record { x: 1 }\nfor i in range(1000000) { a = record { x: a } }")
                  .substr(0, 5),
              "E0514");
    EXPECT_EQ(told_by("fn wrap(f) = fn(x) = f(x) + 1\nvar a = fn(x) = x\n"
                      "for i in range(150) { a = wrap(a) }\nprint(a(0))"),
              "150\n");
    EXPECT_EQ(told_by("fn wrap(f) = fn(x) = f(x) + 1\nvar a = fn(x) = x\n"
                      "for i in range(1000000) { a = wrap(a) }")
                  .substr(0, 5),
              "E0514");
}

/// What the variables of a made-up program hold; numbers are whole and below kModulus.
struct Model {
    static constexpr long kModulus = 1009;
    using Vec = std::array<long, 3>;

    long n = 1;
    Vec v{1, 2, 3};
    std::vector<Vec> l{};
    std::string s = "a";
    Vec r_v{};
    std::vector<Vec> r_l{};
    std::string r_s{};
    long f_k = 0;             // f is fn(p) = (p + k) % 1009
    std::vector<long> fs{0};  // likewise

    static std::string text(const Vec& vec) {
        return fmt::format("[{}, {}, {}]", vec[0], vec[1], vec[2]);
    }
    static std::string text(const std::vector<Vec>& list) {
        std::string result = "[";
        for (std::size_t i = 0; i < list.size(); ++i) {
            result += (i > 0 ? ", " : "") + text(list[i]);
        }
        return result + "]";
    }
    static Vec moved(const Vec& vec, long by) {
        return {(vec[0] + by) % kModulus, (vec[1] + by) % kModulus, (vec[2] + by) % kModulus};
    }
    std::string told() const {
        return fmt::format("{} {} {} {} {} {} {} {} {}\n", n, text(v), text(l), s, text(r_v),
                           text(r_l), r_s, text(moved({n, n, n}, f_k)), text(moved(v, fs.back())));
    }
};

constexpr std::string_view kPrelude = R"(
fn adder(k) = fn(p) = (p + k) % 1009
fn turned(p) {
  let waste = [for q in range(400): [q, p.x, q]]
  return [p.y, p.z, (p.x + len(waste)) % 1009]
}
fn grown(list, count) {
  var out = list
  for q in range(count) {
    let waste = [for w in range(300): [w, q, w]]
    out = concat(out, [[q, count, len(waste)]])
    if len(out) > 5 { out = slice(out, len(out) - 4) }
  }
  return out
}
fn packed(p, list, text) {
  let waste = [for q in range(200): record { a: q, b: p }]
  return record { v: p, l: list, s: text, waste: slice(waste, 198) }
}
var n = 1
var v = [1, 2, 3]
var l = []
var s = "a"
var r = packed([0, 0, 0], [], "")
var f = adder(0)
var fs = [adder(0)]
)";
constexpr std::string_view kPrint =
    "print(n, v, l, s, r.v, r.l, r.s, f([n, n, n]), fs[len(fs) - 1](v))";

/// Makes a program step by step, as a tree that is written down and run by the model.
class Generator {
 public:
    explicit Generator(unsigned seed) : random_(seed) {}

    std::string scene() { return std::string(kPrelude) + text_of(body_, "") + std::string(kPrint); }

    std::string expected() {
        Model model;
        std::string told;
        run(body_, model, 0, told);
        return told + model.told();
    }

    void make() { body_ = block(3); }

 private:
    struct Step {
        unsigned kind = 0;
        long a = 0;
        long b = 0;
        std::vector<Step> inner{};
    };
    enum class Exit : std::uint8_t { none, leave, next };

    unsigned below(unsigned count) { return static_cast<unsigned>(random_() % count); }

    static constexpr unsigned kPlain = 15;
    static constexpr unsigned kFor = 15, kWhile = 16, kIf = 17, kBreak = 18, kContinue = 19,
                              kPrintAll = 20;

    std::vector<Step> block(unsigned depth) {
        std::vector<Step> steps;
        const unsigned count = 3 + below(5);
        for (unsigned i = 0; i < count; ++i) {
            Step step;
            step.kind = below(kPlain);
            step.a = 1 + below(9);
            step.b = below(9);
            if (depth > 0 && below(4) == 0) {
                step.kind = kFor + below(3);
                step.inner = block(depth - 1);
                const bool is_loop = step.kind != kIf;
                if (is_loop && below(2) == 0) {
                    const auto at = static_cast<std::ptrdiff_t>(
                        below(static_cast<unsigned>(step.inner.size())));
                    step.inner.insert(step.inner.begin() + at,
                                      {below(2) == 0 ? kBreak : kContinue, 2 + below(5), 0, {}});
                }
            } else if (below(12) == 0) {
                step.kind = kPrintAll;
            }
            steps.push_back(step);
        }
        return steps;
    }

    std::string text_of(const std::vector<Step>& steps, const std::string& loop) {
        std::string text;
        for (const Step& step : steps) text += text_of(step, loop) + "\n";
        return text;
    }

    std::string text_of(const Step& step, const std::string& loop) {
        const std::string i = loop.empty() ? "0" : loop;
        const std::string name = fmt::format("x{}", names_++);
        switch (step.kind) {
            case 0:
                return fmt::format("n = (n * {} + {} + {}) % 1009", step.a, step.b, i);
            case 1:
                return fmt::format("v = (v * {} + [n, {}, {}]) % 1009", step.a, step.b, i);
            case 2:
                return "v = turned(v)";
            case 3:
                return fmt::format("l = grown(l, {})", step.b);
            case 4:
                return "l = concat(l, [v])\nif len(l) > 6 { l = slice(l, 3) }";
            case 5:
                return "l = reverse(l)";
            case 6:
                return fmt::format("l = map(l, fn(p) = (p + {}) % 1009)", step.a);
            case 7:
                return "s = s + str(n)\nif len(s) > 60 { s = str(\"b\", n) }";
            case 8:
                return "r = packed(v, l, s)";
            case 9:
                return "r = r { v: v }";
            case 10:
                return "v = r.v\nl = r.l";
            case 11:
                return "s = r.s";
            case 12:
                return fmt::format("f = adder((n + {}) % 1009)", step.a);
            case 13:
                return "fs = concat(fs, [f])\nif len(fs) > 4 { fs = slice(fs, 2) }\nv = f(v)";
            case 14:
                return fmt::format(
                    "let {0} = [for q in range(500): [q, n, q]]\n"
                    "n = (n + len({0}) + {0}[1].y) % 1009",
                    name);
            case kFor:
                return fmt::format("for {} in range({}) {{\n{}}}", name, step.a,
                                   text_of(step.inner, name));
            case kWhile:
                return fmt::format("var {0} = 0\nwhile {0} < {1} {{\n{0} = {0} + 1\n{2}}}", name,
                                   step.a, text_of(step.inner, name));
            case kIf:
                return fmt::format("if n % 2 == 0 {{\n{}}} else {{ n = (n + 1) % 1009 }}",
                                   text_of(step.inner, loop));
            case kBreak:
                return fmt::format("if n % {} == 0 {{ break }}", step.a);
            case kContinue:
                return fmt::format("if n % {} == 0 {{ continue }}", step.a);
            default:
                return std::string(kPrint);
        }
    }

    static void grow(Model& m, long count) {
        for (long q = 0; q < count; ++q) {
            m.l.push_back({q, count, 300});
            if (m.l.size() > 5) m.l.erase(m.l.begin(), m.l.end() - 4);
        }
    }

    Exit run(const std::vector<Step>& steps, Model& m, long i, std::string& told) {
        for (const Step& step : steps) {
            const Exit exit = run(step, m, i, told);
            if (exit != Exit::none) return exit;
        }
        return Exit::none;
    }

    Exit run(const Step& step, Model& m, long i, std::string& told) {
        constexpr long kModulus = Model::kModulus;
        switch (step.kind) {
            case 0:
                m.n = (m.n * step.a + step.b + i) % kModulus;
                break;
            case 1:
                m.v = {(m.v[0] * step.a + m.n) % kModulus, (m.v[1] * step.a + step.b) % kModulus,
                       (m.v[2] * step.a + i) % kModulus};
                break;
            case 2:
                m.v = {m.v[1], m.v[2], (m.v[0] + 400) % kModulus};
                break;
            case 3:
                grow(m, step.b);
                break;
            case 4:
                m.l.push_back(m.v);
                if (m.l.size() > 6) m.l.erase(m.l.begin(), m.l.begin() + 3);
                break;
            case 5:
                std::reverse(m.l.begin(), m.l.end());
                break;
            case 6:
                for (Model::Vec& p : m.l) p = Model::moved(p, step.a);
                break;
            case 7:
                m.s += std::to_string(m.n);
                if (m.s.size() > 60) m.s = "b" + std::to_string(m.n);
                break;
            case 8:
                m.r_v = m.v;
                m.r_l = m.l;
                m.r_s = m.s;
                break;
            case 9:
                m.r_v = m.v;
                break;
            case 10:
                m.v = m.r_v;
                m.l = m.r_l;
                break;
            case 11:
                m.s = m.r_s;
                break;
            case 12:
                m.f_k = (m.n + step.a) % kModulus;
                break;
            case 13:
                m.fs.push_back(m.f_k);
                if (m.fs.size() > 4) m.fs.erase(m.fs.begin(), m.fs.begin() + 2);
                m.v = Model::moved(m.v, m.f_k);
                break;
            case 14:
                m.n = (m.n + 500 + m.n) % kModulus;
                break;
            case kFor:
                for (long k = 0; k < step.a; ++k) {
                    if (run(step.inner, m, k, told) == Exit::leave) break;
                }
                break;
            case kWhile:
                for (long k = 1; k <= step.a; ++k) {
                    if (run(step.inner, m, k, told) == Exit::leave) break;
                }
                break;
            case kIf:
                if (m.n % 2 == 0) return run(step.inner, m, i, told);
                m.n = (m.n + 1) % kModulus;
                break;
            case kBreak:
                return m.n % step.a == 0 ? Exit::leave : Exit::none;
            case kContinue:
                return m.n % step.a == 0 ? Exit::next : Exit::none;
            default:
                told += m.told();
                break;
        }
        return Exit::none;
    }

    std::mt19937 random_;
    std::vector<Step> body_{};
    unsigned names_ = 0;
};

TEST(ValueMemory, MadeUpProgramsHoldTheValuesOfAModel) {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        Generator generator(seed);
        generator.make();
        const std::string scene = generator.scene();
        parser::LoadSettings settings;
        settings.limits.value_bytes = 2'000'000;
        settings.limits.printed_bytes = 1'000'000'000;
        const Ran loaded = run(scene, settings);
        ASSERT_FALSE(loaded.loaded.has_errors()) << "seed " << seed << "\n"
                                                 << loaded.loaded.text() << scene;
        ASSERT_EQ(loaded.printed, generator.expected()) << "seed " << seed << "\n" << scene;
    }
}

}  // namespace
}  // namespace lray::test
