// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <gtest/gtest.h>

#include <merge/argument_list.hpp>
#include <merge/edits.hpp>
#include <merge/method_style.hpp>
#include <merge/record.hpp>
#include <merge/text_places.hpp>
#include <merge/unified_diff.hpp>

namespace oroforge::merge {
namespace {

using Arguments = std::vector<model::TypedName>;

/// A function whose arguments are "TYPE name" between commas, with blanks around.
model::UserFunction functionOf(const std::string& text) {
    model::UserFunction function;
    function.brackets = {text.find('(') + 1, text.rfind(')')};
    for (std::size_t at = function.brackets.begin; at < function.brackets.end;) {
        const std::size_t comma = std::min(text.find(',', at), function.brackets.end);
        const std::size_t begin = text.find_first_not_of(" \n", at);
        const std::size_t type = text.find(' ', begin);
        const std::size_t end = std::min(text.find_first_of(" ,\n)", type + 1), comma);
        if (begin >= comma) break;
        model::UserParameter one;
        one.name = text.substr(type + 1, end - type - 1);
        one.type = {begin, type};
        one.whole = {begin, end};
        function.parameters.push_back(one);
        at = comma + 1;
    }
    return function;
}

NewArguments rewritten(const std::string& text, const Arguments& from, const Arguments& to, bool comment = false) {
    return changedArguments(text, functionOf(text), from, to, comment);
}

TEST(MatchArguments, GoesByNameThenByType) {
    const Arguments from = {{"int", "a"}, {"bool", "b"}, {"int", "c"}};

    EXPECT_EQ(matchArguments(from, {{"double", "a"}, {"int", "c"}}), (std::vector<int>{0, 2}));
    EXPECT_EQ(matchArguments(from, {{"int", "renamed"}, {"bool", "b"}}), (std::vector<int>{0, 1}));
    EXPECT_EQ(matchArguments(from, {{"float", "x"}, {"bool", "b"}}), (std::vector<int>{-1, 1}));
    EXPECT_EQ(matchArguments({}, {{"int", "a"}}), (std::vector<int>{-1}));
}

TEST(ChangedArguments, KeepWhatTheUserWroteAroundThoseThatStay) {
    const Arguments from = {{"int", "a"}, {"int", "b"}};

    EXPECT_EQ(rewritten("f( int mine, int other )", from, {{"double", "a"}, {"int", "b"}}).text,
              " double mine, int other ");
    EXPECT_EQ(rewritten("f(int a,\n  int b)", from, {{"int", "a"}, {"int", "b"}, {"bool", "c"}}).text,
              "int a,\n  int b,\n  bool c");
    EXPECT_EQ(rewritten("f(int a, int b)", from, {{"int", "b"}}).text, "int b");
    EXPECT_EQ(rewritten("f(int a, int b)", from, {}).text, "");
    EXPECT_EQ(rewritten("f()", {}, {{"bool", "c"}}, true).text, "bool /*c*/");
    EXPECT_EQ(rewritten("f(int mine)", {{"int", "a"}}, {{"bool", "n"}, {"int", "a"}}).text, "bool n, int mine");
}

TEST(ChangedArguments, PutACommaBeforeALineComment) {
    const NewArguments list = rewritten("f(int a, int b  // last\n)", {{"int", "a"}, {"int", "b"}},
                                        {{"int", "a"}, {"int", "b"}, {"bool", "c"}});

    EXPECT_EQ(list.fault, "");
    EXPECT_EQ(list.text, "int a, int b,  // last\nbool c");
}

TEST(ChangedArguments, LeaveACommentInFrontOfItsComma) {
    const NewArguments list = rewritten("f(int a /*1st*/ , int b)", {{"int", "a"}, {"int", "b"}},
                                        {{"int", "a"}, {"bool", "c"}, {"int", "b"}});

    EXPECT_EQ(list.fault, "");
    EXPECT_EQ(list.text, "int a /*1st*/ , bool c, int b");
}

TEST(ChangedArguments, DoNotLoseComments) {
    const Arguments from = {{"int", "a"}, {"int", "b"}};

    EXPECT_NE(rewritten("f(int a, int b /* why */)", from, {{"int", "a"}}).fault, "");
    EXPECT_NE(rewritten("f(int a, int b=1)", from, {{"int", "a"}, {"int", "b"}, {"bool", "c"}}).fault, "");
    EXPECT_EQ(rewritten("f(int a, int b /*b*/)", from, {{"int", "a"}}).fault, "");
}

TEST(BehindItem, SkipsCommentsThatBelongToIt) {
    const std::string text = "int a;  ///< one\n        ///< more\n// of b\nint b; int c;\nint d; /* x\n */\nint e;";
    const auto behind = [&](const char* item) { return behindItem(text, text.find(item) + 6); };

    EXPECT_EQ(text.substr(behind("int a;"), 7), "// of b");
    EXPECT_EQ(behind("int b;"), text.find("int b;") + 6);
    EXPECT_EQ(text.substr(behind("int d;"), 6), "int e;");
    EXPECT_EQ(behind("int e;"), text.size());
}

TEST(WithComment, FindsTheCommentAbove) {
    const std::string text = "int a; /* of a */\n/* of\n b */\n// more\nint b;";

    EXPECT_EQ(withComment(text, text.find("int b")), text.find("/* of\n"));
}

TEST(Edits, AreMadeInTheOrderOfTheirPlaces) {
    const std::string text = "one two three";
    Edits edits;
    edits.replace("f", {4, 7}, "2");
    edits.insert("f", 0, "zero ");
    edits.insert("f", 0, "half ");

    EXPECT_EQ(applied(text, edits.byFile().at("f")), "zero half one 2 three");
}

TEST(Edits, FormatLinesWhereTheyWillBe) {
    const std::string text = "one\ntwo three\n";
    Edits edits;
    edits.replace("f", {0, 3}, "first");
    edits.insert("f", 4, "a\n");
    edits.replace("f", {8, 8}, "and ");
    edits.insert("f", text.size(), "b\n");
    edits.replace("g", {0, 0}, "no line");
    std::string seen;
    edits.format({{"f", text}, {"g", ""}}, [&](const auto& file, const auto& after, const auto& inserted) {
        seen += file + ": " + after;
        std::vector<std::string> formatted;
        for (const model::Span& span : inserted) formatted.push_back("<" + cut(after, span) + ">");
        return formatted;
    });

    EXPECT_EQ(seen, "f: first\na\ntwo and three\nb\n");
    EXPECT_EQ(applied(text, edits.byFile().at("f")), "first\n<a\n>two and three\n<b\n>");
}

TEST(Moved, FollowsWhatWasInserted) {
    const std::string text = "a\nb c\nd";
    const std::vector<Edit> edits = {{{2, 2}, "new\n", true}, {{2, 3}, "bb", false}};

    EXPECT_EQ(moved({"f", 1, 1}, text, edits), (diag::Location{"f", 1, 1}));
    EXPECT_EQ(moved({"f", 2, 3}, text, edits), (diag::Location{"f", 3, 4}));
    EXPECT_EQ(moved({"f", 3, 1}, text, edits), (diag::Location{"f", 4, 1}));
}

TEST(Record, SurvivesItsText) {
    Record record;
    record["a::B"].methods["finish"] = {{"const std::string&", {{"unsigned int", "n"}}}, false, true};
    record["a::B"].members["level"] = {"port", "level_", "double", false, "InputPort", {{"addPort", {{"", "Words"}}}}};
    record["a::B"].methods["finish"].registration = {{"OwnThread", {{"", "Ends"}, {"n", "How \"many\""}}}};
    diag::Sink sink;
    const auto read = parseRecord(toText(record), "r.json", sink);

    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(toText(*read), toText(record));
    EXPECT_EQ(read->at("a::B").methods.at("finish").signature, record["a::B"].methods["finish"].signature);
    EXPECT_TRUE(read->at("a::B").methods.at("finish").kept);
}

TEST(Record, ThatIsBrokenIsAnError) {
    diag::Sink sink;

    EXPECT_FALSE(parseRecord("<<<<<<< HEAD", "r.json", sink).has_value());
    EXPECT_FALSE(parseRecord(R"({"format": 99, "classes": {}})", "r.json", sink).has_value());
    EXPECT_EQ(sink.errorCount(), 2u);
}

TEST(UnifiedDiff, ShowsWhatDiffersWithContext) {
    EXPECT_EQ(unifiedDiff("a\n", "a\n", "f"), "");
    EXPECT_EQ(unifiedDiff("a\nb\nc", "a\nx\nc", "f"),
              "--- a/f\n+++ b/f\n@@ -1,3 +1,3 @@\n a\n-b\n+x\n c\n\\ No newline at end of file\n");
    EXPECT_EQ(unifiedDiff("", "a\n", "f"), "--- /dev/null\n+++ b/f\n@@ -0,0 +1 @@\n+a\n");
}

TEST(NeedsNamespace, WhereATypeIsKnownOnlyInside) {
    EXPECT_TRUE(needsNamespace("LevelSample", "tank"));
    EXPECT_TRUE(needsNamespace("std::vector<LevelSample>", "tank"));
    EXPECT_FALSE(needsNamespace("tank::LevelSample", "tank"));
    EXPECT_FALSE(needsNamespace("const std::vector<double>&", "tank"));
    EXPECT_FALSE(needsNamespace("LevelSample", ""));
}

}  // namespace
}  // namespace oroforge::merge
