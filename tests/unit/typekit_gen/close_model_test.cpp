// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <collect/close_model.hpp>

#include <gtest/gtest.h>

using namespace oroforge;

namespace {

model::TypeUse use(model::TypeKind kind, const std::string& name) { return {kind, "cpp of " + name, name, {}}; }

model::TypeUse vectorOf(const model::TypeUse& element) {
    return {
        model::TypeKind::Sequence, "std::vector<" + element.cpp + ">", "/std/vector<" + element.name + ">", {element}};
}

model::Struct makeStruct(const std::string& name, std::vector<model::Field> fields = {}) {
    model::Struct type;
    type.name = name;
    type.cpp = "cpp of " + name;
    type.fields = std::move(fields);
    return type;
}

model::Field makeField(const model::TypeUse& type, std::uint64_t count = 0) {
    model::Field field;
    field.type = type;
    field.count = count;
    return field;
}

std::vector<std::string> namesOf(const std::vector<model::TypeUse>& all) {
    std::vector<std::string> names;
    for (const auto& one : all) names.push_back(one.name);
    return names;
}

}  // namespace

TEST(CloseModel, FindsInnerSequencesOnce) {
    const auto rows = vectorOf(vectorOf(use(model::TypeKind::Scalar, "/double")));
    model::TypeModel model;
    model.structs = {makeStruct("/a", {makeField(rows), makeField(rows)})};
    diag::Sink sink;
    typekit::closeModel(model, sink);
    EXPECT_EQ(namesOf(model.library),
              (std::vector<std::string>{"/std/vector</double>", "/std/vector</std/vector</double>>"}));
    EXPECT_TRUE(model.arrays.empty());
}

TEST(CloseModel, ArraysAreKnownByTheirElements) {
    const auto number = use(model::TypeKind::Scalar, "/float");
    model::TypeModel model;
    model.structs = {makeStruct("/a", {makeField(number, 3), makeField(number, 4), makeField(vectorOf(number), 2)})};
    diag::Sink sink;
    typekit::closeModel(model, sink);
    EXPECT_EQ(namesOf(model.arrays), (std::vector<std::string>{"/float", "/std/vector</float>"}));
    EXPECT_EQ(namesOf(model.library), (std::vector<std::string>{"/std/vector</float>"}));
}

TEST(CloseModel, AnAliasNamesAnInstanceOfWhatHasAnAlias) {
    model::TypeModel model;
    model.structs = {makeStruct("/P<3>"), makeStruct("/Q</P<3>>")};
    model.aliases = {{"/P3", "/P<3>", {}}, {"/Three", "/Q</P<3>>", {}}};
    diag::Sink sink;
    typekit::closeModel(model, sink);
    EXPECT_EQ(model.structs[0].name, "/P3");
    EXPECT_EQ(model.structs[1].name, "/Three");
    EXPECT_EQ(model.aliases[1].of, "/Three");
}

TEST(CloseModel, AnAliasRenamesWholeNamesOnly) {
    model::TypeModel model;
    model.structs = {makeStruct("/a/Vec"), makeStruct("/a/Vector"), makeStruct("/b/a/Vec"), makeStruct("/R</a/Vec,2>")};
    model.aliases = {{"v", "/a/Vec", {}}};
    diag::Sink sink;
    typekit::closeModel(model, sink);
    std::vector<std::string> names;
    for (const auto& type : model.structs) names.push_back(type.name);
    EXPECT_EQ(names, (std::vector<std::string>{"/R<v,2>", "/a/Vector", "/b/a/Vec", "v"}));
}

TEST(CloseModel, ATypeWhoseAdapterKeepsItsNameIsNotCalledByAnAlias) {
    model::TypeModel model;
    model.structs = {makeStruct("/lib/Frame")};
    model.aliases = {{"/lib/Frame", "/lib/Frame", {}}, {"/demo/Frame", "/lib/Frame", {}}};
    diag::Sink sink;
    typekit::closeModel(model, sink);
    EXPECT_EQ(model.structs[0].name, "/lib/Frame");
    ASSERT_EQ(model.aliases.size(), 1U);
    EXPECT_EQ(model.aliases[0].name, "/demo/Frame");
    EXPECT_EQ(sink.all().size(), 0U);
}

TEST(CloseModel, SortsByName) {
    model::TypeModel model;
    model.structs = {makeStruct("/b"), makeStruct("/c"), makeStruct("/a")};
    diag::Sink sink;
    typekit::closeModel(model, sink);
    EXPECT_EQ(model.structs.front().name, "/a");
    EXPECT_EQ(model.structs.back().name, "/c");
    EXPECT_TRUE(sink.empty());
}

TEST(CloseModel, TwoTypesOfOneNameAreAnError) {
    model::TypeModel model;
    model.structs = {makeStruct("/a"), makeStruct("/a")};
    model.structs[0].where = {"x.hpp", 1, 1};
    model.structs[1].where = {"x.hpp", 2, 1};
    model.structs[1].cpp = "another";
    diag::Sink sink;
    typekit::closeModel(model, sink);
    ASSERT_EQ(sink.errorCount(), 1U);
    EXPECT_EQ(sink.all()[0].code, "TK060");
    EXPECT_EQ(sink.all()[0].notes.size(), 1U);
}

TEST(CloseModel, NoTypeAtAllIsAWarning) {
    model::TypeModel model;
    diag::Sink sink;
    typekit::closeModel(model, sink);
    EXPECT_FALSE(sink.hadErrors());
    ASSERT_EQ(sink.warningCount(), 1U);
    EXPECT_EQ(sink.all()[0].code, "TK061");
}
