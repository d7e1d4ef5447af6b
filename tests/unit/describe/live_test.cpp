// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What orocreate-pkg --describe reads off the source of a component is what the component has when it runs. The same
// sources are part of this program.
#include <algorithm>
#include <memory>
#include <set>

#include <rtt/Component.hpp>
#include <rtt/Service.hpp>

#include <gtest/gtest.h>
#include <manifest/reader.hpp>
#include <support/child_process.hpp>
#include <support/golden.hpp>

#include "interface_lines.hpp"

extern "C" RTT::Service::shared_ptr createService();  // of the service plugin that is part of this program

namespace oroforge::test {
namespace {

struct Case {
    std::string name;
    std::vector<std::string> files;  ///< relative to the sources, or absolute
    std::vector<std::string> flags = {};
    std::set<std::string> components;    ///< their names in the description
    std::string prefix = {};             ///< of their names in this program
    std::set<std::string> remarks = {};  ///< codes
    std::set<std::string> unknown =
        {};  ///< beginnings of lines about values of which remarks tell that they are not known
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

std::string pathOf(const std::string& file) { return file[0] == '/' ? file : (sourceRoot() / file).string(); }

Outcome describe(const Case& wanted) {
    Command command;
    command.program = OROCREATE_PKG;
    command.arguments = {"--describe", "--package", "described"};
    for (const std::string& file : wanted.files) command.arguments.push_back(pathOf(file));
    for (const std::string& folder : wanted.flags)
        command.arguments.insert(command.arguments.end(), {"-I", pathOf(folder)});
    return run(command);
}

std::set<std::string> codesIn(const std::string& text) {
    std::set<std::string> codes;
    for (std::size_t at = 0; (at = text.find("warning: [", at)) != std::string::npos; at += 10)
        codes.insert(text.substr(at + 10, 5));
    return codes;
}

Lines known(Lines lines, const Case& wanted) {
    const auto isUnknown = [&](const std::string& line) {
        return std::any_of(wanted.unknown.begin(), wanted.unknown.end(),
                           [&](const std::string& begin) { return line.compare(0, begin.size(), begin) == 0; });
    };
    lines.erase(std::remove_if(lines.begin(), lines.end(), isUnknown), lines.end());
    return lines;
}

class Describe : public testing::TestWithParam<Case> {};

TEST_P(Describe, GivesTheInterfaceOfTheRunningComponent) {
    const Case& wanted = GetParam();

    const Outcome outcome = describe(wanted);

    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(codesIn(outcome.err), wanted.remarks) << outcome.err;
    diag::Sink sink;
    const auto package = manifest::readText(outcome.out, "described.xml", sink);
    ASSERT_TRUE(package && sink.empty()) << outcome.out;
    const RTT::FactoryMap factories = RTT::ComponentFactories::all();
    std::set<std::string> seen;
    for (const model::Component& component : package->components) {
        const std::string& name = component.className.value;
        seen.insert(name);
        const auto factory = factories.find(wanted.prefix + name);
        ASSERT_NE(factory, factories.end()) << name;
        const std::unique_ptr<RTT::TaskContext> running(factory->second("it"));
        EXPECT_EQ(known(linesOf(component), wanted), known(linesOf(*running), wanted)) << name;
    }
    EXPECT_EQ(seen, wanted.components);
}

const std::string kGoldens = "tests/golden/component/";

std::vector<Case> allCases() {
    const std::vector<std::string> classic = {"tests/build/packages/classic/include",
                                              "tests/build/packages/classic/src"};
    return {
        {"Tricky", {"tests/unit/describe/components/tricky.cpp"}, {}, {"tricky::Tricky"}, "", {"OC028"}},
        {"Odd",
         {"tests/unit/describe/components/odd.cpp"},
         {},
         {"odd::Odd", "odd::Odd::Inner", "odd::Generic<double>"},
         "",
         {"OC028", "OM014", "OM022"}},
        {"Stranger",
         {"tests/unit/describe/components/stranger.cpp"},
         {},
         {"robot::Wheels", "robot::Pool", "robot::Mapped", "robot::Macros", "robot::Servo", "robot::Calls",
          "robot::Named", "robot::Helped", "robot::Configured", "robot::Mixed", "robot::Bags", "robot::Served"}},
        {"Connections", {"examples/t02_connections/connections.cpp"}, {}, {"Sum"}, "t02_connections/"},
        {"Inspection", {"examples/t04_inspection/inspection.cpp"}, {}, {"Sum"}, "t04_inspection/", {"OC022"}},
        {"Operations", {"examples/t05_operations/operations.cpp"}, {}, {"Axis", "Planner"}, "t05_operations/"},
        {"Plugins", {"examples/t06_plugins/plugins.cpp"}, {}, {"Controller"}, "t06_plugins/"},
        {"Scripts", {"examples/t07_scripts/tank.cpp"}, {}, {"filling::Tank"}},
        {"Types", {"examples/t08_types/cook.cpp"}, {"examples/t08_types/include"}, {"Cook"}},
        {"Classic", {"tests/build/packages/classic/src/classic.cpp"}, classic, {"Classic"}, "", {"OM012"}},
        {"Pair", {"tests/build/packages/classic/src/pair.cpp"}, classic, {"classic::First", "classic::Second"}},
        {"Corpus",
         {"tests/unit/scripting/corpus/components/workcell.cpp"},
         {},
         {"workcell::Producer", "workcell::Consumer", "workcell::Plant", "workcell::Controller"}},
        {"Deployer",
         {"deployer/ocl/DeploymentComponent.hpp", "deployer/deployment/deployment_interface.cpp",
          "deployer/deployment/DeploymentComponent.cpp"},
         {"deployer"},
         {"OCL::DeploymentComponent"},
         "",
         {"OC024", "OM010", "OM015", "OM035"},
         {"property RTT_COMPONENT_PATH", "attribute Valid", "constant LowestPriority", "constant HighestPriority"}},
        {"Generated",
         {kGoldens + "tank/expected/files/generated/tank/registration.cpp"},
         {kGoldens + "tank/expected/files/tank/include", kGoldens + "tank/expected/files/generated",
          kGoldens + "tank/expected/files/tank/src"},
         {"tank::Controller"}},
    };
}

/// What was generated from a manifest has the interface that the manifest promises.
class DescribeGenerated : public testing::TestWithParam<std::string> {};

TEST_P(DescribeGenerated, GivesTheManifest) {
    const auto golden = sourceRoot() / "tests/golden/component" / GetParam();
    diag::Sink sink;
    Case wanted;
    std::optional<model::Package> package;
    for (const auto& entry : std::filesystem::directory_iterator(golden)) {
        if (entry.path().extension() == ".xml") package = manifest::readFile(entry.path().string(), sink);
    }
    ASSERT_TRUE(package && sink.empty());
    if (package->components.empty()) GTEST_SKIP() << "it has no components";
    const auto files = golden / "expected/files";
    const std::string name = package->name.value;
    wanted.files = {(files / "generated" / name / "registration.cpp").string()};
    for (const auto& folder : {files / name / "src", files / "generated" / name}) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            const std::string file = entry.path().string();
            if (entry.path().extension() == ".cpp" && file != wanted.files[0]) wanted.files.push_back(file);
        }
    }
    wanted.flags = {(files / name / "include").string(), (files / "generated").string(),
                    (files / name / "src").string()};

    const Outcome outcome = describe(wanted);

    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const auto described = manifest::readText(outcome.out, "described.xml", sink);
    ASSERT_TRUE(described && sink.empty()) << outcome.out;
    ASSERT_EQ(described->components.size(), package->components.size()) << outcome.out;
    for (std::size_t i = 0; i != package->components.size(); ++i) {
        EXPECT_EQ(described->components[i].className.value, package->components[i].className.value);
        EXPECT_EQ(linesOf(described->components[i]), linesOf(package->components[i]));
    }
}

INSTANTIATE_TEST_SUITE_P(Golden, DescribeGenerated, testing::ValuesIn(goldenCases("component")), caseName);

TEST(DescribeService, GivesTheInterfaceOfTheRunningService) {
    const Case wanted = {"", {"examples/t06_plugins/tuning_service.cpp"}, {}, {}};

    const Outcome outcome = describe(wanted);

    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    diag::Sink sink;
    const auto package = manifest::readText(outcome.out, "described.xml", sink);
    ASSERT_TRUE(package && package->services.size() == 1) << outcome.out;
    EXPECT_EQ(package->services[0].className.value, "control::Tuning");
    EXPECT_EQ(linesOf(package->services[0]), linesOf(*createService()));
}

INSTANTIATE_TEST_SUITE_P(Live, Describe, testing::ValuesIn(allCases()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace oroforge::test
