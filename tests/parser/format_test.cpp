// The formatter: what the canonical style is, and that nothing but blanks, line ends, separators
// and spellings changes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "parser/tools/format.h"
#include "parser/tools/format_layout.h"
#include "tests/parser/formatted.h"
#include "tests/parser/loaded.h"
#include "tests/support/random.h"

namespace lray::test {
namespace {

TEST(Format, ItemsStandOnLinesOfTheirOwn) {
    expect_format("let a=1;let b=2,sphere{ }box{ }", "let a = 1\nlet b = 2\nsphere { }\nbox { }\n");
    expect_format("sphere { radius:1;center:[0,1,0] }",
                  "sphere { radius: 1, center: [0, 1, 0] }\n");
    expect_format("sphere { radius:1\ncenter:[0,1,0] }",
                  "sphere {\n  radius: 1\n  center: [0, 1, 0]\n}\n");
    expect_format("sphere {\n\tradius:1,\n\tcenter:[0,1,0];\n\t}",
                  "sphere {\n  radius: 1\n  center: [0, 1, 0]\n}\n");
    expect_format(";;,\nsphere { }", "sphere { }\n");
    expect_format("", "");
    expect_format("\n\n  \n", "");
}

TEST(Format, BlocksOnOneLineGetTheirCommas) {
    expect_format("group {m: red { } b: 2;;c: 3,}", "group { m: red { }, b: 2, c: 3 }\n");
    expect_format("sphere{material{diffuse:red}radius:2}",
                  "sphere { material { diffuse: red }, radius: 2 }\n");
    expect_format("sphere {}\nbox {\n\n}\ndisk \"top\"{}",
                  "sphere { }\nbox { }\ndisk \"top\" { }\n");
}

TEST(Format, BlocksWithStatementsAreOpened) {
    expect_format("group { let a = 1, sphere { radius: a } }",
                  "group {\n  let a = 1\n  sphere { radius: a }\n}\n");
    expect_format("fn f(x) { return x*2 }", "fn f(x) { return x * 2 }\n");
    expect_format("if a { b { } } else if c { d { } } else { include \"e.lrs\" }",
                  "if a { b { } } else if c { d { } } else {\n  include \"e.lrs\"\n}\n");
    expect_format("let p = [group { for i in x { s { } } }, q]",
                  "let p = [group {\n  for i in x { s { } }\n}, q]\n");
    expect_format("while i<3 { i=i+1 }", "while i < 3 { i = i + 1 }\n");
}

TEST(Format, ElseStandsBehindTheBrace) {
    expect_format("if a {\nb { }\n}\nelse\nif c {\nd { }\n}\n\nelse {\ne { }\n}",
                  "if a {\n  b { }\n} else if c {\n  d { }\n} else {\n  e { }\n}\n");
    expect_format("if a {\nb { }\n}  // so\nelse {\nc { }\n}",
                  "if a {\n  b { }\n}  // so\nelse {\n  c { }\n}\n");
    expect_format("let x = if a then red { }\nelse blue { }",
                  "let x = if a then red { }\n  else blue { }\n");
}

TEST(Format, WideBlocksAreOpened) {
    const std::string head = "sphere { radius: 1, center: [0, 1, 0], material { diffuse: red } ";
    const std::string name(kWidth - head.size() - std::string_view("a: , b: 1 }").size(), 'n');
    const std::string fits =
        head.substr(0, head.size() - 1) + ", a: " + name.substr(1) + ", b: 1 }\n";
    ASSERT_EQ(fits.size(), kWidth + 1);
    expect_format(fits, fits);
    expect_format(fits.substr(0, fits.size() - 2) + ", c: 1 }",
                  "sphere {\n  radius: 1\n  center: [0, 1, 0]\n  material { diffuse: red }\n  a: " +
                      name.substr(1) + "\n  b: 1\n  c: 1\n}\n");
}

TEST(Format, BlankLinesAreKeptOnceBetweenItems) {
    expect_format("\n\nlet a = 1\n\n\n\nlet b = 2\ngroup {\n\n  c { }\n\n  d { }\n\n}\n\n",
                  "let a = 1\n\nlet b = 2\ngroup {\n  c { }\n\n  d { }\n}\n");
    expect_format("let a = [\n\n  1,\n\n\n  2\n\n]", "let a = [\n  1,\n\n  2\n]\n");
}

TEST(Format, CommentsStayWhereTheyAre) {
    expect_format("// first  \nlet a=1// one\n  /// doc\nfn f(x)=x /* two */\n",
                  "// first\nlet a = 1  // one\n/// doc\nfn f(x) = x /* two */\n");
    expect_format("group {// head\na { },// behind a comma\n// own\n}\n// end",
                  "group {  // head\n  a { }  // behind a comma\n  // own\n}\n// end\n");
    expect_format("s { a: 1 /* c */, b: 2, /* d */ c: 3 }",
                  "s { a: 1 /* c */, b: 2, /* d */ c: 3 }\n");
    expect_format("s { a: 1, /* c */\n/* d */ b: 2 }", "s {\n  a: 1 /* c */\n  /* d */ b: 2\n}\n");
    expect_format("let a = [1, // one\n2 // two\n, 3 /* three */,\n]",
                  "let a = [1,  // one\n  2  // two\n  , 3 /* three */\n]\n");
    expect_format("let a = /* x\r\n  /* nested */ y */ 1\r\n",
                  "let a = /* x\n  /* nested */ y */ 1\n");
    expect_format("{ /* nothing */ }", "{ /* nothing */ }\n");
}

TEST(Format, NumbersAndColoursHaveOneSpelling) {
    expect_format("let a = [.5,1.,1.e5,0XFF_A0,1E-3,1_000.5,.25m,2.cm,-.5,1.0]",
                  "let a = [0.5, 1, 1e5, 0xff_a0, 1e-3, 1_000.5, 0.25m, 2cm, -0.5, 1.0]\n");
    expect_format("let c = [#FFF,#a0B1C2,#DC143CFF]", "let c = [#fff, #a0b1c2, #dc143cff]\n");
    expect_format("lrs 1.\nlet s = \"#FFF .5\"", "lrs 1.\nlet s = \"#FFF .5\"\n");
}

TEST(Format, BlanksAroundOperators) {
    expect_format("let a=-b+ -c*(d-1)^-2", "let a = -b + -c * (d - 1) ^ -2\n");
    expect_format("let a = f (x , y:2) [0] . z", "let a = f(x, y: 2)[0].z\n");
    expect_format("let a=not(b and(c or d))", "let a = not (b and (c or d))\n");
    expect_format("let a=if(b)then[1]else(2)", "let a = if (b) then [1] else (2)\n");
    expect_format("let a = - - b - - c", "let a = - -b - -c\n");
    expect_format("let f=fn (x:number=1)=x", "let f = fn(x: number = 1) = x\n");
    expect_format("let a:vec3=[for i,x in f (3) if x>1:x*i]",
                  "let a: vec3 = [for i, x in f(3) if x > 1: x * i]\n");
    expect_format("for i,x in list{ }", "for i, x in list { }\n");
    expect_format("param n=200 in[0,5000]", "param n = 200 in [0, 5000]\n");
    expect_format("import \"a.lrs\"as m", "import \"a.lrs\" as m\n");
    expect_format("mat.glass(tint:#fff){ }", "mat.glass(tint: #fff) { }\n");
    expect_format("component c(a=1,b=2,){ }", "component c(a = 1, b = 2) { }\n");
}

TEST(Format, LinesThatGoOnAreIndented) {
    expect_format("let total = a +\nb - (c\n+ d)", "let total = a +\n  b - (c\n    + d)\n");
    expect_format("s {\na:\n\n5\nb: 1 *\n// two\n2\n}",
                  "s {\n  a:\n    5\n  b: 1 *\n    // two\n    2\n}\n");
}

TEST(Format, ListsKeepTheirBreaks) {
    expect_format("let a = [\n1,2,\n3,4,\n]", "let a = [\n  1, 2,\n  3, 4\n]\n");
    expect_format("let a = f([1,\n2])", "let a = f([1,\n  2])\n");
    expect_format("let a = f(b, [\n1,\n2\n], c)", "let a = f(b, [\n  1,\n  2\n], c)\n");
    expect_format("let a = [1\n,2\n,3]", "let a = [1,\n  2,\n  3]\n");
    expect_format("let a = [\n\n]", "let a = []\n");
}

TEST(Format, WideListsAreFilled) {
    std::string list = "let a = [";
    for (int i = 0; i < 60; ++i) list += "10,";
    std::string wanted = "let a = [\n  ";
    for (int i = 0; i < 60; ++i) {
        const bool ends_line = i == 23 || i == 47;  // 2 + 24 * 4 columns
        wanted += i == 59 ? "10\n]\n" : ends_line ? "10,\n  " : "10, ";
    }
    // A blank behind the last comma of a line is not written: 24.5 elements would be too many.
    expect_format(list + "]", wanted);
}

TEST(Format, SeparatorsThatMeanSomethingStay) {
    // All are mistakes, and stay the same ones.
    expect_format("s { a: 1, 2 }", "s { a: 1, 2 }\n");
    expect_format("s {\na: 1; + 2\n}", "s {\n  a: 1; +2\n}\n");
    expect_format("s {\na:, 5\n}", "s {\n  a:, 5\n}\n");
    expect_format("let a = [1,,]\nlet b = a[0,]\nlet c = (1,)",
                  "let a = [1,,]\nlet b = a[0,]\nlet c = (1,)\n");
    expect_format("s\n{ a: 1 }", "s\n{ a: 1 }\n");
}

TEST(Format, GluedTokensStayTheTokensTheyAre) {
    for (const char* const text :
         {"let a = 1 .x", "let a = b. 5", "let a = - =b", "let a = . . .", "let a = b . . c",
          "let a = - > b", "let a = ! = b", "let a = 1 e5", "let a = 1 .5", "let a = .5 .5"}) {
        expect_stable(text);
    }
}

TEST(Format, WhatHasLexicalErrorsOrLooseBracketsIsLeftAlone) {
    for (const auto& [text, code] :
         std::vector<std::pair<const char*, const char*>>{{"sphere { radius: 1", "E0103"},
                                                          {"sphere { radius: (1 }", "E0101"},
                                                          {"sphere { radius: 1 } }", "E0104"},
                                                          {"let a = \"open", "E0005"},
                                                          {"let a = 1 /* open", "E0011"},
                                                          {"let a = 3px", "E0007"},
                                                          {"let \xD0\xB0 = 1", "E0004"},
                                                          {"# comment", "E0006"},
                                                          {"let a = 1  // \xFF", "E0002"}}) {
        const Formatted formatted(text);
        EXPECT_FALSE(formatted.text) << text;
        EXPECT_EQ(formatted.codes, code) << text;
    }
}

TEST(Format, DeepNestingIsALimit) {
    parser::LoadLimits limits;
    limits.nesting = 20;
    const auto nested = [](std::size_t depth) {
        return "let a = " + std::string(depth, '[') + std::string(depth, ']');
    };
    EXPECT_EQ(Formatted(nested(20), limits).text, nested(20) + "\n");
    const Formatted deep(nested(21), limits);
    EXPECT_FALSE(deep.text);
    EXPECT_EQ(deep.codes, "E0115");
}

TEST(Format, ResultThatOutgrowsTheLimitIsRefused) {
    parser::LoadLimits limits;
    std::string text = std::string(200, '{');
    for (int i = 0; i < 1000; ++i) text += "a:1;";
    text += std::string(200, '}');
    limits.scene_bytes = 100'000;
    const Formatted formatted(text, limits);
    EXPECT_FALSE(formatted.text);
    EXPECT_EQ(formatted.codes, "E0516");
}

TEST(Format, ExamplesAreFormatted) {
    const Examples examples;
    ASSERT_GE(examples.names().size(), 3u);
    for (const std::string& name : examples.names()) {
        const std::string text = examples.text(name);
        EXPECT_EQ(Formatted(text).text, text) << name << ": run `lray --fmt` over it";
    }
}

/// The cases of the diagnostics, mistakes among them: texts by people.
std::vector<std::string> error_cases() {
    std::vector<std::string> texts;
    const std::string directory = std::string(LRAY_SOURCE_DIR) + "/tests/errors";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
        if (entry.path().extension() == ".lrs") texts.push_back(read_bytes(entry.path().string()));
    }
    return texts;
}

TEST(Format, TextsWithMistakesKeepThem) {
    std::size_t count = 0;
    for (const std::string& text : error_cases()) {
        const std::string codes = load_text(text).codes();
        const bool is_understood =
            codes.find("E00") == codes.npos && codes.find("E01") == codes.npos;
        const Formatted formatted(text);
        if (!formatted.text || !is_understood) continue;
        ++count;
        expect_stable(text);
        EXPECT_EQ(sorted_codes(load_text(*formatted.text)), sorted_codes(load_text(text)))
            << text << "\nformatted:\n"
            << *formatted.text;
    }
    EXPECT_GT(count, 100u);
}

/// Statements, expressions and comments of all kinds, put together at random; always valid syntax.
class Program {
 public:
    explicit Program(std::uint64_t seed) : random_(seed) {}

    std::string items(int depth) {
        std::string text;
        const std::uint64_t count = random_.below(depth > 0 ? 5 : 2);
        for (std::uint64_t i = 0; i < count; ++i) text += item(depth) + separator();
        return text;
    }

 private:
    std::string pick(std::initializer_list<const char*> choices) {
        return std::data(choices)[random_.below(choices.size())];
    }
    std::string separator() {
        return pick(
            {"\n", ",", ";", "\n\n\n", ", // c\n", " /* c */\n", ",/* c */", "\r\n", ";\n // c\n"});
    }
    std::string blank() { return pick({" ", " ", "  ", "\t", " /* c */ "}); }
    std::string name() {
        return pick({"a", "radius", "ball", "lib.b", "xs[0]", "long_name_of_a_thing"});
    }
    std::string body(int depth) {
        return blank() + "{" + pick({"", "\n", " ", " // c\n"}) + items(depth - 1) + "}";
    }
    std::string item(int depth) {
        switch (random_.below(12)) {
            case 0:
                return "let a" + blank() + "=" + blank() + expression(depth);
            case 1:
                return "if " + expression(0) + body(depth) +
                       (random_.below(2) == 0 ? pick({"", "\n", " "}) + "else" + body(depth) : "");
            case 2:
                return "for i, x in " + expression(0) + body(depth);
            case 3:
                return "fn f(a, b: number = " + expression(depth - 1) + ") = " + expression(depth);
            case 4:
                return "component c(" + pick({"", "\n"}) + "a = 1," + pick({"", "\n"}) + "b = 2)" +
                       body(depth);
            case 5:
                return "return " + expression(depth);
            case 6:
                return "print(" + expression(depth) + ")";
            case 7:
                return "a = " + expression(depth);
            case 8:
            case 9:
                return name() + pick({"", " \"label\""}) + body(depth);
            default:
                return "radius" + pick({":", " : ", ":\n"}) + expression(depth);
        }
    }
    std::string operators() {
        return pick({"+", "-", " * ", "/ ", "^", " and ", " or\n", "==", " <\n", "% ", "- // c\n"});
    }
    std::string expression(int depth) {
        if (depth <= 0) {
            return pick({"1", ".5", "1.", "0XFF", "1E3m", "#FFF", "\"a, b\"", "true", "a.b",
                         "x [1]", "f ( x )", "-a", "not b", "- -c", "[1,2,3]", "[]"});
        }
        switch (random_.below(9)) {
            case 0:
                return "[" + list(depth) + "]";
            case 1:
                return "f(" + list(depth) + ")";
            case 2:
                return "(" + pick({"", "\n"}) + expression(depth - 1) + pick({"", "\n"}) + ")";
            case 3:
                return "if " + expression(0) + pick({" ", "\n"}) + "then " + expression(depth - 1) +
                       pick({" ", "\n"}) + "else " + expression(depth - 1);
            case 4:
                return "[for x in " + expression(0) + " if x: " + expression(depth - 1) + "]";
            case 5:
                return name() + body(depth);
            case 6:
                return "fn(x) = " + expression(depth - 1);
            default:
                return expression(depth - 1) + operators() + expression(depth - 1);
        }
    }
    std::string list(int depth) {
        std::string text = pick({"", "\n", " ", " // c\n"});
        const std::uint64_t count = 1 + random_.below(random_.below(4) == 0 ? 30 : 5);
        for (std::uint64_t i = 0; i < count; ++i) {
            if (i > 0) text += pick({",", ", ", "\n,", ",\n", ", // c\n", "/* c */,", ", /* c */"});
            text += expression(depth - 1);
        }
        return text + pick({"", "\n", ",", ",\n", " // c\n", " /* c */"});
    }

    Random random_;
};

TEST(Format, RandomProgramsAreStable) {
    const std::uint64_t seed = 17;
    LRAY_TRACE_SEED(seed);
    for (std::uint64_t i = 0; i < 4000; ++i) {
        const std::string text = Program(seed * 100'000 + i).items(4);
        ASSERT_TRUE(Formatted(text).text) << text << Formatted(text).codes;
        ASSERT_NO_FATAL_FAILURE(expect_stable(text)) << i;
    }
}

TEST(Format, MutatedScenesAreStable) {
    constexpr std::array kInserted = {
        "{",   "}",     "[",      "]",     "(",    ")",   ",",       ";",
        "\n",  "\n\n",  " ",      ":",     "=",    ".",   "-",       "+ ",
        "if ", "else ", "then ",  "for ",  "let ", "in ", "/* c */", "// c\n",
        "1.",  ".5 ",   "\"s\" ", "#ABC ", "{ }",  "[ ]", "name "};
    const std::uint64_t seed = 23;
    LRAY_TRACE_SEED(seed);
    Random random(seed);
    std::vector<std::string> texts = error_cases();
    const Examples examples;
    for (const std::string& name : examples.names()) texts.push_back(examples.text(name));
    for (std::uint64_t i = 0; i < 300; ++i) texts.push_back(Program(seed + i).items(4));
    std::size_t count = 0;
    for (int i = 0; i < 8000; ++i) {
        std::string text = texts[random.below(texts.size())];
        const std::uint64_t changes = 1 + random.below(4);
        for (std::uint64_t k = 0; k < changes && !text.empty(); ++k) {
            const std::size_t at = random.below(text.size());
            switch (random.below(3)) {
                case 0:
                    text.erase(at, 1 + random.below(6));
                    break;
                case 1:
                    text.insert(at, kInserted[random.below(kInserted.size())]);
                    break;
                default: {
                    const std::string part = text.substr(at, random.below(40));
                    text.insert(random.below(text.size()), part);
                    break;
                }
            }
        }
        if (!Formatted(text).text) continue;
        ++count;
        ASSERT_NO_FATAL_FAILURE(expect_stable(text)) << i;
    }
    EXPECT_GT(count, 2000u);
}

}  // namespace
}  // namespace lray::test
