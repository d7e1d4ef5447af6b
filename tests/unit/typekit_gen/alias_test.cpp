// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Which aliases in headers are names of types.
#include <clang/types/type_reader.hpp>
#include <collect/close_model.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

using namespace oroforge;

namespace {

struct Names {
    test::TempDir dir;
    diag::Sink sink;
    model::TypeModel model;
    std::string shown;  ///< "/n/T=/n/S " and so on

    explicit Names(const std::vector<std::string>& headers, const std::string& unlisted = "") {
        cxx::ParseRequest request;
        dir.write("unlisted.hpp", "#pragma once\n" + unlisted);
        for (const std::string& text : headers) {
            const std::string name = "h" + std::to_string(request.headers.size()) + ".hpp";
            request.headers.push_back({dir.write(name, "#pragma once\n" + text).string(), name});
        }
        if (auto read = cxx::readTypes(request, sink)) model = *read;
        typekit::closeModel(model, sink);
        for (const model::Alias& alias : model.aliases) shown += alias.name + "=" + alias.of + " ";
    }
};

}  // namespace

TEST(Alias, OfOwnStructsAndEnumsIsAName) {
    const Names names(
        {"namespace n { struct S { int i; }; typedef S T; using U = S; enum class E { a }; using F = E; }\n"
         "namespace m { namespace o { typedef n::S V; } }\n"});
    EXPECT_EQ(names.shown, "/n/T=/n/S /n/U=/n/S /n/F=/n/E /m/o/V=/n/S ");
    EXPECT_TRUE(names.sink.empty());
}

TEST(Alias, OfAnAliasIsANameOfTheType) {
    const Names names({"struct S { int i; };\ntypedef S T;\nusing U = T;\n"});
    EXPECT_EQ(names.shown, "/T=/S /U=/S ");
}

TEST(Alias, InCStyleIsANameUnlessItIsTheSame) {
    const Names names(
        {"typedef struct { int i; } A, Other;\ntypedef struct B { int i; } B;\n"
         "typedef struct c_tag { int i; } C, *Pointer, Array[3];\nstruct D;\ntypedef struct D D_t;\n"
         "struct D { int i; };\ntypedef enum { left } Side, Hand;\n"});
    EXPECT_EQ(names.shown, "/Other=/A /C=/c_tag /D_t=/D /Hand=/Side ");
    EXPECT_TRUE(names.sink.empty());
}

TEST(Alias, InTwoHeadersIsOneName) {
    const Names names({"struct S { int i; };\ntypedef S T;\n", "#include \"h0.hpp\"\ntypedef S T;\ntypedef S U;\n"});
    EXPECT_EQ(names.shown, "/T=/S /U=/S ");
    EXPECT_TRUE(names.sink.empty());
}

TEST(Alias, InAClassIsANameIfItIsPublic) {
    const Names names(
        {"struct S { int i; };\nclass C { typedef S Mine; struct Hidden { int h; };\n"
         "public: using Item = S; using Shown = Hidden; using Self = C; int i; };\n"
         "template <class T> struct P { using Value = S; T t; };\ntemplate struct P<int>;\n"});
    EXPECT_EQ(names.shown, "/C/Item=/S /C/Self=/C ");
}

TEST(Alias, OfOthersIsNoName) {
    const Names names(
        {"#include \"unlisted.hpp\"\n#include <string>\n#include <vector>\nstruct S { int i; lib::L l; };\n"
         "typedef lib::L L;\ntypedef std::string Text;\ntypedef std::vector<S> All;\ntypedef int Number;\n"
         "template <class T> using Always = S;\ntypedef const S Fixed;\nstruct Never;\ntypedef Never N;\n"
         "struct [[oro::skip]] Skipped { int i; };\ntypedef Skipped K;\n"},
        "namespace lib { struct L { int i; }; }\nstruct S;\ntypedef S FromThere;\n");
    EXPECT_EQ(names.shown, "");
    EXPECT_TRUE(names.sink.empty());
}

TEST(Alias, OfALeftOutClassSaysNothing) {
    const Names names({"struct S { int i; };\nstruct V { virtual void f(); };\ntypedef V W;\n"});
    EXPECT_EQ(names.shown, "");
    EXPECT_EQ(names.sink.all().size(), 1U);
}

TEST(Alias, IsNotPreferredBesideThoseOfInstances) {
    const Names names(
        {"template <int N> struct P { int v[N]; };\nusing P3 = P<3>;\nstruct S { P<3> p; };\ntypedef S T;\n"});
    EXPECT_EQ(names.shown, "/P<3>=/P3 /T=/S ");
    ASSERT_EQ(names.model.structs.size(), 2U);
    EXPECT_EQ(names.model.structs[1].name, "/S");
}
