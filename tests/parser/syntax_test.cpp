// Shapes of the tree: every construct, what binds tighter than what, where lines end, and what is
// decoded while parsing.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/parser/syntax_tree.h"

namespace lray::test {
namespace {

/// The tree of a text without mistakes.
std::string tree_of(std::string_view text) {
    const Parsed parsed = parse_text(text);
    EXPECT_EQ(parsed.errors, "") << text;
    return parsed.tree;
}

std::string value_of(std::string_view expression) {
    return tree_of("x = " + std::string(expression));
}

TEST(Syntax, DefinitionsHaveTypesAndChoices) {
    EXPECT_EQ(tree_of("let a = 1"), "(let a 1)");
    EXPECT_EQ(tree_of("let a: vec3 = [1, 2, 3]"), "(let a:vec3 #[1 2 3])");
    EXPECT_EQ(tree_of("var n: int = 2"), "(var n:int 2)");
    EXPECT_EQ(tree_of("param seed = 42 in [0, 1000]"), "(param seed 42 in #[0 1000])");
    EXPECT_EQ(tree_of("param mode: string = \"a\" in\n  [\"a\", \"b\"]"),
              "(param mode:string \"a\" in [\"a\" \"b\"])");
    EXPECT_EQ(tree_of("param is_on = true"), "(param is_on true)");
}

TEST(Syntax, EveryTypeHasItsName) {
    for (const char* type :
         {"number", "int", "bool", "string", "vec2", "vec3", "vec4", "color", "list", "transform",
          "texture", "material", "node", "record", "function"}) {
        EXPECT_EQ(tree_of(std::string("let a: ") + type + " = b"),
                  std::string("(let a:") + type + " b)");
    }
    EXPECT_EQ(tree_of("let a: any = b"), "(let a b)");
}

TEST(Syntax, FunctionsHaveAValueOrABody) {
    EXPECT_EQ(tree_of("fn f() = 1"), "(fn f () 1)");
    EXPECT_EQ(tree_of("fn f(x: number, y = 2,) = x * y"), "(fn f (x:number y=2) (* x y))");
    EXPECT_EQ(tree_of("fn f(\n  x\n  = 1,\n  y\n) = x"), "(fn f (x=1 y) x)");
    EXPECT_EQ(tree_of("fn f(n) {\n  var i = n\n  i = i + 1\n  return i\n}"),
              "(fn f (n) {(var i n); (= i (+ i 1)); (return i)})");
    EXPECT_EQ(tree_of("fn f(g = fn(x) = x) { }"), "(fn f (g=(fn (x) x)) {})");
    EXPECT_EQ(tree_of("fn f() =\n  1"), "(fn f () 1)");
}

TEST(Syntax, ComponentsHaveABody) {
    EXPECT_EQ(tree_of("component c() { }"), "(component c () {})");
    EXPECT_EQ(tree_of("component c(a, b: color = red) { a { }; children { } }"),
              "(component c (a b:color=red) {(a {}); (children {})})");
}

TEST(Syntax, FunctionValuesReachAsFarAsTheyCan) {
    EXPECT_EQ(value_of("fn(a) = a + 1"), "(= x (fn (a) (+ a 1)))");
    EXPECT_EQ(value_of("fn() = fn(a, b: int = 1) = a or b"),
              "(= x (fn () (fn (a b:int=1) (or a b))))");
    EXPECT_EQ(value_of("map(xs, fn(a) = -a, fn() = 1)"),
              "(= x (call map xs (fn (a) (- a)) (fn () 1)))");
    EXPECT_EQ(value_of("if a then fn() = 1 else fn() = 2"), "(= x (if a (fn () 1) (fn () 2)))");
}

TEST(Syntax, AnElseIfIsAConditionalInTheElseBody) {
    EXPECT_EQ(tree_of("if a { b { } }"), "(if a {(b {})})");
    EXPECT_EQ(tree_of("if a { } else { c: 1 }"), "(if a {} {c: 1})");
    EXPECT_EQ(tree_of("if a { } else if b { } else { c: 1 }"), "(if a {} {(if b {} {c: 1})})");
    EXPECT_EQ(tree_of("if a { }\n\nelse\nif b { }\nelse { }\nif c { }"),
              "(if a {} {(if b {} {})})\n(if c {})");
    EXPECT_EQ(tree_of("if a { if b { } } else { }"), "(if a {(if b {})} {})");
}

TEST(Syntax, LoopsHaveOneNameOrTwo) {
    EXPECT_EQ(tree_of("for a in range(3) { continue }"), "(for a in (call range 3) {continue})");
    EXPECT_EQ(tree_of("for i, a in [b, c] { break }"), "(for i a in [b c] {break})");
    EXPECT_EQ(tree_of("for a in\n  b { }"), "(for a in b {})");
    EXPECT_EQ(tree_of("while a < 1 { a = a + 1 }"), "(while (< a 1) {(= a (+ a 1))})");
}

TEST(Syntax, ComprehensionsMayFilterAndNest) {
    EXPECT_EQ(value_of("[for a in b: a * 2]"), "(= x [for a in b: (* a 2)])");
    EXPECT_EQ(value_of("[for i, a in b if a > i: [i, a]]"),
              "(= x [for i a in b if (> a i): [i a]])");
    EXPECT_EQ(value_of("[\n  for a in b\n  if c\n  : a\n]"), "(= x [for a in b if c: a])");
    EXPECT_EQ(value_of("[for a in [for b in c: b]: [for d in a: d]]"),
              "(= x [for a in [for b in c: b]: [for d in a: d]])");
    EXPECT_EQ(value_of("[for a in b: a][0]"), "(= x (at [for a in b: a] 0))");
}

TEST(Syntax, ImportsAreNamedAfterTheirFile) {
    EXPECT_EQ(tree_of("import \"lib/materials.lrs\" as mat"), "(import \"lib/materials.lrs\" mat)");
    EXPECT_EQ(tree_of("import \"lib/materials.lrs\""), "(import \"lib/materials.lrs\" materials)");
    EXPECT_EQ(tree_of("import \"std:metals.lrs\""), "(import \"std:metals.lrs\" metals)");
    EXPECT_EQ(tree_of("import \"a\\\\b.lrs\""), "(import \"a\\b.lrs\" b)");
    EXPECT_EQ(tree_of("import \"a.lrs\" as\n  b"), "(import \"a.lrs\" b)");
    EXPECT_EQ(parse_text("import \"a.lrs\"; import \"b.lrs\"").import_count, 2u);
    EXPECT_EQ(parse_text("import \"v1.2.lrs\"").tree, "(import \"v1.2.lrs\" ?)");
}

TEST(Syntax, HeadsOfItemsMayBePathsAndCalls) {
    EXPECT_EQ(tree_of("lib.thing \"left\" { }"), "((. lib thing) \"left\" {})");
    EXPECT_EQ(tree_of("pick(2) { }"), "((call pick 2) {})");
    EXPECT_EQ(tree_of("parts[i].shape { }"), "((. (at parts i) shape) {})");
    EXPECT_EQ(tree_of("print(a, sep: b)"), "(call print a sep:b)");
}

TEST(Syntax, OperatorsBindAsTheyDoInTheReference) {
    EXPECT_EQ(value_of("a or b and not c == d"), "(= x (or a (and b (not (== c d)))))");
    EXPECT_EQ(value_of("a + b * c - d"), "(= x (- (+ a (* b c)) d))");
    EXPECT_EQ(value_of("-a ^ b ^ -c"), "(= x (- (^ a (^ b (- c)))))");
    EXPECT_EQ(value_of("a % b / c"), "(= x (/ (% a b) c))");
    EXPECT_EQ(value_of("-a.b[0](c)"), "(= x (- (call (at (. a b) 0) c)))");
    EXPECT_EQ(value_of("if a then b else if c then d else e + 1"),
              "(= x (if a b (if c d (+ e 1))))");
    EXPECT_EQ(value_of("not not a"), "(= x (not (not a)))");
}

TEST(Syntax, ABraceBehindAConditionOpensTheBody) {
    EXPECT_EQ(tree_of("if a { }"), "(if a {})");
    EXPECT_EQ(tree_of("while a.b(c)[0] { }"), "(while (at (call (. a b) c) 0) {})");
    EXPECT_EQ(tree_of("for a in if b then c else d { }"), "(for a in (if b c d) {})");
    EXPECT_EQ(tree_of("if fn() = a { }"), "(if (fn () a) {})");
}

TEST(Syntax, BracketsInAConditionTakeBlocksAgain) {
    EXPECT_EQ(tree_of("if (a { b: 1 }).b > 0 { }"), "(if (> (. (a {b: 1}) b) 0) {})");
    EXPECT_EQ(tree_of("if f(a { }) { }"), "(if (call f (a {})) {})");
    EXPECT_EQ(tree_of("for a in [b { }, c { }] { }"), "(for a in [(b {}) (c {})] {})");
    EXPECT_EQ(tree_of("if a[b { }] { }"), "(if (at a (b {})) {})");
    EXPECT_EQ(tree_of("if (a) { let b = c { } }"), "(if a {(let b (c {}))})");
    EXPECT_EQ(tree_of("for a in [for b in c { }: b { }] { }"),
              "(for a in [for b in (c {}): (b {})] {})");
}

TEST(Syntax, LinesEndItemsButNotInBrackets) {
    EXPECT_EQ(tree_of("a = b +\n  c"), "(= a (+ b c))");
    EXPECT_EQ(tree_of("a = (b\n  + c)"), "(= a (+ b c))");
    EXPECT_EQ(tree_of("a = f(\n  b\n  , c: d\n)"), "(= a (call f b c:d))");
    EXPECT_EQ(tree_of("a = if b\n  then c\n  else d"), "(= a (if b c d))");
    EXPECT_EQ(tree_of("a =\n  b\nc { }"), "(= a b)\n(c {})");
    EXPECT_EQ(tree_of("a: if b then [1,\n 2] else c\nd: 1"), "a: (if b #[1 2] c)\nd: 1");
    EXPECT_EQ(tree_of("a:\n  if b then 1 else 2"), "a: (if b 1 2)");
    EXPECT_EQ(tree_of("a:\n  fn(b) = b"), "a: (fn (b) b)");
    EXPECT_EQ(tree_of("a = b\n\n\n"), "(= a b)");
}

TEST(Syntax, AfterABraceNoSeparatorIsNeeded) {
    EXPECT_EQ(tree_of("if a { b: 1 } c { } for d in e { } fn f() { } let g = 1"),
              "(if a {b: 1})\n(c {})\n(for d in e {})\n(fn f () {})\n(let g 1)");
    EXPECT_EQ(tree_of("a { b: 1, ; c: 2; };"), "(a {b: 1; c: 2})");
    EXPECT_EQ(parse_text("fn f() = 1 fn g() = 2").errors,
              "E0105 1:12 expected `,` or a new line before `fn`\n");
}

TEST(Syntax, DocCommentsBelongToTheNextDefinition) {
    EXPECT_EQ(tree_of("/// One.\nlet a = 1"), "(let a 1 /One./)");
    EXPECT_EQ(tree_of("  ///  One.  \n\n  /// Two.\r\n///\n///Three.\nfn f() = 1"),
              "(fn f () 1 / One.|Two.||Three./)");
    EXPECT_EQ(tree_of("/// A.\nparam a = 1\n/// B.\nvar b = 1\n/// C.\ncomponent c() { }"),
              "(param a 1 /A./)\n(var b 1 /B./)\n(component c () {} /C./)");
    EXPECT_EQ(tree_of("group {\n  /// In here.\n  let a = 1\n}"), "(group {(let a 1 /In here./)})");
}

TEST(Syntax, OtherCommentsAreNoDocComments) {
    EXPECT_EQ(tree_of("// One.\nlet a = 1"), "(let a 1)");
    EXPECT_EQ(tree_of("//// One.\nlet a = 1"), "(let a 1)");
    EXPECT_EQ(tree_of("let a = 1 /// of a\nlet b = 2"), "(let a 1)\n(let b 2)");
    EXPECT_EQ(tree_of("/// One.\n// not this\nlet a = 1"), "(let a 1)");
    EXPECT_EQ(tree_of("/// One.\na { }\nlet b = 1"), "(a {})\n(let b 1)");
    EXPECT_EQ(tree_of("/* /// One. */\nlet a = 1"), "(let a 1)");
}

TEST(Syntax, LiteralsThatRunOnceAreDecodedWhileParsing) {
    EXPECT_EQ(tree_of("sphere { radius: 2 }\nsphere { radius: 3 }"), "#2");
    EXPECT_EQ(tree_of("group { sphere { radius: 2 } }"), "(group {#1})");
    EXPECT_EQ(tree_of("let a = group { sphere { radius: 2 } }"), "(let a (group {#1}))");
    EXPECT_EQ(tree_of("for a in (group { sphere { radius: 2 } }) { }\nsphere { radius: 2 }"),
              "(for a in (group {#1}) {})\n#1");
}

TEST(Syntax, WhatMayRunAnyNumberOfTimesMakesNoNodes) {
    const std::string ball = "group { sphere { radius: 2 } }";
    for (const std::string& text : std::vector<std::string>{
             "if a { " + ball + " }", "if a { } else { " + ball + " }",
             "if a { } else if b { " + ball + " }", "for a in b { " + ball + " }",
             "for a in b sphere { radius: 2 }", "while a { " + ball + " }",
             "while f(" + ball + ") { }", "fn f() { return " + ball + " }", "fn f() = " + ball,
             "fn f(a = " + ball + ") = a", "component c() { " + ball + " }",
             "component c() { if a { } " + ball + " }", "a = [for b in c: " + ball + "]",
             "a = [for b in c if f(" + ball + "): b]", "a = fn() = " + ball,
             "a = group { if b { } for c in d { " + ball + " } }"}) {
        EXPECT_EQ(parse_text(text).node_count, 0u) << text;
        EXPECT_EQ(parse_text(text + "\nsphere { radius: 2 }").node_count, 1u) << text;
    }
}

TEST(Syntax, LoopsAndFunctionsAreLeftFromWithin) {
    EXPECT_EQ(parse_text("for a in b { if c { break } }").errors, "");
    EXPECT_EQ(parse_text("group { for a in b { if c { break } } }").errors, "");
    EXPECT_EQ(parse_text("for a in b { group { if c { break } } }").errors,
              "E0119 1:29 `break` outside a loop\n");
    EXPECT_EQ(parse_text("fn f() { while a { if b { return 1 } else { return 2 } } }").errors, "");
    EXPECT_EQ(parse_text("fn f() { for a in b { return [for c in a: c] } }").errors, "");
    EXPECT_EQ(parse_text("for a in b { component c() { break } }").errors,
              "E0119 1:30 `break` outside a loop\n");
    EXPECT_EQ(parse_text("for a in b { let c = group { continue } }").errors,
              "E0119 1:30 `continue` outside a loop\n");
    EXPECT_EQ(parse_text("fn f() { component c() { return 1 } }").errors,
              "E0119 1:26 `return` outside a function\n");
    EXPECT_EQ(parse_text("if a { return 1 }").errors, "E0119 1:8 `return` outside a function\n");
}

TEST(Syntax, ADefinitionThatIsNotUnderstoodKeepsItsName) {
    for (const char* text : {"fn f n = 1", "fn f(1) = 1", "component f { }", "def f(x) { }",
                             "let f: 1", "import f", "fn f()", "fn f(x => x"}) {
        const Parsed parsed = parse_text(text);
        EXPECT_EQ(parsed.tree, "(let f ?)") << text;
        EXPECT_EQ(parsed.error_count, 1u) << text << "\n" << parsed.errors;
    }
}

void expect_read_behind(const std::string& broken, const std::string& next) {
    const Parsed parsed = parse_text(broken + "\n" + next + "\n");
    EXPECT_EQ(parsed.error_count, 1u) << broken << "\n" << next << "\n" << parsed.errors;
    EXPECT_TRUE(parsed.tree.ends_with(tree_of(next))) << broken << "\n"
                                                      << next << "\n"
                                                      << parsed.tree;
}

TEST(Syntax, AKeywordBeginsAnewBehindAMistake) {
    for (const char* broken : {"fn f(a, (",
                               "fn f(a,",
                               "component c(a = [1, 2",
                               "if (a or",
                               "for a in f(b, c",
                               "while [1, 2",
                               "let a = [for b in c",
                               "let a = f(b,",
                               "import \"a.lrs\" as",
                               "param a = (1",
                               "let a = fn(b",
                               "for a",
                               "if",
                               "fn",
                               "component",
                               "while a and",
                               "for i, ",
                               "for i in",
                               "let a =",
                               "var a",
                               "a(",
                               "a: [1,"}) {
        for (const char* next :
             {"let q = 1", "var q = 1", "param q = 1", "fn q() = 1", "component q() { }",
              "import \"q.lrs\"", "include \"q.lrs\"", "for q in p { }", "while q { }"}) {
            expect_read_behind(broken, next);
        }
    }
}

TEST(Syntax, AnyItemBeginsAnewBehindAMistakeWithoutOpenBrackets) {
    for (const char* broken : {"fn", "fn f", "fn f()", "component c", "if", "for a", "for i, ",
                               "var a", "param a = 1 [0, 1]", "import", "break", "match a",
                               "fn f(a { }", "def f(x)", "return a"}) {
        for (const char* next : {"if q { }", "q { }", "q: 1", "q = 1", "q(1)", "let q = 1"}) {
            expect_read_behind(broken, next);
        }
    }
}

std::string repeated(std::string_view text, std::size_t count) {
    std::string result;
    for (std::size_t i = 0; i < count; ++i) result += text;
    return result;
}

struct NestingForm {
    const char* name;
    std::function<std::string(std::size_t)> make;
};

const std::vector<NestingForm> kNestingForms = {
    {"else if", [](std::size_t n) { return "if a { }" + repeated(" else if a { }", n); }},
    {"if", [](std::size_t n) { return repeated("if a {", n) + repeated("}", n); }},
    {"if without braces", [](std::size_t n) { return repeated("if a ", n); }},
    {"for", [](std::size_t n) { return repeated("for i in a {", n) + repeated("}", n); }},
    {"while", [](std::size_t n) { return repeated("while a {", n) + repeated("}", n); }},
    {"fn", [](std::size_t n) { return repeated("fn f() {", n) + repeated("}", n); }},
    {"component", [](std::size_t n) { return repeated("component c() {", n) + repeated("}", n); }},
    {"comprehension values",
     [](std::size_t n) { return "x = " + repeated("[for i in a: ", n) + "1" + repeated("]", n); }},
    {"comprehension lists",
     [](std::size_t n) { return "x = " + repeated("[for i in ", n) + "a" + repeated(": i]", n); }},
    {"function values", [](std::size_t n) { return "x = " + repeated("fn() = ", n) + "1"; }},
    {"defaults",
     [](std::size_t n) { return "x = " + repeated("fn(a = ", n) + "1" + repeated(") = a", n); }},
};

TEST(Syntax, NestingIsLimitedInEveryStatementAndFunction) {
    constexpr std::uint32_t kNesting = 40;
    for (const NestingForm& form : kNestingForms) {
        std::size_t last_fitting = 0;
        for (std::size_t n = 1; n <= 2 * kNesting; ++n) {
            const std::string errors = parse_text(form.make(n), kNesting).errors;
            const bool is_too_deep = errors.find("E0115") != errors.npos;
            if (is_too_deep) continue;
            EXPECT_EQ(last_fitting + 1, n) << form.name << ": once too deep, always too deep";
            last_fitting = n;
        }
        EXPECT_GE(last_fitting, kNesting / 4) << form.name;
        EXPECT_LE(last_fitting, kNesting) << form.name;
        const std::string errors = parse_text(form.make(100'000)).errors;
        EXPECT_NE(errors.find("E0115"), errors.npos) << form.name;
    }
}

TEST(Syntax, LongRunsWithoutNestingAreRead) {
    for (const char* piece :
         {"{ ",         "else ",     "if ",          "for ",      "fn ",     "fn (",   "[for ",
          "component ", "import ",   "while (",      "param ",    "return ", "break ", "elif ",
          "fn f() ",    "/// doc\n", "def f(x):\n ", "for i in ", "let a: ", "if x\n "}) {
        EXPECT_GE(parse_text(repeated(piece, 20'000) + "}").error_count, 1u) << piece;
    }
}

}  // namespace
}  // namespace lray::test
