// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/typekit_files.hpp>

#include <set>

#include <gtest/gtest.h>

#include <plan/sources.hpp>
#include <plan/type_needs.hpp>

using namespace oroforge;
using namespace oroforge::typekit;
using Names = std::vector<std::string>;

namespace {

model::Header header(const std::string& include, std::size_t pieces = 1) {
    model::Header result{"/some/where/" + include, include};
    result.pieces = pieces;
    return result;
}

model::Struct type(const std::string& name, const model::Homes& homes = {}) {
    model::Struct result;
    result.cpp = "::" + name;
    result.name = "/" + name;
    result.homes = homes;
    return result;
}

/// Names of the files with types.
Names sourcesFor(const std::vector<model::Header>& headers) {
    Names names = outputNames("demo", headers);
    EXPECT_EQ(names.front(), "Plugin.cpp");
    EXPECT_EQ(names.back(), "types/demo/typekit/Types.hpp");
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    return {names.begin() + 1, names.end() - 1};
}

Names sourcesFor(const Names& includes) {
    std::vector<model::Header> headers;
    for (const std::string& include : includes) headers.push_back(header(include));
    return sourcesFor(headers);
}

}  // namespace

TEST(OutputNames, AreThoseOfTheHeaders) {
    EXPECT_EQ(sourcesFor(Names{"demo/tank.hpp", "demo/pump.hpp"}), (Names{"types_tank.cpp", "types_pump.cpp"}));
    EXPECT_EQ(sourcesFor(Names{"demo/two words.hpp", "demo/Größe.h", "demo/2d.v1.hh", "none"}),
              (Names{"types_two_words.cpp", "types_Gr____e.cpp", "types_2d_v1.cpp", "types_none.cpp"}));
}

TEST(OutputNames, TakeInFoldersWhereHeadersAreCalledTheSame) {
    EXPECT_EQ(sourcesFor(Names{"a/tank.hpp", "b/tank.hpp", "a/pump.hpp"}),
              (Names{"types_a_tank.cpp", "types_b_tank.cpp", "types_pump.cpp"}));
    EXPECT_EQ(sourcesFor(Names{"demo/tank.hpp", "demo/in/tank.hpp", "demo/out/tank.hpp"}),
              (Names{"types_demo_tank.cpp", "types_in_tank.cpp", "types_out_tank.cpp"}));
    EXPECT_EQ(sourcesFor(Names{"a/x/tank.hpp", "b/x/tank.hpp"}), (Names{"types_a_x_tank.cpp", "types_b_x_tank.cpp"}));
}

TEST(OutputNames, TakeInTheExtensionAndThenANumber) {
    EXPECT_EQ(sourcesFor(Names{"demo/tank.h", "demo/tank.hpp"}),
              (Names{"types_demo_tank_h.cpp", "types_demo_tank_hpp.cpp"}));
    EXPECT_EQ(sourcesFor(Names{"tank a.hpp", "tank-a.hpp", "tank_a_hpp_2.hpp"}),
              (Names{"types_tank_a_hpp.cpp", "types_tank_a_hpp_2.cpp", "types_tank_a_hpp_2_2.cpp"}));
    EXPECT_EQ(sourcesFor(Names{"", ""}).size(), 2U);
}

TEST(OutputNames, OfALargeHeaderHaveNumbers) {
    EXPECT_EQ(sourcesFor({header("tank_2.hpp"), header("tank.hpp", 2)}),
              (Names{"types_tank_2.cpp", "types_tank_1.cpp", "types_tank_2_2.cpp"}));
    EXPECT_EQ(piecesFor(0), 1U);
    EXPECT_EQ(piecesFor(4095), 1U);
    EXPECT_EQ(piecesFor(80000), 20U);
}

TEST(OutputNames, AreNoLongerThanAFileSystemAllows) {
    const std::string name(245, 'x');
    for (const std::string& file : sourcesFor(Names{"a/" + name + ".hpp", "b/" + name + ".hpp"}))
        EXPECT_LT(file.size(), 200U);
}

TEST(OutputNames, AreFoundForHundredsOfHeaders) {
    Names includes;
    for (int i = 0; i < 900; ++i)
        includes.push_back("f" + std::to_string(i / 30) + "/h" + std::to_string(i % 30) + ".hpp");
    EXPECT_EQ(sourcesFor(includes)[899], "types_f29_h29.cpp");
}

TEST(Placement, DealsOutTypesOfAHeaderEvenlyAndInOrder) {
    model::TypeModel model;
    model.headers = {header("demo/tank.hpp", 3)};
    for (int i = 0; i < 9; ++i) model.structs.push_back(type("T" + std::to_string(i)));
    const TypeNeeds needs(model);
    const Placement placement(model, needs);
    for (const model::Struct& type : model.structs)
        EXPECT_EQ(placement.of(type.name), static_cast<std::size_t>(type.name[2] - '0') / 3) << type.name;
}

TEST(Placement, PutsATypeToTheHeaderThatBringsAllOfIt) {
    model::TypeModel model;
    model.headers = {header("box.hpp"), header("point.hpp"), header("scene.hpp")};
    model.structs = {type("Box", {{0, 2}, {1, 2}}), type("Point", {{1, 2}}), type("Odd", {{2}, {1}})};
    const TypeNeeds needs(model);
    const Placement placement(model, needs);
    EXPECT_EQ(placement.of("/Box"), 2U);
    EXPECT_EQ(placement.of("/Point"), 1U);
    EXPECT_EQ(placement.of("/Odd"), 2U);
    EXPECT_EQ(placement.of("/unknown"), 0U);
}

TEST(Placement, PutsATypeOfTheLibraryToItsFirstUser) {
    const model::TypeUse number{model::TypeKind::Scalar, "double", "/double", {}, ""};
    const model::TypeUse row{model::TypeKind::Sequence, "std::vector<double>", "/std/vector</double>", {number}, ""};
    model::TypeModel model;
    model.headers = {header("a.hpp"), header("b.hpp"), header("c.hpp")};
    model.structs = {type("A", {{0}}), type("C", {{2}}), type("B", {{1}})};
    for (const std::size_t i : {1U, 2U}) {
        model.structs[i].fields.resize(1);
        model.structs[i].fields[0].type = row;
    }
    model.library = {row};
    const TypeNeeds needs(model);
    const Placement placement(model, needs);
    EXPECT_EQ(placement.of(row.name), 1U);
}
