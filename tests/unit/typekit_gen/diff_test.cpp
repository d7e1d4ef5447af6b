// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// typegen --diff: what changed between two headers, and whether it breaks what was built before.
#include <diff/compare_models.hpp>
#include <driver/typegen.hpp>

#include <sstream>

#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

using oroforge::test::TempDir;

namespace {

struct Outcome {
    int status;
    std::string out, err;
};

Outcome diff(const std::vector<std::string>& words) {
    std::ostringstream out, err;
    const int status = oroforge::typekit::run(words, out, err);
    return {status, out.str(), err.str()};
}

struct Case {
    const char* name;
    const char* old;
    const char* now;
    const char* told;     ///< part of the text
    const char* verdict;  ///< the line on standard output
};

const char kOneBreaks[] = "breaking: 1 change breaks, 0 would not\n";
const char kOneMayBe[] = "compatible: 1 change\n";

const Case kCases[] = {
    {"Nothing", "struct S { int a; };", "/* new */ struct S { int a; /* words */ };", "", "compatible: no change\n"},
    {"FieldMoved", "struct S { int a; int b; };", "struct S { int b; int a; };",
     "new.hpp:2:16: error: [TK064] field 'b' of 'S' is at byte 0, was at byte 4",
     "breaking: 2 changes break, 0 would not\n"},
    {"FieldRenamed", "struct S { int a; };", "struct S { int z; };", "field 'z' of 'S' was called 'a'", kOneBreaks},
    {"FieldRetyped", "struct S { int a; };", "struct S { float a; };", "field 'a' of 'S' is of type 'float', was 'int'",
     kOneBreaks},
    {"ArrayLonger", "struct S { int a[2]; };", "struct S { int a[3]; };",
     "field 'a' of 'S' is of type 'int[3]', was 'int[2]'", kOneBreaks},
    {"FieldAdded", "struct S { int a; };", "struct S { int a; char b; };", "field 'b' of 'S' is new", kOneBreaks},
    {"FieldRemoved", "struct S { int a; char b; };", "struct S { int a; };",
     "old.hpp:2:24: error: [TK064] field 'b' of 'S' is gone", kOneBreaks},
    {"BitsWider", "struct S { int a : 3; int b : 3; };", "struct S { int a : 4; int b : 3; };",
     "field 'b' of 'S' is at bit 4, was at bit 3", "breaking: 2 changes break, 0 would not\n"},
    {"OnlyAligned", "struct S { int a; };", "struct alignas(8) S { int a; };", "'S' has 8 bytes, was 4", kOneBreaks},
    {"TypeAdded", "struct S { int a; };", "struct S { int a; }; struct T {};", "struct 'T' is new", kOneMayBe},
    {"TypeRemoved", "struct S { int a; }; enum E { A };", "struct S { int a; };", "enum 'E' is gone", kOneBreaks},
    {"EnumeratorAdded", "enum E { A };", "enum E { A, B };", "enumerator 'B' of 'E' is new", kOneMayBe},
    {"EnumeratorRemoved", "enum E { A, B };", "enum E { A };", "enumerator 'B' of 'E' is gone", kOneBreaks},
    {"EnumeratorRenumbered", "enum E { A = 1 };", "enum E { A = 2 };", "enumerator 'A' of 'E' is 2, was 1", kOneBreaks},
    {"EnumOfOtherNumbers", "enum class E { A };", "enum class E : char { A };", "'E' is char, was int", kOneBreaks},
    {"UnitChanged", "struct S { int a; ///< @unit m\n};", "struct S { int a; ///< @unit mm\n};",
     "field 'a' of 'S' has the unit mm, was m", kOneBreaks},
    {"UnitAdded", "struct S { int a; };", "struct S { int a; ///< @unit m\n};",
     "new.hpp:2:16: note: field 'a' of 'S' has the unit m, was none", kOneMayBe},
    {"RangeChanged", "struct S { int a; ///< @range 0..1\n};", "struct S { int a; ///< @range 0..2\n};",
     "field 'a' of 'S' has the range 0..2, was 0..1", kOneMayBe},
};

class Diff : public testing::TestWithParam<Case> {
protected:
    const TempDir dir_;
};

/// What is said of a struct whose comment names another message of ROS; the messages need not be installed.
std::string messageChange(const std::string& old, const std::string& now, bool isBreaking) {
    oroforge::model::TypeModel before, after;
    before.structs.emplace_back();
    before.structs[0].cpp = "::S";
    after.structs = before.structs;
    before.structs[0].message = old;
    after.structs[0].message = now;
    const auto changes = oroforge::typekit::compareModels(before, after);
    if (changes.empty()) return "";
    EXPECT_EQ(1U, changes.size());
    EXPECT_EQ(isBreaking, changes[0].breaking) << changes[0].message;
    return changes[0].message;
}

TEST(MessageDiff, NamesAndSumsOfMessagesAreCompared) {
    EXPECT_EQ("", messageChange("a/B", "a/B", false));
    EXPECT_EQ("'S' is the message a/C, was a/B", messageChange("a/B", "a/C", true));
    EXPECT_EQ("'S' is the message a/B, was none", messageChange("", "a/B", false));
    EXPECT_EQ("'S' is no message of ROS, was a/B", messageChange("a/B", "", true));
    EXPECT_EQ("", messageChange("a/B", "a/B 01", false));  // a sum that is only checked now
    EXPECT_EQ("'S' is the message a/B with MD5 sum 02, was 01", messageChange("a/B 01", "a/B 02", true));
}

}  // namespace

TEST_P(Diff, TellsWhatChangedAndWhetherItBreaks) {
    const std::string old = dir_.write("old.hpp", std::string("#pragma once\n") + GetParam().old + "\n").string();
    const std::string now = dir_.write("new.hpp", std::string("#pragma once\n") + GetParam().now + "\n").string();
    const Outcome run = diff({"--diff", old, now});
    EXPECT_EQ(run.out, GetParam().verdict);
    EXPECT_EQ(run.status, run.out.compare(0, 8, "breaking") == 0 ? 1 : 0);
    EXPECT_NE(run.err.find(GetParam().told), std::string::npos) << run.err;
    EXPECT_EQ(run.err.empty(), *GetParam().told == '\0') << run.err;
    EXPECT_EQ(diff({"--diff", old, old}).out, "compatible: no change\n");
}

INSTANTIATE_TEST_SUITE_P(All, Diff, testing::ValuesIn(kCases), [](const auto& info) { return info.param.name; });

TEST(DiffOfFolders, ComparesAllTheirHeaders) {
    const TempDir dir;
    (void)dir.write("old/demo/a.hpp", "#pragma once\n#include \"b.hpp\"\nnamespace demo { struct A { B b; }; }\n");
    (void)dir.write("old/demo/b.hpp", "#pragma once\nnamespace demo { struct B { int x; }; }\n");
    (void)dir.write("new/demo/a.hpp", "#pragma once\n#include \"b.hpp\"\nnamespace demo { struct A { B b; }; }\n");
    (void)dir.write("new/demo/b.hpp", "#pragma once\nnamespace demo { struct B { long x; }; }\n");
    const Outcome run = diff({"--diff", (dir / "old").string(), (dir / "new").string()});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("field 'x' of 'demo::B' is of type 'long', was 'int'"), std::string::npos) << run.err;
}

TEST(DiffOfAdaptedClasses, ComparesTheirElementsAndSizes) {
    const TempDir dir;
    const std::string adapters =
        dir.write("a.xml",
                  "<adapters><sequence class=\"Ring\" size=\"4\" element=\"[index]\"/>"
                  "<sequence class=\"Row\" arguments=\"$N\" size=\"$N\" element=\"[index]\"/></adapters>")
            .string();
    const std::string rest =
        "template <int N> struct Row { int& operator[](int i); int operator[](int i) const; private: int at[N]; };\n"
        "using R = Row<2>;\n";
    const auto ring = [&](const std::string& element, const std::string& length) {
        return "#pragma once\nclass Ring { public: " + element + "& operator[](int i); " + element +
               " operator[](int i) const; private: int at[" + length + "]; };\n" + rest;
    };
    const auto compared = [&](const std::string& text) {
        const std::string old = dir.write("old.hpp", ring("int", "4")).string();
        return diff({"--adapters=" + adapters, "--diff", old, dir.write("new.hpp", text).string()});
    };
    EXPECT_EQ(compared(ring("int", "4")).out, "compatible: no change\n");
    EXPECT_NE(compared(ring("float", "4")).err.find("an element of 'Ring' is of type 'float', was 'int'"),
              std::string::npos);
    EXPECT_NE(compared(ring("int", "8")).err.find("'Ring' has 32 bytes, was 16"), std::string::npos);
    const auto gone = compared("#pragma once\n" + rest);
    EXPECT_NE(gone.err.find("class 'Ring' is gone"), std::string::npos) << gone.err;
    EXPECT_EQ(gone.out, "breaking: 1 change breaks, 0 would not\n");
}

TEST(DiffOfFolders, TheVerdictIsTheLastLine) {
    const TempDir dir;
    const std::string old = dir.write("old.hpp", "#pragma once\nstruct S { int a; };\n").string();
    const std::string now = dir.write("new.hpp", "#pragma once\nstruct S { float a; };\n").string();
    std::ostringstream terminal;
    EXPECT_EQ(oroforge::typekit::run({"--diff", old, now}, terminal, terminal), 1);
    const std::string told = terminal.str();
    EXPECT_NE(told.find("TK064"), std::string::npos) << told;
    EXPECT_EQ(told.rfind(kOneBreaks), told.size() - sizeof kOneBreaks + 1) << told;
}

TEST(DiffOfFolders, IsADocumentForPrograms) {
    const TempDir dir;
    const std::string old = dir.write("old.hpp", "#pragma once\nstruct S { int a; };\n").string();
    const std::string now = dir.write("new.hpp", "#pragma once\nstruct S { float a; };\n").string();
    const Outcome run = diff({"--diff", old, now, "--format=json"});
    EXPECT_EQ(run.out[0], '{');
    EXPECT_NE(run.out.find("\"code\": \"TK064\""), std::string::npos) << run.out;
    EXPECT_EQ(run.err, "breaking: 1 change breaks, 0 would not\n");
}

TEST(DiffOptions, AreRefusedTogetherWithThoseThatGenerate) {
    const Outcome run = diff({"--diff", "a.hpp", "-o", "out", "--check"});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("--diff takes two headers or folders, OLD and NEW, found 1"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("--diff and --output exclude each other"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("--diff and --check exclude each other"), std::string::npos) << run.err;
}

TEST(DiffOfBadHeaders, TellsTheErrorAndComparesNothing) {
    const TempDir dir;
    const std::string good = dir.write("good.hpp", "#pragma once\nstruct S { int a; };\n").string();
    const std::string bad = dir.write("bad.hpp", "#pragma once\nstruct S { int* a; };\n").string();
    const Outcome run = diff({"--diff", good, bad});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("bad.hpp:2:17: error: [TK010]"), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
}
