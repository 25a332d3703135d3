#include "scene/formats/nff_mistakes.h"

#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/did_you_mean.h"
#include "base/suggest_name.h"
#include "scene/formats/nff_scanner.h"
#include "scene/formats/token_words.h"

namespace lray::scene::nff {

namespace {

constexpr std::string_view kStatements =
    "an NFF file has `v`, `b`, `l`, `f`, `s`, `c`, `p` and `pp`, and comments behind `#`";

/// What elsewhere is called so is this in NFF; empty for other words.
std::string_view habit(std::string_view word) {
    struct Habit {
        std::string_view word;
        std::string_view keyword;
    };
    constexpr std::array<Habit, 20> kHabits = {{
        {"background", "b"}, {"ball", "s"},     {"camera", "v"},   {"color", "f"},
        {"cone", "c"},       {"cyl", "c"},      {"cylinder", "c"}, {"fill", "f"},
        {"light", "l"},      {"lookat", "at"},  {"material", "f"}, {"patch", "pp"},
        {"poly", "p"},       {"polygon", "p"},  {"sphere", "s"},   {"surface", "f"},
        {"tri", "p"},        {"triangle", "p"}, {"view", "v"},     {"viewpoint", "v"},
    }};
    for (const Habit& known : kHabits) {
        if (edit_distance(known.word, word, 0) == 0) return known.keyword;
    }
    return {};
}

}  // namespace

void Mistakes::wrong_number(const char* begin) {
    const std::string_view token = token_at(begin);
    tell(Code::E0706, span(begin, begin + token.size()), wrong_number_text(token));
}

void Mistakes::too_few_numbers(Span statement, std::string_view needs, std::size_t found) {
    tell(Code::E0706, statement, fmt::format("{}, this has {}", needs, found));
}

void Mistakes::stray_number(const char* begin, std::string_view needs) {
    const std::string_view token = token_at(begin);
    const Span place = span(begin, begin + token.size());
    if (needs.empty()) {
        tell(Code::E0706, place, fmt::format("expected a statement, found {}", quoted_token(token)))
            .with_help(std::string(kStatements));
    } else {
        tell(Code::E0706, place, fmt::format("{}; this is one more", needs));
    }
}

void Mistakes::unknown_word(const char* begin, bool is_in_view) {
    const std::string_view token = token_at(begin);
    const Span place = span(begin, begin + token.size());
    if (token.starts_with("//") || token.starts_with("/*") || token.starts_with(';')) {
        tell(Code::E0706, place, "comments start with `#`");
        return;
    }
    Diagnostic& diagnostic =
        tell(Code::E0706, place, fmt::format("NFF has no {}", quoted_token(token)));
    std::vector<std::string_view> names(kKeywords.begin(), kKeywords.end());
    if (is_in_view) names.insert(names.end(), kViewWords.begin(), kViewWords.end());
    if (const std::string_view keyword = habit(token); !keyword.empty()) {
        diagnostic.with_hint(fmt::format("here it is called `{}`", keyword));
    } else if (!suggest_name(diagnostic, token, names)) {
        diagnostic.with_help(std::string(kStatements));
    }
}

void Mistakes::value(Code code, Span span, std::string message, std::string help) {
    Diagnostic& diagnostic = tell(code, span, std::move(message));
    if (!help.empty()) diagnostic.with_help(std::move(help));
}

void Mistakes::second(Span span, std::string_view keyword, std::string_view of_what, Span first) {
    tell(Code::E0405, span, fmt::format("a second `{}`: a file has one {}", keyword, of_what))
        .with_label(first, "the first one is here");
}

void Mistakes::binary(const char* at) {
    if (is_utf16(text_.data())) {
        tell(Code::E0003, span(text_.data(), text_.data() + 2),
             "this file is UTF-16; save it as UTF-8");
    } else {
        tell(Code::E0003, span(at, at + 1),
             "this is not NFF text but a binary file: here is a NUL byte");
    }
}

void Mistakes::other_format(const char* begin) {
    tell(Code::E0705, span(begin, skip_token(begin)),
         "this is an NFF file of WorldToolKit; read is the Neutral File Format of Haines")
        .with_help("the two have nothing in common but the ending of their names");
}

void Mistakes::too_many_nodes(Span span, std::uint64_t limit) {
    tell(Code::E0513, span, fmt::format("the scene has more than {} nodes", limit))
        .with_help("raise the limit with `--max-nodes N`");
}

void Mistakes::too_many_bytes(Span span, std::uint64_t limit) {
    tell(Code::E0516, span,
         fmt::format("the surfaces and lights of this scene need more than {} bytes", limit))
        .with_help("raise the limit with `--max-value-bytes N`");
}

Diagnostic& Mistakes::tell(Code code, Span span, std::string message) {
    ++count_;
    Diagnostic& diagnostic = diagnostics_.error(code, span, std::move(message));
    if (is_enough()) {
        diagnostic.with_note(
            fmt::format("after {} errors the rest of this file is not read", kMaxTold));
    }
    return diagnostic;
}

}  // namespace lray::scene::nff
