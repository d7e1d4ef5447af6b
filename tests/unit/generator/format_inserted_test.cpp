// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
//
// What is inserted stands between '<<' and '>>' in these texts.
#include <gtest/gtest.h>
#include <support/temp_dir.hpp>

#include <clang/update/format_inserted.hpp>

namespace oroforge::cxx {
namespace {

struct Formatted {
    std::string text;  ///< with the marks
    std::vector<std::string> warnings;
};

class FormatInserted : public testing::Test {
protected:
    Formatted format(const std::string& marked, const std::string& file = "src/Plant.cpp") {
        FormatRequest request{dir_.path().string(), "tank/", file, "", {}};
        std::vector<std::string> between;
        for (std::size_t at = 0;;) {
            const std::size_t begin = marked.find("<<", at);
            between.push_back(marked.substr(at, begin - at));
            request.text += between.back();
            if (begin == std::string::npos) break;
            const std::size_t end = marked.find(">>", begin);
            request.inserted.push_back({request.text.size(), request.text.size() + end - begin - 2});
            request.text += marked.substr(begin + 2, end - begin - 2);
            at = end + 2;
        }
        diag::Sink sink;
        const std::vector<std::string> inserted = formatInserted(request, sink);
        EXPECT_EQ(inserted.size(), request.inserted.size());
        Formatted result;
        for (std::size_t i = 0; i != between.size(); ++i)
            result.text += between[i] + (i < inserted.size() ? "<<" + inserted[i] + ">>" : "");
        for (const diag::Diagnostic& one : sink.all())
            result.warnings.push_back(one.where.file.str() + ":" + std::to_string(one.where.line) + ":" +
                                      std::to_string(one.where.column) + ": " + one.message);
        return result;
    }

    test::TempDir dir_;
};

const char* const kUgly = "int  a ;\n<<\nbool  Plant::f( int /*x*/ )\n{\n      return true ;\n}\n>>int  b ;\n";

TEST_F(FormatInserted, WithoutAStyleStays) { EXPECT_EQ(format(kUgly).text, kUgly); }

TEST_F(FormatInserted, TakesTheNearestStyle) {
    dir_.write(".clang-format", "BasedOnStyle: Google\n");
    EXPECT_EQ(format(kUgly).text, "int  a ;\n<<\nbool Plant::f(int /*x*/) { return true; }\n>>int  b ;\n");

    dir_.write("src/_clang-format", "BasedOnStyle: Microsoft\n");
    EXPECT_EQ(format(kUgly).text, "int  a ;\n<<\nbool Plant::f(int /*x*/)\n{\n    return true;\n}\n>>int  b ;\n");

    dir_.write("src/.clang-format", "DisableFormat: true\n");
    EXPECT_EQ(format(kUgly).text, kUgly);
}

TEST_F(FormatInserted, TakesThePartOfTheStyleThatIsForCpp) {
    dir_.write(".clang-format",
               "BasedOnStyle: LLVM\n---\nLanguage: Java\nIndentWidth: 8\n---\nLanguage: Cpp\nIndentWidth: 3\n"
               "AllowShortFunctionsOnASingleLine: None\n");
    EXPECT_EQ(format(kUgly).text, "int  a ;\n<<\nbool Plant::f(int /*x*/) {\n   return true;\n}\n>>int  b ;\n");
}

TEST_F(FormatInserted, InheritsFromTheFolderAbove) {
    dir_.write("src/.clang-format", "BasedOnStyle: InheritParentConfig\nAllowShortFunctionsOnASingleLine: None\n");
    EXPECT_EQ(format(kUgly).text, "int  a ;\n<<\nbool Plant::f(int /*x*/) {\n  return true;\n}\n>>int  b ;\n");

    dir_.write(".clang-format", "BasedOnStyle: LLVM\nIndentWidth: 5\n");
    EXPECT_EQ(format(kUgly).text, "int  a ;\n<<\nbool Plant::f(int /*x*/) {\n     return true;\n}\n>>int  b ;\n");
}

TEST_F(FormatInserted, BreaksLongLines) {
    dir_.write(".clang-format", "BasedOnStyle: LLVM\nColumnLimit: 30\n");
    EXPECT_EQ(format("class Plant {\n  void   mine();\n<<\n    /// Some words about what this does.\n"
                     "    virtual bool finish(int sent, int refused) override;\n>>};\n",
                     "src/Plant.hpp")
                  .text,
              "class Plant {\n  void   mine();\n<<\n  /// Some words about what\n  /// this does.\n"
              "  virtual bool finish(\n      int sent,\n      int refused) override;\n>>};\n");
}

TEST_F(FormatInserted, KeepsLinesOfTheirOwn) {
    dir_.write(".clang-format", "BasedOnStyle: Google\n");
    // Joined with the user's braces, this would be one line.
    const char* const constructor = "Plant::Plant() {<<\n  addPort(\"level\", level_);\n>>}\n";
    EXPECT_EQ(format(constructor).text, constructor);
    EXPECT_EQ(format("struct Plant {<<\n      void f( );\n>>};\n").text, "struct Plant {<<\n  void f();\n>>};\n");
}

TEST_F(FormatInserted, LeavesBlankLinesOfTheUser) {
    dir_.write(".clang-format", "BasedOnStyle: LLVM\nMaxEmptyLinesToKeep: 0\n");
    EXPECT_EQ(format("void a();  \n\n\n<<\n void f();\n>>\n\nvoid b();\n").text,
              "void a();  \n\n\n<<void f();\n>>\n\nvoid b();\n");
    EXPECT_EQ(format("void a();\n<<\n void f();\n>>\nvoid b();\n").text, "void a();\n<<void f();\n>>\nvoid b();\n");
}

TEST_F(FormatInserted, LeavesTheNamespaceAlone) {
    dir_.write(".clang-format", "BasedOnStyle: LLVM\nNamespaceIndentation: All\n");
    EXPECT_EQ(format("namespace tank {\nint  a;\n<<void f( );\n>>}\n").text,
              "namespace tank {\nint  a;\n<<void f();\n>>}\n");
    EXPECT_EQ(format("namespace tank {\n<<void f( );\n>>}\n").text, "namespace tank {\n<<  void f();\n>>}\n");
}

TEST_F(FormatInserted, FormatsEachOfSeveral) {
    dir_.write(".clang-format", "BasedOnStyle: LLVM\n");
    EXPECT_EQ(format("<<void f( );\n>>int  a ;\n<<void g( );\n>><<\nvoid h( );\n>>").text,
              "<<void f();\n>>int  a ;\n<<void g();\n>><<\nvoid h();\n>>");
}

TEST_F(FormatInserted, KeepsTheLineEndsOfTheFile) {
    dir_.write(".clang-format", "BasedOnStyle: Microsoft\nLineEnding: LF\n");
    EXPECT_EQ(format("int  a ;\r\n<<\r\nbool  f() {\r\n  return true; }\r\n>>").text,
              "int  a ;\r\n<<\r\nbool f()\r\n{\r\n    return true;\r\n}\r\n>>");
    dir_.write(".clang-format", "BasedOnStyle: Microsoft\nLineEnding: CRLF\n");
    EXPECT_EQ(format("int  a ;\n<<\nbool  f() {\n  return true; }\n>>").text,
              "int  a ;\n<<\nbool f()\n{\n    return true;\n}\n>>");
}

TEST_F(FormatInserted, AddsNoLineEndToTheLastLine) {
    dir_.write(".clang-format", "BasedOnStyle: LLVM\nInsertNewlineAtEOF: true\n");
    EXPECT_EQ(format("int  a ;<<\n\nvoid f( ) {\n}>>").text, "int  a ;<<\n\nvoid f() {}>>");
}

TEST_F(FormatInserted, WritesTabs) {
    dir_.write(".clang-format", "BasedOnStyle: LLVM\nUseTab: Always\nIndentWidth: 8\n");
    EXPECT_EQ(format("struct Plant {\n<<        void f();\n>>  };\n").text, "struct Plant {\n<<\tvoid f();\n>>  };\n");
}

TEST_F(FormatInserted, RespectsThatFormattingIsOff) {
    dir_.write(".clang-format", "BasedOnStyle: LLVM\n");
    const char* const off = "// clang-format off\n<<void  f( );\n>>// clang-format on\n";
    EXPECT_EQ(format(off).text, off);
}

TEST_F(FormatInserted, WithABrokenStyleStays) {
    dir_.write(".clang-format", "BasedOnStyle: Google\nIndentWidth: x\n");
    const Formatted result = format(kUgly);

    EXPECT_EQ(result.text, kUgly);
    EXPECT_EQ(result.warnings,
              std::vector<std::string>{"tank/.clang-format:2:14: this style cannot be used: invalid number; new code "
                                       "looks like the code around it"});
}

TEST_F(FormatInserted, WithAStyleForOtherLanguagesStays) {
    dir_.write(".clang-format", "Language: Java\n");
    const Formatted result = format(kUgly);

    EXPECT_EQ(result.text, kUgly);
    ASSERT_EQ(result.warnings.size(), 1U);
    EXPECT_EQ(result.warnings[0].find("tank/.clang-format:0:0: this style cannot be used: "), 0U);
}

TEST_F(FormatInserted, IgnoresWhatOnlyOtherVersionsKnow) {
    dir_.write(".clang-format", "BasedOnStyle: Google\nBreakLikeNobody: true\n");
    const Formatted result = format(kUgly);

    EXPECT_NE(result.text, kUgly);
    EXPECT_EQ(result.warnings,
              std::vector<std::string>{"tank/.clang-format:2:1: unknown key 'BreakLikeNobody': this line is ignored"});
}

TEST_F(FormatInserted, SurvivesDeepNesting) {
    dir_.write(".clang-format", "BasedOnStyle: LLVM\n");
    const std::string deep(20000, '{');
    const std::string text = "void a() " + deep + std::string(20000, '}') + "\n<<void  f();\n>>";

    EXPECT_NE(format(text).text, "");
}

}  // namespace
}  // namespace oroforge::cxx
