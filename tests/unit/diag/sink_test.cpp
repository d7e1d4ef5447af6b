// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <diag/sink.hpp>

#include <gtest/gtest.h>

namespace oroforge::diag {
namespace {

TEST(Sink, IsEmptyAtFirst) {
    const Sink sink;

    EXPECT_TRUE(sink.empty());
    EXPECT_FALSE(sink.hadErrors());
}

TEST(Sink, CountsErrorsAndWarningsApart) {
    Sink sink;

    sink.error({"a", 1, 1}, "X1", "one");
    sink.warning({"a", 2, 1}, "X2", "two");
    sink.note({"a", 3, 1}, "three");

    EXPECT_EQ(sink.errorCount(), 1U);
    EXPECT_EQ(sink.warningCount(), 1U);
    EXPECT_EQ(sink.all().size(), 3U);
}

TEST(Sink, WarningsAreNoErrors) {
    Sink sink;

    sink.warning({}, "", "careful");

    EXPECT_FALSE(sink.hadErrors());
}

TEST(Sink, SortsByPlaceAndKeepsTheOrderOfReportsAtOnePlace) {
    Sink sink;
    sink.error({"b", 1, 1}, "", "last");
    sink.error({"a", 10, 1}, "", "third");
    sink.error({"a", 2, 9}, "", "first of two");
    sink.error({"a", 2, 9}, "", "second of two");

    const auto sorted = sink.sorted();

    ASSERT_EQ(sorted.size(), 4U);
    EXPECT_EQ(sorted[0].message, "first of two");
    EXPECT_EQ(sorted[1].message, "second of two");
    EXPECT_EQ(sorted[2].message, "third");
    EXPECT_EQ(sorted[3].message, "last");
}

TEST(Sink, DropsRepeatsWhenSorting) {
    Sink sink;
    sink.error({"a", 1, 1}, "X1", "same");
    sink.error({"a", 1, 1}, "X1", "same");

    EXPECT_EQ(sink.sorted().size(), 1U);
}

TEST(Sink, KeepsNotesWithTheirDiagnostic) {
    Sink sink;

    sink.error({"a", 5, 1}, "X1", "twice").note({"a", 1, 1}, "first here").hint("rename one");

    ASSERT_EQ(sink.all().front().notes.size(), 2U);
    EXPECT_EQ(sink.all().front().notes[0].message, "first here");
    EXPECT_EQ(sink.all().front().notes[1].where.line, 0U);
}

TEST(Sink, CountsWhatIsTooMuchToShow) {
    Sink sink;
    for (unsigned i = 1; i <= 1500; ++i) sink.error({"f", i, 1}, "E", "wrong").hint("a hint");
    for (unsigned i = 1; i <= 2000; ++i) sink.warning({"g", i, 1}, "W", "odd");

    EXPECT_EQ(sink.errorCount(), 1500U);
    EXPECT_EQ(sink.warningCount(), 2000U);
    EXPECT_EQ(sink.all().size(), 2 * Sink::kMost);
    const auto sorted = sink.sorted();
    ASSERT_EQ(sorted.size(), 2 * Sink::kMost + 1);
    EXPECT_EQ(sorted.back().message, "500 more errors and 1000 more warnings are not shown");
    EXPECT_EQ(sorted.back().severity, Severity::Note);
}

}  // namespace
}  // namespace oroforge::diag
