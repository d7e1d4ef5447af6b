// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Which headers another one needs before it, and what a generated file includes.
#include <clang/types/type_reader.hpp>
#include <collect/close_model.hpp>
#include <plan/type_needs.hpp>

#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

using namespace oroforge;
using Numbers = std::vector<std::size_t>;

namespace {

/// Headers 0.hpp, 1.hpp … in this order.
struct Read {
    test::TempDir dir;
    diag::Sink sink;
    model::TypeModel model;

    explicit Read(const std::vector<std::string>& texts, const std::string& other = "") {
        cxx::ParseRequest request;
        dir.write("other.hpp", "#pragma once\n" + other);
        for (const std::string& text : texts) {
            const std::string name = std::to_string(request.headers.size()) + ".hpp";
            request.headers.push_back({dir.write(name, "#pragma once\n" + text).string(), name});
        }
        model = cxx::readTypes(request, sink).value();
        typekit::closeModel(model, sink);
    }
    Numbers before(std::size_t header) const { return model.headers[header].before; }
    Numbers neededBy(const std::string& type) const { return typekit::TypeNeeds(model).of({type}).headers; }
};

const std::string kPoint = "struct Point { int x; };\n";

}  // namespace

TEST(HeaderNeeds, NothingIfItIncludesWhatItUses) {
    const Read read({kPoint, "#include \"0.hpp\"\nstruct Way { Point from; };"});
    EXPECT_EQ(read.before(1), Numbers());
    EXPECT_EQ(read.neededBy("/Point"), Numbers{0});
    EXPECT_EQ(read.neededBy("/Way"), Numbers{1});
}

TEST(HeaderNeeds, TheHeaderWithATypeThatItOnlyNames) {
    const Read read({"struct Alone { int y; };", kPoint, "struct Way { Point from; };"});
    EXPECT_EQ(read.before(2), Numbers{1});
    EXPECT_EQ(read.neededBy("/Way"), (Numbers{1, 2}));
    EXPECT_EQ(read.neededBy("/Alone"), Numbers{0});
}

TEST(HeaderNeeds, WhatBodiesOfFunctionsUse) {
    const Read read({"inline int twice(int x) { return 2 * x; }",
                     "struct Level { int value; int doubled() const { return twice(value); } };"});
    EXPECT_EQ(read.before(1), Numbers{0});
}

TEST(HeaderNeeds, MacrosAndWhatTheyAreAskedFor) {
    const Read read({"#define SIZE 3\n", "struct Unrelated { int SIZED; };", "struct A { int m[SIZE]; };",
                     "#ifdef SIZE\nstruct B { int b; };\n#endif\n"});
    EXPECT_EQ(read.before(1), Numbers());
    EXPECT_EQ(read.before(2), Numbers{0});
    EXPECT_EQ(read.before(3), Numbers{0});
}

TEST(HeaderNeeds, ADirectiveChangesWhatAllLaterNamesMean) {
    const Read read({"#include <string>\nusing namespace std;", "#include <string>\nstruct A { string text; };"});
    EXPECT_EQ(read.before(1), Numbers{0});
}

TEST(HeaderNeeds, HeadersOfTheSystemThatOthersBring) {
    const Read read({"#include <vector>\n" + kPoint, "struct A { std::vector<int> all; };"});
    EXPECT_EQ(read.before(1), Numbers{0});
}

TEST(HeaderNeeds, NamesOfMembersAreNoNeeds) {
    const Read read({"struct Point { int x; };\nstruct size { int s; };", "struct A { int Point; int size; };"});
    EXPECT_EQ(read.before(1), Numbers());
}

TEST(HeaderNeeds, AForwardDeclarationElsewhereIsNone) {
    const Read read({"struct Late;\nstruct A { int a; };", "struct Late { int n; };\nstruct B { Late late; };"});
    EXPECT_EQ(read.before(1), Numbers());
}

TEST(HeaderNeeds, AnyHeaderThatBringsAnUnlistedOneWillDo) {
    const Read read(
        {"#include \"other.hpp\"\nstruct A { Other o; };", "#include \"other.hpp\"\nstruct B { Other o; };"},
        "struct Other { int n; };");
    EXPECT_EQ(read.neededBy("/Other"), Numbers{0});
    EXPECT_EQ(read.neededBy("/B"), Numbers{1});
}

TEST(HeaderNeeds, AHeaderComesBeforeThoseThatIncludeIt) {
    const Read read({"#include \"1.hpp\"\nstruct Way { Point from; };", kPoint});
    EXPECT_EQ(read.neededBy("/Point"), Numbers{1});
}

TEST(HeaderNeeds, AVectorComesWithAStructThatHasOne) {
    const Read read({kPoint, "#include \"0.hpp\"\n#include <deque>\nstruct Way { std::deque<Point> all; };"});
    EXPECT_EQ(read.neededBy("/std/deque</Point>"), Numbers{1});
}

TEST(HeaderNeeds, ATemplateBringsTheHeadersOfItsArguments) {
    const Read read({"template <class T> struct Box { int n; };", "struct Tag { int t; };",
                     "#include \"0.hpp\"\n#include \"1.hpp\"\nusing Tagged = Box<Tag>;"});
    EXPECT_EQ(read.neededBy("/Tagged"), (Numbers{0, 1}));
}
