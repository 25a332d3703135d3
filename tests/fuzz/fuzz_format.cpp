// Fuzzes the formatter: what it writes is what it would write of that again, and says the same.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/assert.h"
#include "base/diagnostics.h"
#include "base/source.h"
#include "parser/arena.h"
#include "parser/symbols.h"
#include "parser/syntax/lexer.h"
#include "parser/syntax/parser.h"
#include "parser/tools/format.h"
#include "scene/scene.h"
#include "tests/fuzz/small_limits.h"

namespace {

using namespace lray;

std::optional<std::string> formatted(std::string_view text) {
    Sources sources;
    Diagnostics diagnostics;
    const SourceId source = sources.add("fuzz.lrs", Text(text));
    std::optional<std::string> result =
        parser::format(source, sources, fuzz::kSmallLimits, diagnostics);
    LRAY_ASSERT(result.has_value() == !diagnostics.has_errors());
    return result;
}

/// The tokens without separators and what stands between them without blanks: the comments.
std::string essence(std::string_view text) {
    using parser::TokenKind;
    Sources sources;
    Diagnostics diagnostics;
    parser::Symbols symbols;
    const SourceId source = sources.add("fuzz.lrs", Text(text));
    parser::Lexer lexer(sources, source, symbols, diagnostics);
    std::string essence;
    std::size_t previous_end = text.starts_with("\xef\xbb\xbf") ? 3 : 0;
    while (true) {
        const parser::Token token = lexer.next();
        for (const char c : text.substr(previous_end, token.offset - previous_end)) {
            if (c != ' ' && c != '\t' && c != '\n' && c != '\r') essence += c;
        }
        previous_end = token.end();
        if (token.kind == TokenKind::end) break;
        if (token.kind == TokenKind::comma || token.kind == TokenKind::semicolon) continue;
        std::string_view spelled = text.substr(token.offset, token.length);
        essence += '\n';
        if (token.kind == TokenKind::number) {
            essence += fmt::format("{:x}{}", std::bit_cast<std::uint64_t>(token.number),
                                   token.has_unit ? "u" : "");
        } else if (token.kind == TokenKind::color) {
            for (const char c : spelled) {
                essence += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
            }
        } else {
            essence += spelled;
        }
        essence += '\n';
    }
    LRAY_ASSERT(!diagnostics.has_errors());
    return essence;
}

bool has_syntax_errors(std::string_view text) {
    Sources sources;
    Diagnostics diagnostics;
    parser::Symbols symbols;
    parser::Arena arena;
    scene::Scene scene;
    std::vector<parser::OwnedNumbers> long_lists;
    const SourceId source = sources.add("fuzz.lrs", Text(text));
    parser::ParseContext context{sources, symbols, arena, scene, long_lists, 256, false};
    parser::parse(source, context, diagnostics);
    return diagnostics.has_errors();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const std::optional<std::string> once = formatted(text);
    if (!once) return 0;
    LRAY_ASSERT(formatted(*once) == once);
    LRAY_ASSERT(essence(text) == essence(*once));
    LRAY_ASSERT(has_syntax_errors(text) == has_syntax_errors(*once));
    return 0;
}
