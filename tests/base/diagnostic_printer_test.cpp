#include "base/diagnostic_printer.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <string_view>

namespace lray {
namespace {

/// Returns the span of the first `needle` in a source.
Span find(const Sources& sources, SourceId id, std::string_view needle) {
    const std::size_t begin = sources[id].text.view().find(needle);
    return Span::make(id, begin, begin + needle.size());
}

std::string print(const Diagnostics& diagnostics, const Sources& sources) {
    return format_diagnostics(diagnostics, sources, {});
}

TEST(DiagnosticPrinter, SpanHintAndIncludeChain) {
    Sources sources;
    const SourceId main = sources.add("main.lrs", Text("// main\ninclude \"flake.lrs\"\n"));
    const std::string text = std::string(11, '\n') + "  radios: 1\n}\n";
    const SourceId flake = sources.add("flake.lrs", Text(text), find(sources, main, "include"));
    Diagnostics diagnostics;
    diagnostics
        .error(Code::E0401, find(sources, flake, "radios"), "sphere has no property `radios`")
        .with_hint("did you mean `radius`?");
    EXPECT_EQ(print(diagnostics, sources),
              "flake.lrs:12:3: error[E0401]: sphere has no property `radios`\n"
              "   |\n"
              "12 |   radios: 1\n"
              "   |   ^^^^^^ did you mean `radius`?\n"
              "   = in flake.lrs, included from main.lrs:2:1\n"
              "\n");
}

TEST(DiagnosticPrinter, LongIncludeChainIsFoldedInTheMiddle) {
    Sources sources;
    Span from{};
    for (int i = 0; i < 8; ++i) {
        const SourceId id =
            sources.add(std::string(1, static_cast<char>('a' + i)) + ".lrs", Text("x"), from);
        from = Span::make(id, 0, 1);
    }
    Diagnostics diagnostics;
    diagnostics.error(Code::E0201, from, "unknown name `x`");
    EXPECT_EQ(print(diagnostics, sources),
              "h.lrs:1:1: error[E0201]: unknown name `x`\n"
              "  |\n"
              "1 | x\n"
              "  | ^\n"
              "  = in h.lrs, included from g.lrs:1:1, included from f.lrs:1:1, included from "
              "e.lrs:1:1, ... (3 more), included from a.lrs:1:1\n"
              "\n");
}

TEST(DiagnosticPrinter, CallsInnermostFirstThenTheIncludes) {
    Sources sources;
    const SourceId main = sources.add("main.lrs", Text("include \"a.lrs\"\n"));
    const SourceId part = sources.add("a.lrs", Text("x\ny\n"), find(sources, main, "include"));
    Diagnostics diagnostics;
    diagnostics.error(Code::E0503, find(sources, part, "x"), "division by zero")
        .with_call(find(sources, part, "y"), "flake")
        .with_call(Span{}, "tree\x1b");
    EXPECT_EQ(print(diagnostics, sources),
              "a.lrs:1:1: error[E0503]: division by zero\n"
              "  |\n"
              "1 | x\n"
              "  | ^\n"
              "  = in flake (a.lrs:2:1)\n"
              "  = in tree\\u{1b}\n"
              "  = in a.lrs, included from main.lrs:1:1\n"
              "\n");
}

TEST(DiagnosticPrinter, ManyCallsAreFoldedInTheMiddle) {
    Sources sources;
    const SourceId id = sources.add("a.lrs", Text("x"));
    const auto calls = [&](int count) {
        Diagnostics diagnostics;
        Diagnostic& diagnostic = diagnostics.error(Code::E0512, Span::make(id, 0, 1), "too many");
        for (int i = 0; i < count; ++i) diagnostic.with_call(Span{}, fmt::format("f{}", i));
        const std::string text = print(diagnostics, sources);
        return text.substr(text.find("  = "));
    };
    EXPECT_EQ(calls(7),
              "  = in f0\n  = in f1\n  = in f2\n  = in f3\n  = in f4\n  = in f5\n"
              "  = in f6\n\n");
    EXPECT_EQ(calls(8),
              "  = in f0\n  = in f1\n  = in f2\n  = ... 2 more calls ...\n  = in f5\n"
              "  = in f6\n  = in f7\n\n");
    EXPECT_EQ(calls(1000),
              "  = in f0\n  = in f1\n  = in f2\n  = ... 994 more calls ...\n"
              "  = in f997\n  = in f998\n  = in f999\n\n");
}

TEST(DiagnosticPrinter, LabelsOnTheSameLineOnOthersAndInOtherFiles) {
    Sources sources;
    const SourceId main =
        sources.add("main.lrs", Text("sphere { radius: 1, radius: 2 }\n\n\nlet a = b\n"));
    const SourceId other = sources.add("other.lrs", Text("let oak = 1\n"));
    Diagnostics diagnostics;
    const Span second = Span::make(main, 20, 26);
    diagnostics.error(Code::E0402, second, "`radius` is set twice")
        .with_hint("again here")
        .with_label(find(sources, main, "radius"), "first set here")
        .with_label(find(sources, main, "b\n"), "used here")
        .with_label(find(sources, other, "oak"), "defined here")
        .with_note("the last one does not win")
        .with_help("remove one of them");
    EXPECT_EQ(print(diagnostics, sources),
              "main.lrs:1:21: error[E0402]: `radius` is set twice\n"
              "  |\n"
              "1 | sphere { radius: 1, radius: 2 }\n"
              "  |          ------     ^^^^^^ again here\n"
              "  |          first set here\n"
              "...\n"
              "4 | let a = b\n"
              "  |         - used here\n"
              "  ::: other.lrs:1:5\n"
              "  |\n"
              "1 | let oak = 1\n"
              "  |     --- defined here\n"
              "  = note: the last one does not win\n"
              "  = help: remove one of them\n"
              "\n");
}

TEST(DiagnosticPrinter, ThreeMarksOnALineKeepTheirTextsApart) {
    Sources sources;
    const SourceId id = sources.add("a.lrs", Text("a = b + c"));
    Diagnostics diagnostics;
    diagnostics.error(Code::E0302, find(sources, id, "+"), "cannot add 3 and 2 elements")
        .with_label(find(sources, id, "b"), "this has 3")
        .with_label(find(sources, id, "c"), "this has 2")
        .with_hint("here");
    EXPECT_EQ(print(diagnostics, sources),
              "a.lrs:1:7: error[E0302]: cannot add 3 and 2 elements\n"
              "  |\n"
              "1 | a = b + c\n"
              "  |     - ^ - this has 2\n"
              "  |     | here\n"
              "  |     this has 3\n"
              "\n");
}

TEST(DiagnosticPrinter, NestedMarksShowCaretsOverDashes) {
    Sources sources;
    const SourceId id = sources.add("a.lrs", Text("box { scale: [1, 0, 1] }"));
    Diagnostics diagnostics;
    diagnostics.error(Code::E0310, find(sources, id, "0"), "a scale of 0 cannot be inverted")
        .with_label(find(sources, id, "[1, 0, 1]"), "this scale");
    EXPECT_EQ(print(diagnostics, sources),
              "a.lrs:1:18: error[E0310]: a scale of 0 cannot be inverted\n"
              "  |\n"
              "1 | box { scale: [1, 0, 1] }\n"
              "  |              ----^---- this scale\n"
              "\n");
}

TEST(DiagnosticPrinter, SpanOverLinesShowsFirstAndLast) {
    Sources sources;
    const SourceId id =
        sources.add("a.lrs", Text("group {\n  sphere {\n    a: 1\n    b: 2\n  }\n}\n"));
    Diagnostics diagnostics;
    diagnostics
        .error(Code::E0412, find(sources, id, "sphere {\n    a: 1\n    b: 2\n  }"), "no child here")
        .with_hint("this block");
    EXPECT_EQ(print(diagnostics, sources),
              "a.lrs:2:3: error[E0412]: no child here\n"
              "  |\n"
              "2 |   sphere {\n"
              "  |   ^^^^^^^^\n"
              "...\n"
              "5 |   }\n"
              "  |   ^ this block\n"
              "\n");
}

TEST(DiagnosticPrinter, LineEndBelongsToItsLineAndTheEndOfFileHasACaret) {
    Sources sources;
    const SourceId id = sources.add("a.lrs", Text("let a =\r\nx {"));
    Diagnostics diagnostics;
    diagnostics.error(Code::E0109, find(sources, id, "\r\n"), "a value is missing");
    diagnostics.error(Code::E0103, Span::make(id, 12, 12), "never closed");
    EXPECT_EQ(print(diagnostics, sources),
              "a.lrs:1:8: error[E0109]: a value is missing\n"
              "  |\n"
              "1 | let a =\n"
              "  |        ^\n"
              "\n"
              "a.lrs:2:4: error[E0103]: never closed\n"
              "  |\n"
              "2 | x {\n"
              "  |    ^\n"
              "\n");
}

TEST(DiagnosticPrinter, CaretsFollowTheDisplayWidth) {
    Sources sources;
    // A tab, a combining accent, a wide character, an escape character; then the mark.
    const SourceId id =
        sources.add("a.lrs", Text("\te\xcc\x81\xe4\xb8\xad\x1b[1mwrong\xe4\xb8\xad \xff"));
    Diagnostics diagnostics;
    diagnostics.error(Code::E0001, find(sources, id, "wrong\xe4\xb8\xad"), "unexpected");
    diagnostics.error(Code::E0002, find(sources, id, "\xff"), "not UTF-8");
    EXPECT_EQ(print(diagnostics, sources),
              "a.lrs:1:9: error[E0001]: unexpected\n"
              "  |\n"
              "1 |     e\xcc\x81\xe4\xb8\xad\\u{1b}[1mwrong\xe4\xb8\xad \\xff\n"
              "  |                 ^^^^^^^\n"
              "\n"
              "a.lrs:1:16: error[E0002]: not UTF-8\n"
              "  |\n"
              "1 |     e\xcc\x81\xe4\xb8\xad\\u{1b}[1mwrong\xe4\xb8\xad \\xff\n"
              "  |                         ^^^^\n"
              "\n");
}

TEST(DiagnosticPrinter, LongLineIsCutAroundTheSpan) {
    Sources sources;
    const std::string text = std::string(500, 'a') + "WRONG" + std::string(500, 'b');
    const SourceId id = sources.add("a.lrs", Text(text));
    Diagnostics diagnostics;
    diagnostics.error(Code::E0201, find(sources, id, "WRONG"), "unknown name").with_hint("here");
    EXPECT_EQ(print(diagnostics, sources),
              "a.lrs:1:501: error[E0201]: unknown name\n"
              "  |\n"
              "1 | ..." +
                  std::string(30, 'a') + "WRONG" + std::string(59, 'b') +
                  "...\n"
                  "  | " +
                  std::string(33, ' ') +
                  "^^^^^ here\n"
                  "\n");
}

TEST(DiagnosticPrinter, LineJustTooLongIsCutAtItsEnd) {
    Sources sources;
    const SourceId fits = sources.add("a.lrs", Text(std::string(100, 'a')));
    const SourceId long_line = sources.add("b.lrs", Text(std::string(101, 'b')));
    Diagnostics diagnostics;
    diagnostics.error(Code::E0201, Span::make(fits, 0, 100), "x");
    diagnostics.error(Code::E0201, Span::make(long_line, 0, 101), "y");
    EXPECT_EQ(print(diagnostics, sources),
              "a.lrs:1:1: error[E0201]: x\n  |\n1 | " + std::string(100, 'a') + "\n  | " +
                  std::string(100, '^') + "\n\nb.lrs:1:1: error[E0201]: y\n  |\n1 | " +
                  std::string(97, 'b') + "...\n  | " + std::string(97, '^') + "\n\n");
}

TEST(DiagnosticPrinter, LabelInThePartCutOffStandsAtTheDots) {
    Sources sources;
    const std::string text = "first " + std::string(300, ' ') + "second";
    const SourceId id = sources.add("a.lrs", Text(text));
    Diagnostics diagnostics;
    diagnostics.error(Code::E0402, find(sources, id, "second"), "set twice")
        .with_label(find(sources, id, "first"), "first set here");
    EXPECT_EQ(print(diagnostics, sources),
              "a.lrs:1:307: error[E0402]: set twice\n"
              "  |\n"
              "1 | ..." +
                  std::string(30, ' ') +
                  "second\n"
                  "  | -" +
                  std::string(32, ' ') +
                  "^^^^^^\n"
                  "  | first set here\n"
                  "\n");
}

TEST(DiagnosticPrinter, NowhereIsSaidByTheProgram) {
    const Sources sources;
    Diagnostics diagnostics;
    diagnostics.error(Code::E0601, {}, "`a.lrs` was not found")
        .with_hint("is it `b.lrs`?")
        .with_label({}, "named on the command line")
        .with_help("look again");
    EXPECT_EQ(print(diagnostics, sources),
              "lray: error[E0601]: `a.lrs` was not found\n"
              "  = is it `b.lrs`?\n"
              "  = named on the command line\n"
              "  = help: look again\n"
              "\n");
}

TEST(DiagnosticPrinter, SourceWithoutTextIsPrintedWithoutExcerpt) {
    Sources sources;
    const SourceId id = sources.add("a.obj", Text("v 0 0 0\nf 1 2 3\n"));
    const SourceId empty = sources.add("b.lrs", Text(""));
    const Span span = find(sources, id, "f 1");
    sources.release_text(id);
    Diagnostics diagnostics;
    diagnostics.warning(Code::W1702, span, "3 faces left out");
    diagnostics.warning(Code::W1503, Span::make(empty, 0, 0), "the scene is empty")
        .with_label(span, "see here");
    EXPECT_EQ(print(diagnostics, sources),
              "a.obj: warning[W1702]: 3 faces left out\n"
              "\n"
              "b.lrs:1:1: warning[W1503]: the scene is empty\n"
              "  = see here: a.obj\n"
              "\n");
}

TEST(DiagnosticPrinter, RepetitionIsCounted) {
    Sources sources;
    const SourceId id = sources.add("a.lrs", Text("1 / n"));
    Diagnostics diagnostics;
    for (int i = 0; i < 37; ++i) {
        diagnostics.error(Code::E0503, find(sources, id, "/"), "division by zero");
    }
    EXPECT_EQ(print(diagnostics, sources),
              "a.lrs:1:3: error[E0503]: division by zero (occurred 37 times)\n"
              "  |\n"
              "1 | 1 / n\n"
              "  |   ^\n"
              "\n");
}

TEST(DiagnosticPrinter, NoControlCharacterGetsThrough) {
    Sources sources;
    const SourceId id = sources.add("a\x1b.lrs", Text("x\x1b\x07\r\x7f\n"));
    Diagnostics diagnostics;
    diagnostics.error(Code::E0001, find(sources, id, "\x1b"), "m\x1b\n")
        .with_hint("h\x1b\n")
        .with_label(find(sources, id, "x"), "l\x1b\n")
        .with_label({}, "n\x1b\n")
        .with_note("o\x1b\n")
        .with_help("p\x1b\n");
    const std::string text = print(diagnostics, sources);
    for (const char c : text) EXPECT_TRUE(c == '\n' || (c >= ' ' && c != '\x7f'));
    for (const char c : {'m', 'h', 'l', 'n', 'o', 'p'}) {
        EXPECT_NE(text.find(std::string(1, c) + "\\u{1b}\\n"), std::string::npos) << c;
    }
}

TEST(DiagnosticPrinter, HugeNamesAndLinesWithoutWidthAreCut) {
    Sources sources;
    std::string marks = "e";
    for (int i = 0; i < 100'000; ++i) marks += "\xcc\x81";
    const SourceId id = sources.add("a.lrs", Text(marks));
    Diagnostics diagnostics;
    diagnostics.error(Code::E0201, Span::make(id, 100'001, 100'003), std::string(100'000, 'x'))
        .with_hint(std::string(100'000, 'y'));
    EXPECT_LT(print(diagnostics, sources).size(), 6000u);
}

TEST(DiagnosticPrinter, AnySpansInAnyBytesPrintWithoutControls) {
    constexpr std::uint32_t kSeed = 5;
    std::mt19937 random(kSeed);
    constexpr std::string_view kBytes = "ab \t\r\n\x1b\xcc\x81\xe4\xb8\xad\xff";
    for (int i = 0; i < 3000; ++i) {
        std::string text(1 + random() % (i % 10 == 0 ? 3000 : 40), ' ');
        for (char& c : text) c = kBytes[random() % kBytes.size()];
        Sources sources;
        const SourceId id = sources.add("a.lrs", Text(text));
        const auto span = [&] {
            const std::size_t begin = random() % (text.size() + 1);
            return Span::make(id, begin, begin + random() % (text.size() + 1 - begin));
        };
        Diagnostics diagnostics;
        diagnostics.error(Code::E0001, span(), "m")
            .with_hint("hint")
            .with_label(span(), "first label")
            .with_label(span(), "second label");
        const std::string printed = print(diagnostics, sources);
        for (const char c : printed) {
            ASSERT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= ' ') << i << ": " << printed;
        }
        for (const char* part : {"^", "hint", "first label", "second label"}) {
            ASSERT_NE(printed.find(part), std::string::npos) << i << ": " << printed;
        }
    }
}

TEST(DiagnosticPrinter, ColoursOnlyIfAskedForAndThenTheSameText) {
    Sources sources;
    const SourceId id = sources.add("a.lrs", Text("sphere { radios: 1 }"));
    Diagnostics diagnostics;
    diagnostics.error(Code::E0401, find(sources, id, "radios"), "no `radios`").with_hint("radius?");
    diagnostics.warning(Code::W1503, find(sources, id, "sphere"), "nothing")
        .with_label(find(sources, id, "radios"), "this")
        .with_note("note");
    const std::string plain = print(diagnostics, sources);
    std::string colored = format_diagnostics(diagnostics, sources, {true, 20});
    EXPECT_EQ(plain.find('\x1b'), std::string::npos);
    EXPECT_NE(colored.find("\x1b[1;31m^^^^^^\x1b[0m \x1b[1;31mradius?\x1b[0m"), std::string::npos);
    EXPECT_NE(colored.find("\x1b[1;33mwarning[W1503]:\x1b[0m"), std::string::npos);
    for (std::size_t i; (i = colored.find('\x1b')) != std::string::npos;) {
        colored.erase(i, colored.find('m', i) - i + 1);
    }
    EXPECT_EQ(colored, plain);
}

Diagnostics many(SourceId id, std::size_t error_count, std::size_t warning_count) {
    Diagnostics diagnostics;
    for (std::size_t i = 0; i < warning_count; ++i) {
        diagnostics.warning(Code::W1404, Span::make(id, i, i), "w");
    }
    for (std::size_t i = 0; i < error_count; ++i) {
        diagnostics.error(Code::E0201, Span::make(id, i, i), "e");
    }
    return diagnostics;
}

std::size_t count(std::string_view text, std::string_view needle) {
    std::size_t result = 0;
    for (std::size_t i = text.find(needle); i != std::string_view::npos;
         i = text.find(needle, i + 1)) {
        ++result;
    }
    return result;
}

TEST(DiagnosticPrinter, TwentyErrorsByDefaultThenACount) {
    Sources sources;
    const SourceId id = sources.add("a.lrs", Text(std::string(100, ' ')));
    const std::string text = print(many(id, 57, 0), sources);
    EXPECT_EQ(count(text, "error[E0201]"), 20u);
    EXPECT_TRUE(text.ends_with("\n\n... and 37 more (`--max-errors 0` shows all)\n"));
    EXPECT_EQ(count(print(many(id, 20, 0), sources), "more"), 0u);
}

TEST(DiagnosticPrinter, WarningsDoNotCrowdOutErrors) {
    Sources sources;
    const SourceId id = sources.add("a.lrs", Text(std::string(100, ' ')));
    const std::string text = format_diagnostics(many(id, 5, 50), sources, {false, 3});
    EXPECT_EQ(count(text, "error[E0201]"), 3u);
    EXPECT_EQ(count(text, "warning[W1404]"), 3u);
    EXPECT_TRUE(text.ends_with("... and 49 more (`--max-errors 0` shows all)\n"));
}

TEST(DiagnosticPrinter, ZeroShowsAllThatAreKept) {
    Sources sources;
    const SourceId id = sources.add("a.lrs", Text(std::string(20'000, '\n')));
    const std::string all = format_diagnostics(many(id, 57, 0), sources, {false, 0});
    EXPECT_EQ(count(all, "error[E0201]"), 57u);
    EXPECT_EQ(count(all, "more"), 0u);
    const std::string kept =
        format_diagnostics(many(id, Diagnostics::kMaxKept + 3, 0), sources, {false, 0});
    EXPECT_TRUE(kept.ends_with("\n\n... and 3 more\n"));
}

TEST(Summary, CountsInWords) {
    EXPECT_EQ(summary({}), "");
    EXPECT_EQ(summary(many(0, 1, 0)), "1 error");
    EXPECT_EQ(summary(many(0, 0, 2)), "2 warnings");
    EXPECT_EQ(summary(many(0, 2, 1)), "2 errors, 1 warning");
}

}  // namespace
}  // namespace lray
