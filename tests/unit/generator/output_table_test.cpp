// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <render/output_table.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace oroforge::render {
namespace {

using nlohmann::json;

const OutputTable kTable = {{"class", Owner::Generated, "{package}/{class}Base.hpp", "base"},
                            {"class", Owner::User, "src/{class}.hpp", "user"},
                            {"package", Owner::Generated, "all.cpp", "base"}};

Subject aboutClass(const std::string& name) {
    return {"class", {{"package", "tank"}, {"class", name}}, [name] { return json{{"name", name}}; }};
}

TEST(OutputTable, TellsNamesWithoutRendering) {
    const std::vector<Subject> subjects = {{"class", {{"package", "tank"}, {"class", "{class}"}}, nullptr},
                                           {"package", {}, nullptr}};
    EXPECT_EQ(outputNames(kTable, subjects, Owner::Generated),
              (std::vector<std::string>{"tank/{class}Base.hpp", "all.cpp"}));
    EXPECT_TRUE(outputNames(kTable, subjects, Owner::Shared).empty());
}

TEST(OutputTable, RendersTheFilesOfOneOwner) {
    Templates templates;
    templates.add("base", "base of {{name}}");
    templates.add("user", "class {{name}}");
    const Renderer renderer(templates);
    const std::vector<Subject> subjects = {aboutClass("A"), aboutClass("B")};
    EXPECT_EQ(renderOutputs(kTable, subjects, Owner::Generated, renderer),
              (std::map<std::string, std::string>{{"tank/ABase.hpp", "base of A"}, {"tank/BBase.hpp", "base of B"}}));
    EXPECT_EQ(renderOutputs(kTable, subjects, Owner::User, renderer).at("src/B.hpp"), "class B");
}

}  // namespace
}  // namespace oroforge::render
