// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Where components are found, files in files, and creating components: sections 2.1 to 2.3.
#include "snippets.hpp"

#include <filesystem>

namespace {

using namespace manual_test;
using namespace oroforge::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kRobot = MANUAL_ROBOT "/lib/orocos";

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

class Search : public Snippets {
protected:
    const testing::Matcher<std::string> robotOnly =
        AllOf(HasSubstr("I can create the following component types: \n   "), HasSubstr("\n   robot::Arm\n"),
              HasSubstr("\n   OCL::FileReporting\n"), Not(HasSubstr("Robot13")));
    const testing::Matcher<std::string> all =
        AllOf(HasSubstr("\n   robot::Arm\n"), HasSubstr("   Robot13::Controller\n   Robot13::Diagnostics\n"));
};

TEST_F(Search, PathImportsTheDirectoryItsPluginsAndTypesWithoutRecursing) {
    expectAtPrompt({}, {{"path(" + quoted(kRobot) + ")", kVoid},
                        {"displayComponentTypes()", robotOnly},
                        {".services", AllOf(HasSubstr("armservice"), Not(HasSubstr("robot13service")))},
                        {".types", AllOf(HasSubstr("ArmReach"), Not(HasSubstr("Robot13Reach")))}});
}

TEST_F(Search, ImportFindsASubdirectoryOfThePath) {
    expectAtPrompt({}, {{"path(" + quoted(kRobot) + ")", kVoid},
                        {"import(\"robot-13\")", kTrue},
                        {"displayComponentTypes()", all},
                        {".services", HasSubstr("robot13service")},
                        {".types", HasSubstr("Robot13Reach")},
                        {"import(\"robot-13\")", kTrue}});
}

TEST_F(Search, PathIsGivenSeveralTimesOrAsAListWithColonsOrSemicolons) {
    for (const std::string separator : {":", ";", "\")\npath(\""})
        atPrompt({}, {{"path(" + quoted("/nowhere" + separator + kRobot + "/robot-13" + separator + kRobot) + ")",
                       testing::EndsWith(kVoid)},
                      {"displayComponentTypes()", all}});
}

TEST_F(Search, PathAndImportStandInFilesWithCapitals) {
    writeXml("app.xml", simple("Path", "string", kRobot) + import("robot-13") +
                            bag("diagnostics", "Robot13::Diagnostics", "") + bag("arm", "robot::Arm", ""));
    expectAtPrompt({"-s", "app.xml"}, {{"displayComponentTypes()", all},
                                       {"diagnostics.isConfigured()", kTrue},
                                       {"loadService(\"arm\", \"armservice\")", kTrue},
                                       {"arm.armservice.owner()", " = \"arm\"\n"}});
}

TEST_F(Search, PathInAFileMayBeAList) {
    for (const std::string separator : {":", ";"}) {
        writeXml("app.xml", simple("Path", "string", kRobot + separator + kRobot + "/robot-13") +
                                bag("diagnostics", "Robot13::Diagnostics", "") + bag("arm", "robot::Arm", ""));
        expectAtPrompt({"-s", "app.xml"}, {{"displayComponentTypes()", all}});
    }
}

TEST_F(Search, ImportLoadsAFileThatExistsDirectly) {
    expectAtPrompt({}, {{"import(" + quoted(ROBOT_ARM_FILE) + ")", kTrue}, {"displayComponentTypes()", robotOnly}});
    writeXml("app.xml", import(ROBOT_ARM_FILE) + bag("arm", "robot::Arm", ""));
    expectAtPrompt({"-s", "app.xml"}, {{"displayComponentTypes()", robotOnly}});
}

TEST_F(Search, LibrariesMayHaveAnyNameThatEndsInSo) {
    std::filesystem::create_directory(directory_ / "libraries");
    std::filesystem::copy_file(ROBOT_ARM_FILE, directory_ / "libraries/orocos-helloworld.so");
    expectAtPrompt({}, {{"path(\"libraries\")", kVoid}, {"loadComponent(\"arm\", \"robot::Arm\")", kTrue}});
    expectAtPrompt({}, {{"import(\"libraries/orocos-helloworld.so\")", kTrue}, {"displayComponentTypes()", robotOnly}});
    expectAtPrompt({}, {{"loadComponent(\"arm\", \"libraries/orocos-helloworld.so\")", kTrue}});
}

TEST_F(Search, RegularLibrariesCannotBeLoaded) {
    const Outcome outcome = atPrompt({}, {{"import(\"" REGULAR_LIBRARY "\")", kFalse}});
    EXPECT_THAT(outcome.err, HasSubstr(REGULAR_LIBRARY));
    EXPECT_THAT(outcome.err, HasSubstr("put ORO_CREATE_COMPONENT"));
}

TEST_F(Search, TheInstalledComponentsDirectoryCanBeImported) {
    writeXml("app.xml", import(BUILT_COMPONENTS) + bag("Reporter", "OCL::FileReporting", ""));
    EXPECT_EQ(0, rttscript({"-s", "app.xml"}).status);
}

/** In a workspace with two ROS packages; the first depends on the second. */
TEST_F(Search, RosPackagesAreFoundWithRosPackagePathOnly) {
    const auto package = [this](const std::string& name, const std::string& depends, const std::string& libraries) {
        directory_.write("ws/" + name + "/package.xml",
                         "<package format=\"2\"><name>" + name + "</name>" + depends + "</package>\n");
        std::filesystem::create_directories(directory_ / ("ws/" + name + "/lib"));
        std::filesystem::create_directory_symlink(libraries, directory_ / ("ws/" + name + "/lib/orocos"));
    };
    package("robot_driver", "<depend>robot_parts</depend>", kRobot + "/robot-13");
    package("robot_parts", "", kRobot);
    environment_["ROS_PACKAGE_PATH"] = (directory_ / "ws").string();
    environment_["RTT_COMPONENT_PATH"] = "";
    expectAtPrompt({}, {{"import(\"robot_driver\")", kTrue}, {"displayComponentTypes()", all}});
    writeXml("app.xml", import("robot_driver") + bag("arm", "robot::Arm", ""));
    const Outcome outcome = rttscript({"-s", "app.xml"});
    EXPECT_EQ(0, outcome.status) << outcome.err;
}

TEST_F(Search, IncludedFilesStandForTheirContentAtAnyPlace) {
    writeXml("default-imports.xml", import("line"));
    writeXml("default-components.xml", simple("Include", "string", "more.xml") +
                                           bag("second", "line::Worker", simple("AutoConf", "boolean", "1")));
    writeXml("more.xml", bag("first", "line::Worker", simple("AutoConf", "boolean", "1")));
    writeXml("app.xml", simple("Include", "string", "default-imports.xml") +
                            bag("zero", "line::Worker", simple("AutoConf", "boolean", "1")) +
                            simple("Include", "string", "default-components.xml") +
                            bag("third", "line::Worker", simple("AutoConf", "boolean", "1")));
    const Outcome outcome = rttscript({"-s", "app.xml"});
    EXPECT_EQ(0, outcome.status) << outcome.err;
    const std::string text = " configured with speed 1, label ''\n";
    EXPECT_THAT(outcome.out, HasSubstr("zero:" + text + "first:" + text + "second:" + text + "third:" + text));
}

TEST_F(Search, ComponentsBecomePeersOfTheDeployer) {
    expectAtPrompt({}, {{"loadComponent(\"Reporter\", \"OCL::FileReporting\")", kTrue},
                        {"peers", HasSubstr("Reporter")},
                        {"Reporter.ReportFile", " = \"reports.dat\"\n"},
                        {"loadComponent(\"Another\", \"OCL::FileReporting\")", kTrue}});
    writeXml("app.xml", import("ocl") + bag("Reporter", "OCL::FileReporting", ""));
    expectAtPrompt({"-s", "app.xml"}, {{"Reporter.ReportFile", " = \"reports.dat\"\n"}});
}

TEST_F(Search, TypesAreNamedWithTheirNamespaceAndImportedBefore) {
    const Outcome outcome = atPrompt({}, {{"loadComponent(\"w\", \"line::Worker\")", kFalse},
                                          {"import(\"line\")", kTrue},
                                          {"loadComponent(\"w\", \"Worker\")", kFalse}});
    EXPECT_THAT(outcome.err,
                HasSubstr("unknown component type 'line::Worker'; import the package that has it first\n"));
    EXPECT_THAT(outcome.err, HasSubstr("unknown component type 'Worker'; did you mean 'line::Worker'?\n"));
}

TEST_F(Search, ALibraryFileWithOneComponentStandsForItsType) {
    writeXml("app.xml", bag("left", ROBOT_ARM_FILE, ""));
    expectAtPrompt({"-s", "app.xml"}, {{"loadComponent(\"right\", " + quoted(ROBOT_ARM_FILE) + ")", kTrue},
                                       {"left.isConfigured() && right.isConfigured()", kTrue}});
}

TEST_F(Search, AFileIsDeployedInThreeStepsOrInOneAndSoIsAScript) {
    writeXml("app.xml", import("line") + bag("w", "line::Worker",
                                             simple("AutoConf", "boolean", "1") + simple("AutoStart", "boolean", "1")));
    directory_.write("app.ops", "import(\"line\")\nloadComponent(\"w\", \"line::Worker\")\nw.configure()\nw.start()\n");
    const std::string configured = "w: configured with speed 1, label ''\n", started = "w: started after 0 cycles\n";
    expectAtPrompt({}, {{"loadComponents(\"app.xml\")", kTrue},
                        {"configureComponents()", configured + kTrue},
                        {"startComponents()", started + kTrue},
                        {"kickOutAll()", "w: cleaned up\n" + kTrue},
                        {"kickStart(\"app.xml\")", configured + started + kTrue},
                        {"kickOutAll()", "w: cleaned up\n" + kTrue},
                        {"runScript(\"app.ops\")", configured + started + kTrue}});
}

}  // namespace
