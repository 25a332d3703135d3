#include "base/diagnostics.h"

#include <gtest/gtest.h>

#include <string>

namespace lray {
namespace {

Span at(SourceId source, std::size_t offset) {
    return Span::make(source, offset, offset + 1);
}

TEST(Diagnostics, SecondErrorInOnePlaceIsDropped) {
    Diagnostics diagnostics;
    diagnostics.error(Code::E0201, at(0, 5), "unknown name `a`");
    diagnostics.error(Code::E0301, at(0, 5), "wrong type").with_hint("lost");
    ASSERT_EQ(diagnostics.sorted().size(), 1u);
    EXPECT_EQ(diagnostics.error_count(), 1u);
    EXPECT_EQ(diagnostics.sorted()[0]->message, "unknown name `a`");
    EXPECT_EQ(diagnostics.sorted()[0]->hint, "");
    EXPECT_EQ(diagnostics.sorted()[0]->count, 1u);
}

TEST(Diagnostics, SameErrorInOnePlaceIsCounted) {
    Diagnostics diagnostics;
    for (int i = 0; i < 37; ++i) diagnostics.error(Code::E0503, at(0, 5), "division by zero");
    ASSERT_EQ(diagnostics.sorted().size(), 1u);
    EXPECT_EQ(diagnostics.sorted()[0]->count, 37u);
    EXPECT_EQ(diagnostics.error_count(), 1u);
}

TEST(Diagnostics, WarningAndErrorMayShareAPlace) {
    Diagnostics diagnostics;
    diagnostics.warning(Code::W1301, at(0, 5), "scale after translate");
    EXPECT_FALSE(diagnostics.has_errors());
    diagnostics.error(Code::E0310, at(0, 5), "not invertible");
    EXPECT_EQ(diagnostics.sorted().size(), 2u);
    EXPECT_EQ(diagnostics.warning_count(), 1u);
    EXPECT_EQ(diagnostics.error_count(), 1u);
}

TEST(Diagnostics, NowhereIsNoPlace) {
    Diagnostics diagnostics;
    diagnostics.error(Code::E0601, {}, "not found: a");
    diagnostics.error(Code::E0601, {}, "not found: b");
    EXPECT_EQ(diagnostics.error_count(), 2u);
}

TEST(Diagnostics, SortedBySourceThenPosition) {
    Diagnostics diagnostics;
    diagnostics.error(Code::E0601, {}, "nowhere");
    diagnostics.error(Code::E0201, at(1, 0), "second file");
    diagnostics.error(Code::E0201, at(0, 9), "late");
    diagnostics.warning(Code::W1301, at(0, 3), "early");
    std::string order;
    for (const Diagnostic* diagnostic : diagnostics.sorted()) order += diagnostic->message + "; ";
    EXPECT_EQ(order, "early; late; second file; nowhere; ");
}

TEST(Diagnostics, NotesStayWithTheirError) {
    Diagnostics diagnostics;
    diagnostics.error(Code::E0402, at(0, 9), "set twice")
        .with_hint("here")
        .with_label(at(0, 2), "first set here")
        .with_note("a note")
        .with_help("a help");
    const Diagnostic& diagnostic = *diagnostics.sorted()[0];
    EXPECT_EQ(diagnostic.hint, "here");
    ASSERT_EQ(diagnostic.labels.size(), 1u);
    EXPECT_EQ(diagnostic.labels[0].span, at(0, 2));
    EXPECT_EQ(diagnostic.notes, std::vector<std::string>{"a note"});
    EXPECT_EQ(diagnostic.helps, std::vector<std::string>{"a help"});
}

TEST(Diagnostics, AtMostKMaxKeptAreKeptAndAllCounted) {
    Diagnostics diagnostics;
    for (std::size_t i = 0; i < Diagnostics::kMaxKept + 5; ++i) {
        diagnostics.error(Code::E0001, at(0, i), "unexpected `?`").with_note("kept or not");
    }
    EXPECT_EQ(diagnostics.sorted().size(), Diagnostics::kMaxKept);
    EXPECT_EQ(diagnostics.error_count(), Diagnostics::kMaxKept + 5);
    // A mistake that is known stays one mistake, also when no more are kept.
    diagnostics.error(Code::E0001, at(0, 7), "unexpected `?`");
    EXPECT_EQ(diagnostics.error_count(), Diagnostics::kMaxKept + 5);
    EXPECT_EQ(diagnostics.sorted()[7]->count, 2u);
}

TEST(Diagnostics, LimitsAreToldFromMistakes) {
    Diagnostics diagnostics;
    diagnostics.error(Code::E0201, at(0, 1), "unknown name `a`");
    EXPECT_FALSE(diagnostics.has_limit_errors());
    // Even where it is not shown, as the place has its error already.
    diagnostics.error(Code::E0115, at(0, 1), "nested more than 256 deep");
    EXPECT_TRUE(diagnostics.has_limit_errors());
}

}  // namespace
}  // namespace lray
