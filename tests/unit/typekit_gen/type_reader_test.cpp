// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <clang/types/type_reader.hpp>

#include <algorithm>
#include <cstdlib>

#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

using namespace oroforge;
using oroforge::test::TempDir;

namespace {

struct Read {
    TempDir dir;
    diag::Sink sink;
    std::optional<model::TypeModel> model;

    explicit Read(const std::string& text, const std::string& name = "types.hpp", std::vector<std::string> flags = {}) {
        cxx::ParseRequest request;
        request.headers = {{dir.write(name, text).string(), name}};
        request.flags = std::move(flags);
        request.strict = true;
        model = cxx::readTypes(request, sink);
    }
    const model::Field& field(const std::string& name) const {
        for (const auto& type : model.value().structs) {
            for (const auto& field : type.fields) {
                if (field.name == name) return field;
            }
        }
        throw std::out_of_range("no field " + name);
    }
    /// Of the error; that the texts here have no include guard gives warnings.
    std::string onlyCode() const {
        for (const diag::Diagnostic& one : sink.all()) {
            if (one.severity == diag::Severity::Error && sink.errorCount() == 1) return one.code;
        }
        return "not one error";
    }
};

}  // namespace

TEST(TypeReader, ReadsOffsetsAndSizes) {
    const Read read("struct A { char c; double d; int i[3]; };");
    ASSERT_TRUE(read.model);
    EXPECT_EQ(read.field("d").offset, 8U);
    EXPECT_EQ(read.field("i").offset, 16U);
    EXPECT_EQ(read.field("i").count, 3U);
    EXPECT_EQ(read.model->structs[0].size, 32U);
    EXPECT_EQ(read.model->structs[0].align, 8U);
}

TEST(TypeReader, DeclaresArraysOfClassesThatHaveBracketsInTheirNames) {
    const Read read(
        "#include <array>\nstruct A { int i[2][3][4]; std::array<int[2], 3> a[4][5]; std::array<int, 6> b[7]; };");
    ASSERT_TRUE(read.model);
    EXPECT_EQ(read.field("i").declared, "int[2][3][4]");
    EXPECT_EQ(read.field("a").declared, "std::array<int[2], 3>[4][5]");
    EXPECT_EQ(read.field("b").declared, "std::array<int, 6>[7]");
}

TEST(TypeReader, ReadsScopedEnumsOfTemplateInstances) {
    const Read read(
        "#include <vector>\ntemplate <class T> struct Of { enum class Kind { a, b }; Kind kind; T t; };\n"
        "struct A { Of<int> of; };\nstruct B { std::vector<Of<char>::Kind> kinds; };");
    ASSERT_TRUE(read.model);
    EXPECT_EQ(read.model->enums.size(), 2U);
}

TEST(TypeReader, NamesInstancesByVoidAndByEnumerators) {
    const Read read(
        "namespace n { template <class T> struct Some; enum class Axis { x, y }; template <class T, Axis A> struct Of "
        "{ int i; };\nstruct S { Of<Some<void>, Axis::y> of; }; }");
    ASSERT_TRUE(read.model);
    EXPECT_EQ(read.field("of").type.cpp, "::n::Of<::n::Some<void>, ::n::Axis::y>");
    EXPECT_EQ(read.field("of").type.name, "/n/Of</n/Some</void>,/n/Axis/y>");
}

TEST(TypeReader, LeavesTheNamespacesOfOneStandardLibraryOut) {
    const Read read(
        "#include <chrono>\n#include <string>\nnamespace n { template <class T> struct Of { int i; };\nstruct S { "
        "Of<std::string> text; std::chrono::system_clock::time_point when; }; }");
    ASSERT_TRUE(read.model);
    EXPECT_EQ(read.field("text").type.name,
              "/n/Of</std/basic_string</char,/std/char_traits</char>,/std/allocator</char>>>");
    EXPECT_EQ(read.field("when").declared,
              "std::chrono::time_point<::std::chrono::system_clock, std::chrono::duration<long, std::ratio<1, "
              "1000000000>>>");
}

TEST(TypeReader, KeepsTheComparisonOfAnything) {
    const Read read("#include <map>\n#include <string>\nstruct A { std::map<std::string, int, std::less<>> m; };");
    ASSERT_TRUE(read.model);
    EXPECT_NE(read.field("m").type.cpp.find("::std::less<void>"), std::string::npos) << read.field("m").type.cpp;
}

TEST(TypeReader, DoesNotTakeTheCharacterOfCpp20ForAnExtension) {
    const Read read("struct A { char8_t c; };", "types.hpp", {"-std=c++20"});
    EXPECT_EQ(read.onlyCode(), "TK050");
}

TEST(TypeReader, KnowsTheQuestionAsAnAccessorOfABool) {
    const Read read(
        "class A { bool ready_; bool on; public: bool isReady() const; void setReady(bool); bool is_on() const; "
        "void set_on(bool); };");
    ASSERT_TRUE(read.model);
    EXPECT_EQ(read.field("ready").access.get, "isReady");
    EXPECT_EQ(read.field("on").access.set, "set_on");
    EXPECT_FALSE(Read("class A { int n_; public: int isN() const; void setN(int); };").model);
}

TEST(TypeReader, DoesNotStoreByMoving) {
    const Read read(
        "#include <string>\nclass A { std::string s_; public: const std::string& s() const; void setS(std::string&&); "
        "};");
    EXPECT_EQ(read.onlyCode(), "TK013");
}

TEST(TypeReader, RefusesElementsThatAreMadeOfCArrays) {
    const Read read("#include <array>\n#include <vector>\nstruct A { std::vector<std::array<int[2], 3>> v; };");
    EXPECT_EQ(read.onlyCode(), "TK047");
    const Read inner(
        "#include <array>\n#include <list>\nstruct A { std::list<std::array<std::array<int[2], 3>, 2>> v; };");
    EXPECT_EQ(inner.onlyCode(), "TK047");
}

TEST(TypeReader, LocatesInTheHeaderAsNamed) {
    const Read read("#pragma once\n  struct A {\n    int* p; };");
    ASSERT_EQ(read.sink.all().size(), 1U);
    EXPECT_EQ(read.sink.all()[0].where, (diag::Location{(read.dir / "types.hpp").string(), 3, 10}));
}

TEST(TypeReader, TakesHeadersWithByteOrderMarkAndCarriageReturns) {
    const Read read("\xEF\xBB\xBF#pragma once\r\n/// doc\r\nstruct A { int x; };\r\n");
    ASSERT_TRUE(read.model);
    EXPECT_EQ(read.model->structs[0].doc, "doc");
}

TEST(TypeReader, TakesFoldersWithBlanksAndUmlauts) {
    const Read read("struct A { int x; };", "mit Lücke/ein Typ.hpp");
    ASSERT_TRUE(read.model);
    EXPECT_EQ(read.model->structs.size(), 1U);
}

TEST(TypeReader, DefinesTheMacrosOfTheOriginal) {
    const Read read(
        "#if defined(__orogen) && defined(__orogen2) && defined(OROCOS_TARGET)\nstruct Seen { int x; };\n#endif");
    ASSERT_TRUE(read.model);
    EXPECT_EQ(read.model->structs.size(), 1U);
}

TEST(TypeReader, HonoursTheStandard) {
    const std::string text =
        "#if __cplusplus == 201703L\nstruct Default { int x; };\n#else\nstruct Other { int x; };\n#endif";
    EXPECT_EQ(Read(text).model.value().structs[0].name, "/Default");
    EXPECT_EQ(Read(text, "types.hpp", {"-std=c++20"}).model.value().structs[0].name, "/Other");
    EXPECT_FALSE(Read(text, "types.hpp", {"-std=klingon"}).model);
}

TEST(TypeReader, SkipsFunctionBodiesButNotConstantExpressions) {
    const Read read(
        "constexpr int size() { return 3; }\n"
        "struct A { int v[size()]; int bad() { return noSuchFunction(); } };");
    ASSERT_TRUE(read.model);
    EXPECT_EQ(read.field("v").count, 3U);
}

TEST(TypeReader, ListsEveryFileThatWasRead) {
    const TempDir dir;
    const auto inner = dir.write("inner.hpp", "#pragma once\nstruct Inner { int x; };").string();
    const auto outer = dir.write("outer.hpp", "#include \"inner.hpp\"\nstruct Outer { Inner i; };").string();
    cxx::ParseRequest request;
    request.headers = {{outer, "outer.hpp"}};
    diag::Sink sink;
    const auto model = cxx::readTypes(request, sink);
    ASSERT_TRUE(model);
    EXPECT_NE(std::find(model->files.begin(), model->files.end(), inner), model->files.end());
    EXPECT_NE(std::find(model->files.begin(), model->files.end(), outer), model->files.end());
}

TEST(TypeReader, AcceptsAStandardStringInAnySpelling) {
    const Read read("#include <string>\nusing Text = std::string;\nstruct A { Text t; std::basic_string<char> s; };");
    ASSERT_TRUE(read.model);
    EXPECT_EQ(read.field("t").type.cpp, "std::string");
    EXPECT_EQ(read.field("s").type.kind, model::TypeKind::String);
}

TEST(TypeReader, RefusesAllocatorsOfOnesOwn) {
    EXPECT_EQ(Read("#include <string>\ntemplate <class T> struct A : std::allocator<T> {};\n"
                   "struct S { std::basic_string<char, std::char_traits<char>, A<char>> s; };")
                  .onlyCode(),
              "TK034");
}

TEST(TypeReader, MissingCompilerHeadersAreExplained) {
    ::setenv("TYPEGEN_RESOURCE_DIR", "/no/such/folder", 1);
    const Read read("struct A { int x; };");
    ::unsetenv("TYPEGEN_RESOURCE_DIR");
    EXPECT_EQ(read.onlyCode(), "TK005");
    ASSERT_FALSE(read.sink.all()[0].notes.empty());
    EXPECT_NE(read.sink.all()[0].notes[0].message.find("libclang-common-19-dev"), std::string::npos);
}
