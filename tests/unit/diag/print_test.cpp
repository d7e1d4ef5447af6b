// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <diag/print.hpp>

#include <sstream>

#include <gtest/gtest.h>

namespace oroforge::diag {
namespace {

std::string printed(const Diagnostic& diagnostic, const std::string& source) {
    SourceCache sources;
    sources.add("f.xml", source);
    std::ostringstream out;
    print(out, diagnostic, sources);
    return out.str();
}

Diagnostic errorAt(Location where) { return {Severity::Error, "X1", std::move(where), "found x", {}}; }

TEST(Print, ShowsSourceLineAndCaret) {
    EXPECT_EQ(printed(errorAt({"f.xml", 2, 3}), "one\nab cd\n"), "f.xml:2:3: error: [X1] found x\nab cd\n  ^\n");
}

TEST(Print, LeavesOutWhatIsUnknown) {
    EXPECT_EQ(printed(errorAt({"f.xml", 2, 0}), "one\ntwo\n"), "f.xml:2: error: [X1] found x\ntwo\n");
    EXPECT_EQ(printed(errorAt({"f.xml", 0, 0}), "one\n"), "f.xml: error: [X1] found x\n");
    EXPECT_EQ(printed(errorAt({}), "one\n"), "error: [X1] found x\n");
    EXPECT_EQ(printed({Severity::Warning, "", {}, "hm", {}}, ""), "warning: hm\n");
}

TEST(Print, ShowsNoSourceForFilesThatCannotBeRead) {
    EXPECT_EQ(printed(errorAt({"/nowhere/g.xml", 2, 3}), ""), "/nowhere/g.xml:2:3: error: [X1] found x\n");
}

TEST(Print, LinesBeyondTheEndAreLeftOut) {
    EXPECT_EQ(printed(errorAt({"f.xml", 7, 1}), "one\n"), "f.xml:7:1: error: [X1] found x\n");
}

TEST(Print, CaretStandsBelowItsLetterAfterTabsAndUtf8) {
    EXPECT_EQ(printed(errorAt({"f.xml", 1, 3}), "\t\tx\n"), "f.xml:1:3: error: [X1] found x\n\t\tx\n\t\t^\n");
    EXPECT_EQ(printed(errorAt({"f.xml", 1, 3}), "\xC3\xA4x\n"), "f.xml:1:3: error: [X1] found x\n\xC3\xA4x\n ^\n");
}

TEST(Print, CarriageReturnsAreNotShown) {
    EXPECT_EQ(printed(errorAt({"f.xml", 1, 1}), "ab\r\n"), "f.xml:1:1: error: [X1] found x\nab\n^\n");
}

TEST(Print, NotesFollowWithTheirOwnPlace) {
    Diagnostic diagnostic = errorAt({"f.xml", 2, 1});
    diagnostic.note({"f.xml", 1, 1}, "first here").hint("do this");

    EXPECT_EQ(printed(diagnostic, "one\ntwo\n"),
              "f.xml:2:1: error: [X1] found x\ntwo\n^\nf.xml:1:1: note: first here\none\n^\nnote: do this\n");
}

TEST(Print, OfAVeryLongLineThePartAroundTheCaretIsShown) {
    const std::string as(300, 'a'), bs(1000, 'b');
    EXPECT_EQ(printed(errorAt({"f.xml", 1, 2}), as + bs), "f.xml:1:2: error: [X1] found x\n" + as + "...\n ^\n");
    EXPECT_EQ(printed(errorAt({"f.xml", 1, 1301}), as + bs + "x"),
              "f.xml:1:1301: error: [X1] found x\n..." + std::string(99, 'b') + "x\n" + std::string(102, ' ') + "^\n");
}

TEST(Print, FixesStandBelowTheCaretAndAsLinesOfTheirOwn) {
    Diagnostic diagnostic = errorAt({"f.xml", 2, 8});
    diagnostic.fixes = {{{"f.xml", 2, 4}, {"f.xml", 2, 7}, "string"}, {{"f.xml", 1, 1}, {"f.xml", 1, 1}, "include\n"}};
    diagnostic.hint("use string");
    EXPECT_EQ(
        printed(diagnostic, "one\nab cde f\n"),
        "f.xml:2:8: error: [X1] found x\nab cde f\n       ^\n   string\n"
        "f.xml:2:4: fix-it: replace 'cde' with 'string'\nf.xml:1:1: fix-it: insert 'include'\nnote: use string\n");
}

TEST(Print, AFixThatRemovesNamesWhatGoes) {
    Diagnostic diagnostic = errorAt({"f.xml", 1, 7});
    diagnostic.fixes = {{{"f.xml", 1, 1}, {"f.xml", 1, 7}, ""}};
    EXPECT_EQ(printed(diagnostic, "const x\n"),
              "f.xml:1:7: error: [X1] found x\nconst x\n      ^\nf.xml:1:1: fix-it: remove 'const '\n");
    diagnostic.fixes = {{{"f.xml", 1, 1}, {"f.xml", 2, 1}, ""}};
    EXPECT_EQ(printed(diagnostic, "const x\n"),
              "f.xml:1:7: error: [X1] found x\nconst x\n      ^\nf.xml:1:1: fix-it: remove all up to line 2:1\n");
}

TEST(Print, SeveralFixesInALineKeepTheirPlaces) {
    Diagnostic diagnostic = errorAt({"f.xml", 1, 1});
    diagnostic.fixes = {{{"f.xml", 1, 9}, {"f.xml", 1, 9}, ";"}, {{"f.xml", 1, 1}, {"f.xml", 1, 4}, "X"}};
    EXPECT_EQ(printed(diagnostic, "\xC3\xA4 b = 2\n"),
              "f.xml:1:1: error: [X1] found x\n\xC3\xA4 b = 2\n^\nX      ;\n"
              "f.xml:1:9: fix-it: insert ';'\nf.xml:1:1: fix-it: replace '\xC3\xA4 ' with 'X'\n");
}

TEST(Print, FixesOfANoteFollowIt) {
    Diagnostic diagnostic = errorAt({});
    diagnostic.note({"f.xml", 1, 1}, "did you mean").notes.back().fixes = {{{"f.xml", 1, 1}, {"f.xml", 1, 2}, "y"}};
    EXPECT_EQ(printed(diagnostic, "x\n"),
              "error: [X1] found x\nf.xml:1:1: note: did you mean\nx\n^\ny\n"
              "f.xml:1:1: fix-it: replace 'x' with 'y'\n");
}

TEST(Print, WholeSinkIsOrderedAndWithoutRepeats) {
    Sink sink;
    sink.error({"f.xml", 2, 0}, "B", "second");
    sink.error({"f.xml", 1, 0}, "A", "first");
    sink.error({"f.xml", 1, 0}, "A", "first");
    SourceCache sources;
    std::ostringstream out;

    print(out, sink, sources);

    EXPECT_EQ(out.str(), "f.xml:1: error: [A] first\nf.xml:2: error: [B] second\n");
}

}  // namespace
}  // namespace oroforge::diag
