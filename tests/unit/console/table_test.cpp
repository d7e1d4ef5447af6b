// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <console/table.hpp>

#include <gtest/gtest.h>

#include <sstream>

namespace {

using OCL::console::oneLine;
using OCL::console::shortened;
using OCL::console::Style;
using OCL::console::Table;
using OCL::console::Theme;
using OCL::console::valueOnOneLine;
using OCL::console::widthOf;
using OCL::console::wrapped;
using OCL::console::writeColumns;

std::string columns(const std::vector<std::string>& words, std::size_t width) {
    std::ostringstream out;
    writeColumns(out, words, Theme(), Style::Name, "  ", width);
    return out.str();
}

TEST(Table, ColumnsAreAsWideAsTheirWidestCell) {
    Table table({Style::Name, Style::Type, Style::Faint});
    table.add({"a", "double", "first"});
    table.add({"longer", "int", "second"});
    std::ostringstream out;
    table.write(out, Theme(), "  ", 0);
    EXPECT_EQ(
        "  a       double  first\n"
        "  longer  int     second\n",
        out.str());
}

TEST(Table, LeavesOutEmptyColumnsAndBlanksAtTheEnd) {
    Table table({Style::Name, Style::Type, Style::Faint});
    table.add({"a", "", "x"});
    table.add({"b", "", ""});
    table.add({"c"});
    std::ostringstream out;
    table.write(out, Theme(), "", 0);
    EXPECT_EQ("a  x\nb\nc\n", out.str());
}

TEST(Table, CutsTheLastColumnAtTheWidth) {
    Table table({Style::Name, Style::Faint});
    table.add({"name", "a long text that does not fit"});
    std::ostringstream out;
    table.write(out, Theme(), "", 20);
    EXPECT_EQ("name  a long text t…\n", out.str());
    EXPECT_EQ(20u, widthOf("name  a long text t…"));
}

TEST(Table, WrapsTheLastColumnIfWanted) {
    Table table({Style::Name, Style::Faint}, Table::Wrap);
    table.add({"name", "a long text that does not fit into one row"});
    table.add({"b", "short"});
    std::ostringstream out;
    table.write(out, Theme(), "  ", 30);
    EXPECT_EQ(
        "  name  a long text that does\n"
        "        not fit into one row\n"
        "  b     short\n",
        out.str());
}

TEST(Text, IsWrappedBetweenWords) {
    EXPECT_EQ((std::vector<std::string>{"one two", "three"}), wrapped("one two three", 8));
    EXPECT_EQ((std::vector<std::string>{"one", "seventeen", "two"}), wrapped("one seventeen two", 5));
    EXPECT_EQ((std::vector<std::string>{"öäü öäü"}), wrapped("öäü öäü", 7));
    EXPECT_EQ((std::vector<std::string>{"never at all"}), wrapped("never at all", 0));
}

TEST(Table, ColoursDoNotMoveColumns) {
    Table table({Style::Name, Style::Type});
    table.add({"a", "x"});
    table.add({"bb", "y"});
    std::ostringstream out;
    table.write(out, Theme(Theme::Dark), "", 0);
    std::string text = out.str();
    for (std::size_t at; (at = text.find('\033')) != std::string::npos;) text.erase(at, text.find('m', at) + 1 - at);
    EXPECT_EQ("a   x\nbb  y\n", text);
}

TEST(Table, LettersOfSeveralBytesCountOnce) {
    EXPECT_EQ(4u, widthOf("größ"));
    EXPECT_EQ("grö…", shortened("größer", 4));
    EXPECT_EQ("größer", shortened("größer", 6));
}

TEST(Table, OneLineJoinsBlanks) { EXPECT_EQ("a b c", oneLine("  a\n\tb   c \n")); }

TEST(Table, ValuesOnOneLineKeepBlanksOfTexts) {
    EXPECT_EQ("[1 2]", valueOnOneLine(" [1\n   2]\n"));
    EXPECT_EQ(R"({a = "  b   c ", d = 1})", valueOnOneLine(R"({a =  "  b   c ",  d = 1})"));
    EXPECT_EQ(R"("a \"  b")", valueOnOneLine(R"("a \"  b")"));
    EXPECT_EQ(R"({c = '"', d = 1})", valueOnOneLine(R"({c = '"',   d = 1})"));
    EXPECT_EQ("\"a b", valueOnOneLine("\"a\n\nb"));
}

TEST(Columns, GoDownAndThenRight) { EXPECT_EQ("  a  c\n  b  d\n", columns({"a", "b", "c", "d"}, 9)); }
TEST(Columns, OneIfNothingElseFits) { EXPECT_EQ("  long\n  words\n", columns({"long", "words"}, 3)); }
TEST(Columns, NothingForNoWords) { EXPECT_EQ("", columns({}, 80)); }

}  // namespace
