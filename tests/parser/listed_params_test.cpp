// The params of a scene as they are listed: what they are, what they may be, and that their text
// brings the same scene back.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/parser/program.h"
#include "tests/parser/same_world.h"

namespace lray::test {
namespace {

using parser::ParamValue;
using Files = std::vector<Companion>;

Ran run_with(std::string_view scene, const std::vector<parser::Definition>& definitions,
             const Files& files = {}) {
    parser::LoadSettings settings;
    settings.definitions = definitions;
    return run(scene, settings, files);
}

std::vector<ParamValue> listed(std::string_view scene,
                               const std::vector<parser::Definition>& definitions = {}) {
    return run_with(scene, definitions).params;
}

/// The values that are listed, as they would be given on the command line.
std::vector<parser::Definition> as_definitions(const std::vector<ParamValue>& params) {
    std::vector<parser::Definition> definitions;
    for (const ParamValue& param : params) {
        EXPECT_TRUE(param.has_literals) << param.name;
        definitions.push_back({param.name, param.value});
    }
    return definitions;
}

std::string joined(const std::vector<std::string>& texts) {
    std::string result;
    for (const std::string& text : texts) result += (result.empty() ? "" : " | ") + text;
    return result;
}

TEST(ListedParams, HaveTheirValueTheirDefaultAndTheirPlace) {
    const Ran ran = run_with("param b = 2\n  param a = \"x\" // y\nlet c = 1\n", {{"b", "7.5"}});
    ASSERT_EQ(ran.params.size(), 2u);
    EXPECT_EQ(ran.params[0].name, "b");
    EXPECT_EQ(ran.params[0].value, "7.5");
    EXPECT_EQ(ran.params[0].default_value, "2");
    EXPECT_FALSE(ran.params[0].range);
    EXPECT_TRUE(ran.params[0].choices.empty());
    EXPECT_EQ(place_of(ran.loaded.sources, ran.params[0].place), "1:7");
    EXPECT_EQ(ran.params[1].name, "a");
    EXPECT_EQ(ran.params[1].value, "\"x\"");
    EXPECT_EQ(place_of(ran.loaded.sources, ran.params[1].place), "2:9");
}

TEST(ListedParams, BetweenBoundsAreRanges) {
    const auto params = listed(
        "param n = 3 in [1, 10]\nparam x = 0.5 in [0, 2]\nparam y = 1 in [0, 2.5]\n"
        "param i: int = 1 in [0.5, 2.5]\nparam z = 4 in [-1e20, 1e20]",
        {{"x", "0.25"}});
    ASSERT_EQ(params.size(), 5u);
    const auto is_whole = [&](std::size_t i) { return params[i].range.value().is_whole; };
    EXPECT_TRUE(is_whole(0));
    EXPECT_FALSE(is_whole(1));
    EXPECT_FALSE(is_whole(2));
    EXPECT_TRUE(is_whole(3));
    EXPECT_TRUE(is_whole(4));
    const parser::ParamRange& range = *params[1].range;
    EXPECT_EQ(range.least, 0.0);
    EXPECT_EQ(range.greatest, 2.0);
    EXPECT_EQ(range.value, 0.25);
    EXPECT_EQ(range.default_value, 0.5);
}

// What is_whole says is what the language accepts.
TEST(ListedParams, WholeRangesTakeNoFraction) {
    const std::string scene =
        "param a = 3 in [1, 10]\nparam b = 2.5 in [1, 10]\nparam c: int = 3 in [0.5, 9.5]\n";
    for (const ParamValue& param : listed(scene)) {
        const bool is_taken = run_with(scene, {{param.name, "4.5"}}).usage_mistakes.empty();
        EXPECT_NE(param.range.value().is_whole, is_taken) << param.name;
    }
}

TEST(ListedParams, OfAListAreChoices) {
    const std::string scene =
        "param s = \"a b\" in [\"a b\", \"c\\\"d\"]\nparam n = 2 in [1, 2, 4]\n"
        "param c = #ff0000 in [#ff0000, rgb(0.1, 0.2, 0.3)]\n"
        "param v = [1, 2] in [[1, 2], [3, 4]]\nparam b = true in [true, false]";
    const auto params = listed(scene);
    ASSERT_EQ(params.size(), 5u);
    EXPECT_EQ(joined(params[0].choices), "\"a b\" | \"c\\\"d\"");
    EXPECT_EQ(joined(params[1].choices), "1 | 2 | 4");
    EXPECT_EQ(joined(params[2].choices), "#ff0000 | rgb(0.1, 0.2, 0.3)");
    EXPECT_EQ(joined(params[3].choices), "[1, 2] | [3, 4]");
    EXPECT_EQ(joined(params[4].choices), "true | false");
    for (const ParamValue& param : params) {
        EXPECT_FALSE(param.range);
        for (const std::string& choice : param.choices) {
            const Ran ran = run_with(scene, {{param.name, choice}});
            EXPECT_TRUE(ran.usage_mistakes.empty()) << choice << joined(ran.usage_mistakes);
            const auto now = std::ranges::find(ran.params, param.name, &ParamValue::name);
            ASSERT_NE(now, ran.params.end());
            EXPECT_EQ(now->value, choice);
        }
    }
}

TEST(ListedParams, BringTheSameSceneBackThroughTheirText) {
    // Each shape has bits that show its param.
    const std::string scene = R"(
param x = 0.1 + 0.2
param tiny = 5e-324
param big = -1.7976931348623157e308
param zero = -0.0
param p = [1 / 3, -2 / 7, 1e-17]
param rows = [[1 / 3, 2, 3], [4, 5, 6]]
param mixed = [1, "a", [true, #123456], []]
param hex = #12ab9f
param paint = hsv(77, 0.3, 0.8) in [hsv(77, 0.3, 0.8), gray(0.3)]
param clear = #12ab9f80
param text = "tab\t quote\" back\\slash {x} \u{1F600} line\n \u{1}"
sphere { center: [x, tiny / 5e-324, zero], radius: 1 / big * -1e308 }
sphere { center: p, radius: len(text) }
sphere { center: rows[0], radius: len(mixed) }
sphere { material { diffuse: hex } }
sphere { material { diffuse: paint } }
sphere { center: [clear.a, clear.r, 1 / (zero + 1)] }
info { title: text }
)";
    const Ran first = run(scene);
    ASSERT_TRUE(first.loaded.scene) << first.told();
    ASSERT_EQ(first.params.size(), 11u);
    EXPECT_EQ(first.params[7].value, "#12ab9f");
    EXPECT_EQ(first.params[9].value, "#12ab9f80");
    EXPECT_EQ(first.params[3].value, "-0");
    // Other defaults: what comes back comes from the text.
    std::string other = scene;
    for (const auto& [from, to] :
         std::vector<std::pair<std::string, std::string>>{{"0.1 + 0.2", "1"},
                                                          {"hsv(77, 0.3, 0.8) in", "gray(0.3) in"},
                                                          {"\"tab", "\"\" + \"cab"}}) {
        other.replace(other.find(from), from.size(), to);
    }
    ASSERT_NE(world_text(*run(other).loaded.scene), world_text(*first.loaded.scene));
    const Ran again = run_with(other, as_definitions(first.params));
    ASSERT_TRUE(again.loaded.scene) << again.told() << joined(again.usage_mistakes);
    EXPECT_EQ(world_text(*again.loaded.scene), world_text(*first.loaded.scene));
    EXPECT_EQ(again.loaded.scene->info, first.loaded.scene->info);
    for (std::size_t i = 0; i < first.params.size(); ++i) {
        EXPECT_EQ(again.params[i].value, first.params[i].value);
    }
}

TEST(ListedParams, OfAnImportHaveItsAlias) {
    const Files files = {
        {"lib.lrs", "import \"deep.lrs\" as d\nparam n = 4 in [0, 9]\nlet m = d.k"},
        {"deep.lrs", "param k = 1"},
        {"part.lrs", "param inside = 2"}};
    const std::string scene =
        "param first = 0\nimport \"lib.lrs\" as l\ninclude \"part.lrs\"\n"
        "sphere { center: [l.n, l.m, inside], radius: 1 + first }";
    const Ran ran = run_with(scene, {}, files);
    ASSERT_TRUE(ran.loaded.scene) << ran.told();
    std::vector<std::string> names;
    for (const ParamValue& param : ran.params) names.push_back(param.name);
    EXPECT_EQ(joined(names), "first | l.d.k | l.n | inside");
    EXPECT_TRUE(place_of(ran.loaded.sources, ran.params[2].place).ends_with("/lib.lrs:2:7"));
    const Ran changed =
        run_with(scene, {{"l.n", "5"}, {"l.d.k", "6"}, {"inside", "7"}, {"first", "8"}}, files);
    ASSERT_TRUE(changed.loaded.scene) << changed.told();
    EXPECT_EQ(changed.loaded.scene->spheres[0].center, (DVec3{5.0, 6.0, 7.0}));
    EXPECT_EQ(changed.params[1].value, "6");
    EXPECT_EQ(changed.params[1].default_value, "1");
}

TEST(ListedParams, LeaveOutWhatDoesNotFit) {
    EXPECT_EQ(listed("param a = 7 in [0, 5]\nparam b = 1").size(), 1u);
    EXPECT_EQ(listed("param a: string = 7\nparam b = 1").size(), 1u);
    EXPECT_EQ(listed("param a = 1 / 0\nparam b = 1").size(), 1u);
    EXPECT_EQ(listed("param a = 1 in [0, 5]\nparam b = 1", {{"a", "9"}}).size(), 1u);
    // The default does not fit, what is given does.
    EXPECT_EQ(listed("param a = \"x\" in [0, 5]\nparam b = 1", {{"a", "2"}}).size(), 1u);
    EXPECT_TRUE(listed("param a = 1\nlet b = ").empty());
}

TEST(ListedParams, WithoutALiteralHaveNoChoices) {
    const auto params = listed(
        "param t = rotation_y(30) in [rotation_y(30), rotation_y(60)]\n"
        "param c = #102030 in [#102030, rotation_y(60)]\n"
        "fn f(x) = x\nparam g = f");
    ASSERT_EQ(params.size(), 3u);
    EXPECT_FALSE(params[0].has_literals);
    EXPECT_EQ(params[0].value.substr(0, 8), "matrix([");
    EXPECT_TRUE(params[1].has_literals);
    EXPECT_FALSE(params[2].has_literals);
    for (const ParamValue& param : params) EXPECT_TRUE(param.choices.empty()) << param.name;
}

std::string nested(int depth) {
    return repeated("[", static_cast<std::size_t>(depth)) + "\"x\"" +
           repeated("]", static_cast<std::size_t>(depth));
}

TEST(ListedParams, NestAsDeepAsTheyAreRead) {
    const auto deep = listed("param a = " + nested(32) + "\nparam b = " + nested(33));
    ASSERT_EQ(deep.size(), 2u);
    EXPECT_TRUE(deep[0].has_literals);
    EXPECT_FALSE(deep[1].has_literals);
    const Ran again = run_with("param a = []\n", {{"a", deep[0].value}});
    ASSERT_EQ(again.params.size(), 1u) << joined(again.usage_mistakes);
    EXPECT_EQ(again.params[0].value, nested(32));
}

TEST(ListedParams, AreBounded) {
    std::string many;
    for (std::size_t i = 0; i <= parser::kMaxListedParams; ++i)
        many += fmt::format("param p{} = 1\n", i);
    EXPECT_EQ(listed(many).size(), parser::kMaxListedParams);

    const auto of_choices = [](std::size_t count) {
        return listed(fmt::format("param n = 1 in range(1, {})", count + 1)).at(0).choices.size();
    };
    EXPECT_EQ(of_choices(parser::kMaxListedChoices), parser::kMaxListedChoices);
    EXPECT_EQ(of_choices(parser::kMaxListedChoices + 1), 0u);

    const auto of_text = [](std::size_t size) {
        return listed(fmt::format("param s = \"{}\"", std::string(size - 2, 'x'))).at(0);
    };
    EXPECT_TRUE(of_text(parser::kMaxParamText).has_literals);
    EXPECT_EQ(of_text(parser::kMaxParamText).value.size(), parser::kMaxParamText);
    EXPECT_FALSE(of_text(parser::kMaxParamText + 1).has_literals);
    EXPECT_LE(of_text(parser::kMaxParamText + 1000).value.size(), parser::kMaxParamText);

    // Eleven lists of 100 kB each.
    std::string wide =
        "let xs = [for i in range(1000): str(10000 + i, \"" + std::string(93, 'x') + "\")]\n";
    for (int i = 0; i < 11; ++i) wide += fmt::format("param w{} = xs[0] in xs\n", i);
    const auto params = listed(wide);
    ASSERT_EQ(params.size(), 11u);
    std::size_t size = 0;
    for (const ParamValue& param : params) {
        for (const std::string& choice : param.choices) size += choice.size();
    }
    EXPECT_EQ(params[0].choices.size(), 1000u);
    EXPECT_EQ(params[10].choices.size(), 0u);
    EXPECT_LE(size, parser::kMaxChoicesText);
}

TEST(Definitions, OfFilesAreFoundWhereTheDefaultWouldBe) {
    const Files files = {{"lib/part.lrs", "param mesh_file = \"a.obj\"\nmesh { file: mesh_file }"},
                         {"lib/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
                         {"lib/b.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n"}};
    for (const char* value : {"b.obj", "\"b.obj\""}) {
        const Ran ran = run_with("include \"lib/part.lrs\"", {{"mesh_file", value}}, files);
        ASSERT_TRUE(ran.loaded.scene) << value << ran.told();
        EXPECT_EQ(ran.loaded.scene->meshes.at(0).positions.at(1).x, 2.0f) << value;
    }
}

TEST(Definitions, OfColoursMayBeLinear) {
    const auto value_of = [](const char* text) {
        const Ran ran = run_with("param c = #fff\nprint(c)", {{"c", text}});
        return ran.usage_mistakes.empty() ? ran.printed : "refused";
    };
    EXPECT_EQ(value_of("rgb(0.25, -1, 2)"), "rgb(0.25, -1, 2)\n");
    for (const char* text : {"rgb(1, 2)", "rgb(1, 2, true)", "rgb(r: 1, g: 2, b: 3)", "gray(1)",
                             "rgb(1, 2, 1 + 1)", "rgb(1, 2, 3).r"}) {
        EXPECT_EQ(value_of(text), "refused") << text;
    }
}

}  // namespace
}  // namespace lray::test
