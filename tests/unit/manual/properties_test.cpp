// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Properties, their files, and scripts in components: sections 2.4.5 and 2.4.7.
#include "snippets.hpp"

namespace {

using namespace manual_test;
using namespace oroforge::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Properties : public Snippets {
protected:
    Properties() {
        writeXml("main.cpf", speed("2") + label("main"));
        writeXml("opts.cpf", speed("3"));
        writeXml("more.cpf", label("more") + simple("extra", "long", "7"));
    }
    static std::string on(const std::string& flag) { return simple(flag, "boolean", "1"); }
    static std::string inlined(const std::string& content) { return bag("Properties", "PropertyBag", content); }
    static std::string file(const std::string& element, const std::string& name) {
        return simple(element, "string", name);
    }

    /// Deploys a worker with that content.
    Outcome deploy(const std::string& content) {
        writeXml("app.xml", import("line") + bag("w", "line::Worker", on("AutoConf") + content));
        return rttscript({"-s", "app.xml"});
    }
    void expectConfigured(const std::string& with, const std::string& content) {
        const Outcome outcome = deploy(content);
        EXPECT_EQ(0, outcome.status) << outcome.err;
        EXPECT_THAT(outcome.out, testing::StartsWith("w: configured with " + with + "\n")) << content;
    }
};

TEST_F(Properties, OfAStructAreOverriddenByTheFilesInTheirOrder) {
    const std::string ofStruct = inlined(speed("1.5") + label("struct")), whole = file("PropertyFile", "main.cpf"),
                      part = file("UpdateProperties", "opts.cpf");
    expectConfigured("speed 1.5, label 'struct'", ofStruct);
    expectConfigured("speed 3, label 'struct'", ofStruct + part);
    expectConfigured("speed 2, label 'main'", ofStruct + part + whole);
    expectConfigured("speed 3, label 'main'", ofStruct + whole + part);
    expectConfigured("speed 3, label 'main'", whole + part + ofStruct);
    expectConfigured("speed 3, label 'more'", whole + part + file("LoadProperties", "more.cpf"));
    expectConfigured("speed 2, label 'more'", file("LoadProperties", "more.cpf") +
                                                  file("UpdateProperties", "main.cpf") +
                                                  file("UpdateProperties", "more.cpf"));
}

TEST_F(Properties, PropertyFileMustHaveThemAll) {
    const Outcome outcome = deploy(file("PropertyFile", "opts.cpf"));
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("label"));
    EXPECT_THAT(outcome.err, HasSubstr("opts.cpf"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("configured")));
}

TEST_F(Properties, LoadPropertiesMakesThemAndUpdatePropertiesDoesNot) {
    writeXml("app.xml", import("line") + bag("w", "line::Worker", file("LoadProperties", "more.cpf")) +
                            bag("v", "line::Worker", file("UpdateProperties", "more.cpf")));
    const Outcome outcome = atPrompt(
        {"-s", "app.xml"},
        {{"w.label", " = \"more\"\n"}, {"w.extra", " = 7\n"}, {"v.label", " = \"more\"\n"}, {"v.extra", kNothing}});
    EXPECT_THAT(outcome.err, HasSubstr("'extra'"));
}

TEST_F(Properties, AreReadInTheStepConfigureComponents) {
    writeXml("app.xml", import("line") + bag("w", "line::Worker", inlined(speed("5"))));
    expectAtPrompt({}, {{"loadComponents(\"app.xml\")", kTrue},
                        {"w.speed", " = 1\n"},
                        {"configureComponents()", kTrue},
                        {"w.speed", " = 5\n"}});
}

TEST_F(Properties, AutoSaveWritesTheValuesJustBeforeCleanup) {
    writeXml("app.xml", import("line") + bag("w", "line::Worker",
                                             on("AutoConf") + on("AutoSave") + file("PropertyFile", "main.cpf")));
    expectAtPrompt({"-s", "app.xml"}, {{"w.label = \"changed\"", testing::_}, {"w.speed = 8.5", testing::_}});
    EXPECT_THAT(readFile(directory_ / "main.cpf"), AllOf(HasSubstr("changed"), HasSubstr("8.5"), Not(HasSubstr("-1"))));
}

TEST_F(Properties, WithoutAutoSaveTheFileStays) {
    const std::string before = readFile(directory_ / "main.cpf");
    writeXml("app.xml", import("line") + bag("w", "line::Worker", on("AutoConf") + file("PropertyFile", "main.cpf")));
    expectAtPrompt({"-s", "app.xml"}, {{"w.speed = 8.5", testing::_}});
    EXPECT_EQ(before, readFile(directory_ / "main.cpf"));
}

TEST_F(Properties, ScriptsReadThemWithTheServiceOfTheComponent) {
    directory_.write("app.ops",
                     "import(\"line\")\n"
                     "loadComponent(\"MyComponent\", \"line::Worker\")\n"
                     "loadService(\"MyComponent\", \"marshalling\")\n"
                     "MyComponent.marshalling.readProperties(\"main.cpf\")\n");
    expectAtPrompt({"-s", "app.ops"}, {{"MyComponent.speed", " = 2\n"},
                                       {"MyComponent.marshalling.updateProperties(\"opts.cpf\")", kTrue},
                                       {"MyComponent.marshalling.loadProperties(\"more.cpf\")", kTrue},
                                       {"MyComponent.speed", " = 3\n"},
                                       {"MyComponent.extra", " = 7\n"},
                                       // That of the deployer is for the deployer's own.
                                       {"loadService(\"Deployer\", \"marshalling\")", kTrue},
                                       {"marshalling.writeProperties(\"deployer.cpf\")", kTrue}});
    const std::string written = readFile(directory_ / "deployer.cpf");
    EXPECT_THAT(written, AllOf(HasSubstr("AutoUnload"), Not(HasSubstr("speed"))));
}

TEST_F(Properties, AServiceThatIsNotLoadedIsNamed) {
    const Outcome outcome = atPrompt({}, {{"import(\"line\")", kTrue},
                                          {"loadComponent(\"w\", \"line::Worker\")", kTrue},
                                          {"w.marshalling.readProperties(\"main.cpf\")", kNothing},
                                          {"w.marshaling.readProperties(\"main.cpf\")", kNothing}});
    const std::string unknown = "component 'w' has no peer, service or value ";
    EXPECT_THAT(outcome.err, HasSubstr(unknown + "'marshalling'; loadService() loads a service of that name\n"));
    EXPECT_THAT(outcome.err, HasSubstr(unknown + "'marshaling'\n"));
}

TEST_F(Properties, ScriptsRunInTheOrderOfTheFileWhileTheComponentIsConfigured) {
    directory_.write("first.ops", "label = label + \"1\"\nvoid more() { label = label + \"f\" }\n");
    directory_.write("second.ops", "more()\nlabel = label + \"2\"\n");
    writeXml("app.xml", import("line") +
                            bag("w", "line::Worker", file("RunScript", "first.ops") + file("RunScript", "second.ops")));
    expectAtPrompt({}, {{"loadComponents(\"app.xml\")", kTrue},
                        {"w.label", " = \"\"\n"},
                        {"configureComponents()", kTrue},
                        {"w.label", " = \"1f2\"\n"}});
}

TEST_F(Properties, AScriptStartsItsComponentProgramsAndMachines) {
    directory_.write("whole.ops",
                     "program programname {\n"
                     "  while (cycles() < 3) { yield }\n"
                     "  label = label + \"p\"\n"
                     "}\n"
                     "StateMachine Kind {\n"
                     "  initial state Begin { transitions { if (cycles() >= 3) then select Middle } }\n"
                     "  state Middle { }\n"
                     "  final state End { }\n"
                     "}\n"
                     "RootMachine Kind statemachine_instance\n"
                     "configure()\n"
                     "programname.start()\n"
                     "statemachine_instance.activate()\n"
                     "statemachine_instance.start()\n"
                     "start()\n");
    writeXml("app.xml", import("line") + bag("w", "line::Worker",
                                             bag("Activity", "Activity", simple("Period", "double", "0.002")) +
                                                 file("RunScript", "whole.ops")));
    expectAtPrompt({"-s", "app.xml"}, {{"w.isRunning()", testing::EndsWith(kTrue)},
                                       until("!w.programname.isRunning()"),
                                       {"w.label", " = \"p\"\n"},
                                       until("w.statemachine_instance.inState(\"Middle\")"),
                                       {"w.statemachine_instance.getState()", " = \"Middle\"\n"}});
}

TEST_F(Properties, AScriptStartsBeforeTheFirstCycle) {
    directory_.write("start.ops", "configure()\nstart()\n");
    const Outcome outcome =
        deploy(bag("Activity", "Activity", simple("Period", "double", "0.001")) + file("RunScript", "start.ops"));
    EXPECT_THAT(outcome.out, HasSubstr("w: started after 0 cycles\n"));
}

TEST_F(Properties, TheWholeDeploymentMayBeAScriptOfTheDeployer) {
    directory_.write("scriptfile.ops",
                     "import(\"line\")\nloadComponent(\"w\", \"line::Worker\")\nw.configure()\nw.start()\n");
    writeXml("deploy.xml",
             bag("Deployer", "PropertyBag",
                 "<!-- set a period -->\n" + bag("Activity", "Activity", simple("Period", "double", "0.01")) +
                     "<!-- run a script -->\n" + simple("RunScript", "string", "scriptfile.ops")));
    directory_.write("alone.ops", "setPeriod(0.01)\nrunScript(\"scriptfile.ops\")\n");
    for (const std::string file : {"deploy.xml", "alone.ops"}) {
        const std::string started = "w: configured with speed 1, label ''\nw: started after 0 cycles\n";
        expectAtPrompt({"-s", file}, {{"w.isRunning()", started + kTrue}, {"getPeriod()", " = 0.01\n"}});
    }
}

}  // namespace
