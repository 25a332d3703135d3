#include "base/source.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace lray {
namespace {

SourceId add(Sources& sources, std::string_view text) {
    return sources.add("a.lrs", Text(text));
}

Span at(SourceId id, std::size_t offset) {
    return Span::make(id, offset, offset);
}

void expect_position(const Sources& sources, Span span, std::uint32_t line, std::uint32_t column) {
    const Position position = sources.position(span);
    EXPECT_EQ(position.line, line) << "offset " << span.offset;
    EXPECT_EQ(position.column, column) << "offset " << span.offset;
}

TEST(Text, IsFollowedByNulBytes) {
    Text text("abc");
    for (std::size_t i = 0; i < Text::kPadding; ++i) EXPECT_EQ(text.data()[3 + i], '\0');
    text.truncate(1);
    EXPECT_EQ(text.view(), "a");
    for (std::size_t i = 0; i < Text::kPadding; ++i) EXPECT_EQ(text.data()[1 + i], '\0');
}

TEST(Text, MovedFromIsEmpty) {
    Text text("abc");
    const Text other = std::move(text);
    EXPECT_EQ(other.view(), "abc");
    EXPECT_EQ(text.size(), 0u);  // NOLINT(bugprone-use-after-move): that is what is tested
}

TEST(Span, LengthSaturatesAndBeginIsExact) {
    const Span span = Span::make(1, 70'000, 200'000);
    EXPECT_EQ(span.offset, 70'000u);
    EXPECT_EQ(span.length, 0xffff);
    EXPECT_EQ(join(Span::make(1, 3, 5), Span::make(1, 9, 12)), Span::make(1, 3, 12));
    EXPECT_TRUE(Span{}.is_nowhere());
}

TEST(Sources, AnyLineEndEndsALine) {
    Sources sources;
    const SourceId id = add(sources, "a\nb\r\nc\rd\r\r\ne");
    EXPECT_EQ(sources.line_count(id), 6u);
    EXPECT_EQ(sources.line(id, 1), "a");
    EXPECT_EQ(sources.line(id, 2), "b");
    EXPECT_EQ(sources.line(id, 3), "c");
    EXPECT_EQ(sources.line(id, 4), "d");
    EXPECT_EQ(sources.line(id, 5), "");
    EXPECT_EQ(sources.line(id, 6), "e");
    expect_position(sources, at(id, 2), 2, 1);
    expect_position(sources, at(id, 5), 3, 1);
    expect_position(sources, at(id, 7), 4, 1);
    expect_position(sources, at(id, 11), 6, 1);
}

TEST(Sources, ColumnsCountCodePoints) {
    Sources sources;
    const SourceId id = add(sources, "\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80x\n\ty");
    expect_position(sources, at(id, 2), 1, 2);
    expect_position(sources, at(id, 5), 1, 3);
    expect_position(sources, at(id, 9), 1, 4);
    expect_position(sources, at(id, 12), 2, 2);  // a tab is one column
}

TEST(Sources, ByteOrderMarkIsNoColumnAndNoText) {
    Sources sources;
    const SourceId id = add(sources, "\xEF\xBB\xBFsphere { }\nx");
    expect_position(sources, at(id, 0), 1, 1);
    expect_position(sources, at(id, 3), 1, 1);
    expect_position(sources, at(id, 4), 1, 2);
    expect_position(sources, at(id, 14), 2, 1);
    EXPECT_EQ(sources.line(id, 1), "sphere { }");
}

TEST(Sources, ColumnsGoOnOverTheBlocksOfALongLine) {
    // Against a count from the begin, at and around the borders of the blocks of the table.
    std::string text = "\xEF\xBB\xBF";
    for (int i = 0; i < 5000; ++i) text += i % 3 == 0 ? "\xc3\xa4" : "x";
    text += "\r\n";
    for (int i = 0; i < 9000; ++i) text += i == 4000 ? "\r" : "\xe2\x82\xac";
    Sources sources;
    const SourceId id = add(sources, text);
    std::uint32_t line = 1;
    std::uint32_t column = 1;
    for (std::uint32_t i = 3; i < text.size(); ++i) {
        const bool is_lead = (static_cast<unsigned char>(text[i]) & 0xC0u) != 0x80u;
        if (is_lead) {
            const Position position = sources.position(at(id, i));
            ASSERT_EQ(position.line, line) << i;
            ASSERT_EQ(position.column, column) << i;
            ++column;
        }
        if (text[i] == '\n' || (text[i] == '\r' && text[i + 1] != '\n')) {
            ++line;
            column = 1;
        }
    }
    EXPECT_EQ(line, 3u);
}

TEST(Sources, EmptyFileHasOneEmptyLine) {
    Sources sources;
    const SourceId id = add(sources, "");
    EXPECT_EQ(sources.line_count(id), 1u);
    EXPECT_EQ(sources.line(id, 1), "");
    expect_position(sources, at(id, 0), 1, 1);
}

TEST(Sources, EndOfFileIsBehindTheLastCharacterOrOnANewLine) {
    Sources sources;
    const SourceId open = add(sources, "a\nbc");
    expect_position(sources, at(open, 4), 2, 3);
    const SourceId ended = add(sources, "a\nbc\n");
    EXPECT_EQ(sources.line_count(ended), 3u);
    EXPECT_EQ(sources.line(ended, 3), "");
    expect_position(sources, at(ended, 5), 3, 1);
    expect_position(sources, at(ended, 99), 3, 1);  // past the end: the end
}

TEST(Sources, LinesAndPositionsAgreeAcrossTheBlocksOfTheTable) {
    // Line ends around the blocks of the table, and lines longer than several.
    std::string text;
    for (std::size_t i = 0; text.size() < 50'000; ++i) {
        text += std::string((i * 37) % 90, 'x') + (i % 3 == 0 ? "\n" : i % 3 == 1 ? "\r\n" : "\r");
        if (i % 50 == 49) text += std::string(4095, 'y') + "\r\n";
    }
    Sources sources;
    const SourceId id = add(sources, text);
    std::uint32_t line = 1;
    std::uint32_t column = 1;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const Position position = sources.position(at(id, i));
        ASSERT_EQ(position.line, line) << i;
        ASSERT_EQ(position.column, column) << i;
        ++column;
        if (text[i] == '\n' || (text[i] == '\r' && text[i + 1] != '\n')) {
            const std::string_view expected = std::string_view(text).substr(begin, i - begin);
            ASSERT_EQ(sources.line(id, line), expected.substr(0, expected.find('\r')));
            ++line;
            column = 1;
            begin = i + 1;
        }
    }
    EXPECT_EQ(sources.line_count(id), line);
}

TEST(Sources, TextOfASpan) {
    Sources sources;
    const SourceId id = add(sources, "sphere { }");
    EXPECT_EQ(sources.text(Span::make(id, 0, 6)), "sphere");
    EXPECT_EQ(sources.text(Span::make(id, 9, 99)), "}");
    EXPECT_EQ(sources.text(Span::make(id, 99, 100)), "");
    EXPECT_EQ(sources.text(Span{}), "");
}

TEST(Sources, ReleasedTextKeepsItsName) {
    Sources sources;
    const SourceId id = add(sources, "a\nb\n");
    EXPECT_EQ(sources.line_count(id), 3u);
    sources.release_text(id);
    EXPECT_EQ(sources[id].path, "a.lrs");
    EXPECT_EQ(sources.line_count(id), 1u);
    EXPECT_EQ(sources.text(Span::make(id, 0, 1)), "");
}

}  // namespace
}  // namespace lray
