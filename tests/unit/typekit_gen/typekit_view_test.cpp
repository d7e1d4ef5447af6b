// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/cpp_words.hpp>
#include <plan/typekit_view.hpp>

#include <gtest/gtest.h>

using namespace oroforge;

TEST(CppString, QuotesWhatCppWouldMisread) {
    EXPECT_EQ(typekit::cppString("a\"b\\c\nd"), R"("a\"b\\c\nd")");
    EXPECT_EQ(typekit::cppString(std::string("\x01"
                                             "7\t",
                                             3)),
              R"("\0017\011")");
    EXPECT_EQ(typekit::cppString("ä"), "\"ä\"");
}

TEST(CppIdentifier, ReplacesWhatCppForbids) {
    EXPECT_EQ(typekit::cppIdentifier("my-pkg.v2"), "my_pkg_v2");
    EXPECT_EQ(typekit::cppIdentifier("1st"), "_1st");
}

TEST(TypekitView, PutsATypeAndItsInstancesIntoOneSource) {
    model::TypeModel model;
    model.headers = {{"demo/point.hpp", "demo/point.hpp"}};
    model::Struct type;
    type.cpp = "::demo::Point";
    type.name = "/demo/Point";
    model.structs = {type};
    const auto view = typekit::makeView(model, "demo");
    const auto& source = view["sources"][0];
    EXPECT_EQ(source["word"], "point");
    EXPECT_EQ(source["structs"].size(), 1U);
    EXPECT_EQ(source["instances"][0]["cpp"], "::demo::Point");
    EXPECT_EQ(view["externs"].size(), 1U);
    EXPECT_FALSE(source["structs"][0].contains("hasFields"));
}

namespace {

const model::TypeUse kNumber{model::TypeKind::Scalar, "double", "/double", {}, ""};
const model::TypeUse kPoint{model::TypeKind::Struct, "::P", "/P", {}, ""};

model::TypeModel twoSequences() {
    model::TypeModel model;
    model.headers = {{"p.hpp", "p.hpp"}};
    model.library = {{model::TypeKind::Sequence, "std::vector<double>", "/std/vector</double>", {kNumber}, ""},
                     {model::TypeKind::Sequence, "std::vector<::P>", "/std/vector</P>", {kPoint}, ""}};
    return model;
}

}  // namespace

TEST(TypekitView, LeavesSequencesOfNumbersToTheRuntime) {
    model::TypeModel model = twoSequences();
    model.aliases = {{"/Numbers", "/std/vector</double>", {}}, {"/Points", "/std/vector</P>", {}}};
    const auto view = typekit::makeView(model, "demo");
    ASSERT_EQ(view["externs"].size(), 1U);
    EXPECT_EQ(view["externs"][0]["cpp"], "std::vector<::P>");
}

TEST(TypekitView, HasNoInstancesOfContainersWithoutAName) {
    const auto view = typekit::makeView(twoSequences(), "demo");
    EXPECT_EQ(view["externs"].size(), 0U);
    EXPECT_EQ(view["sources"][0]["library"].size(), 2U);
}
