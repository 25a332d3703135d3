// Diagnostics with everything that one may carry, for the tests of forms for machines.
#pragma once

#include <string_view>

#include "base/diagnostics.h"
#include "base/source.h"

namespace lray::test {

/// Span of the first `needle` in a source.
inline Span span_of(const Sources& sources, SourceId id, std::string_view needle) {
    const std::size_t begin = sources[id].text.view().find(needle);
    return Span::make(id, begin, begin + needle.size());
}

/// A main file, one it includes from a directory with a space, and four diagnostics: an error with
/// label, calls and fix in the included file; a warning; one that occurred often; one of nowhere.
struct RichDiagnostics {
    Sources sources{};
    Diagnostics diagnostics{};
    SourceId main =
        sources.add("main.lrs", Text("// \xc3\xa4\ninclude \"my parts/a.lrs\"\nbox { }\n"));
    SourceId part = sources.add(
        "my parts/a.lrs", Text("let \xc3\xa4 = 1\n/* \xe2\x82\xac */ sphere { radios: 1,\n  x }\n"),
        span_of(sources, main, "\"my parts/a.lrs\""));

    RichDiagnostics() {
        diagnostics
            .error(Code::E0401, span_of(sources, part, "radios"), "sphere has no property `radios`")
            .with_hint("did you mean `radius`?")
            .with_label(span_of(sources, part, "sphere"), "of this")
            .with_label(Span{}, "of nothing")
            .with_note("a note")
            .with_help("a help")
            .with_call(span_of(sources, main, "box"), "flake")
            .with_call(Span{}, "tree")
            .with_fix(span_of(sources, part, "radios"), "radius");
        for (int i = 0; i < 3; ++i) {
            diagnostics.error(Code::E0503, span_of(sources, part, "1,\n  x"), "division by zero");
        }
        diagnostics.warning(Code::W1301, span_of(sources, main, "box"), "scale after \"move\"\x1b");
        diagnostics.error(Code::E0601, Span{}, "`none.lrs` not found");
    }
};

}  // namespace lray::test
