#include "tests/parser/formatted.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "parser/symbols.h"
#include "parser/syntax/lexer.h"
#include "parser/tools/format.h"

namespace lray::test {

namespace {

using parser::Token;
using parser::TokenKind;

/// What a text is made of, one piece a line, in a form that formatting does not change.
struct Essence {
    std::vector<std::string> tokens{};    // without separators
    std::vector<std::string> comments{};  // without blanks at their ends
};

/// The comments between two tokens, found by other means than the formatter's.
void add_comments(std::string_view gap, std::vector<std::string>& comments) {
    while (!gap.empty()) {
        std::size_t size = 1;
        if (gap.starts_with("//")) {
            size = std::min(gap.find_first_of("\r\n"), gap.size());
        } else if (gap.starts_with("/*")) {
            int depth = 1;
            for (size = 2; depth > 0 && size < gap.size(); ++size) {
                const std::string_view mark = gap.substr(size, 2);
                depth += mark == "/*" ? 1 : mark == "*/" ? -1 : 0;
                if (mark == "/*" || mark == "*/") ++size;
            }
        }
        if (size > 1) {
            std::string comment;
            for (const char c : gap.substr(0, size)) {
                if (c == '\n' && comment.ends_with('\n')) continue;
                comment += c == '\r' ? '\n' : c;
            }
            comment.erase(comment.find_last_not_of(" \t") + 1);
            comments.push_back(comment);
        }
        gap.remove_prefix(size);
    }
}

Essence essence_of(std::string_view text) {
    Sources sources;
    Diagnostics diagnostics;
    parser::Symbols symbols;
    const SourceId source = sources.add("text", Text(text));
    parser::Lexer lexer(sources, source, symbols, diagnostics);
    Essence essence;
    std::uint32_t previous_end = 0;
    for (;;) {
        const Token token = lexer.next();
        add_comments(text.substr(previous_end, token.offset - previous_end), essence.comments);
        previous_end = token.end();
        if (token.kind == TokenKind::end) break;
        if (token.kind == TokenKind::comma || token.kind == TokenKind::semicolon) continue;
        std::string spelled(text.substr(token.offset, token.length));
        if (token.kind == TokenKind::number) {
            spelled = fmt::format("{:a} {}", token.number, token.has_unit);
        } else if (token.kind == TokenKind::color) {
            std::transform(spelled.begin(), spelled.end(), spelled.begin(), ::tolower);
        }
        essence.tokens.push_back(fmt::format("{} {}", static_cast<int>(token.kind), spelled));
    }
    EXPECT_FALSE(diagnostics.has_errors()) << text;
    return essence;
}

}  // namespace

Formatted::Formatted(std::string_view original, const parser::LoadLimits& limits) {
    Sources sources;
    Diagnostics diagnostics;
    const SourceId source = sources.add("text", Text(original));
    text = parser::format(source, sources, limits, diagnostics);
    for (const Diagnostic* diagnostic : diagnostics.sorted()) {
        codes += fmt::format("{}{}", codes.empty() ? "" : " ", code_info(diagnostic->code).id);
    }
    EXPECT_EQ(text.has_value(), !diagnostics.has_errors()) << original;
}

void expect_format(std::string_view original, std::string_view wanted) {
    EXPECT_EQ(Formatted(original).text, wanted) << "of:\n" << original;
    expect_stable(original);
}

void expect_stable(std::string_view original) {
    const Formatted once(original);
    ASSERT_TRUE(once.text) << once.codes << "\n" << original;
    const Essence before = essence_of(original);
    const Essence after = essence_of(*once.text);
    ASSERT_EQ(before.tokens, after.tokens) << original << "\nformatted:\n" << *once.text;
    ASSERT_EQ(before.comments, after.comments) << original << "\nformatted:\n" << *once.text;
    ASSERT_EQ(Formatted(*once.text).text, once.text) << "of:\n" << original;
    if (once.text->find("/*") != std::string::npos) return;  // lines of comments are as they are
    for (const char* const forbidden : {"\r", "\t", " \n", "\n\n\n", "{\n\n", "\n\n}"}) {
        const bool may_hold_tabs =  // strings and comments stay as they are
            original.find('"') != original.npos || original.find("//") != original.npos;
        if (may_hold_tabs && *forbidden == '\t') continue;
        ASSERT_EQ(once.text->find(forbidden), std::string::npos) << *once.text;
    }
}

std::string sorted_codes(const Loaded& loaded) {
    std::vector<std::string_view> codes;
    for (const Diagnostic* diagnostic : loaded.diagnostics.sorted()) {
        codes.insert(codes.end(), diagnostic->count, code_info(diagnostic->code).id);
    }
    std::sort(codes.begin(), codes.end());
    return fmt::format("{}", fmt::join(codes, " "));
}

}  // namespace lray::test
