// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/cpp_words.hpp>
#include <plan/typekit_view.hpp>

#include <gtest/gtest.h>

#include <plan/buckets.hpp>

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

TEST(TypekitView, PutsATypeAndItsInstancesIntoOneBucket) {
    model::TypeModel model;
    model::Struct type;
    type.cpp = "::demo::Point";
    type.name = "/demo/Point";
    model.structs = {type};
    const auto view = typekit::makeView(model, "demo");
    const auto& bucket = view["buckets"][typekit::bucketOf("/demo/Point")];
    EXPECT_EQ(bucket["structs"].size(), 1U);
    EXPECT_EQ(bucket["instances"][0]["cpp"], "::demo::Point");
    EXPECT_EQ(view["externs"].size(), 1U);
    EXPECT_FALSE(bucket["structs"][0].contains("hasFields"));
}

namespace {

const model::TypeUse kNumber{model::TypeKind::Scalar, "double", "/double", {}, ""};
const model::TypeUse kPoint{model::TypeKind::Struct, "::P", "/P", {}, ""};

model::TypeModel twoSequences() {
    model::TypeModel model;
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
    EXPECT_EQ(view["buckets"][typekit::bucketOf("/std/vector</P>")]["library"].size(), 1U);
}
