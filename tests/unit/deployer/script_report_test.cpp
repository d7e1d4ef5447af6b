// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a script that runs tells: places in front, operations of the deployer that fail, --strict.
#include "reporting_script.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

namespace {

using namespace oroforge::test;
using deployer_test::kTwo;
using deployer_test::ReportingScript;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

TEST_F(ReportingScript, ErrorsBeginWithFileLineAndColumnOnTheConsoleAndInTheLogFile) {
    const Outcome found = outcome({}, kTwo + "var int a = 0\na = 1 / a\n");
    EXPECT_EQ(255, found.status);
    const std::string error = "app.ops:6:1: error: [OPS400] division by zero\na = 1 / a\n^\n";
    EXPECT_EQ(error, found.err) << "and nothing else";
    EXPECT_THAT(readFile(directory_ / "orocos.log"), HasSubstr("\n" + error));
}

TEST_F(ReportingScript, ErrorsOfProgramsMachinesAndOfScriptsThatScriptsRunBeginWithTheirPlaces) {
    directory_.write("other.ops", "nowhere()\n");
    const Outcome found = outcome({}, kTwo +
                                          "var string other = \"other.ops\"\nrunScript(other)\n"
                                          "program p {\n  var int a = 0\n  a = 1 / a\n}\n"
                                          "setActivity(\"Deployer\", 0.01, 0, ORO_SCHED_OTHER)\nstart()\np.start()\n"
                                          "while !p.inError() yield\n");
    EXPECT_THAT(found.err, HasSubstr("other.ops:1:1: error: [OPS134]"));
    EXPECT_THAT(found.err, HasSubstr("\napp.ops:6:1: warning: [OPS420] could not run script 'other.ops'\n"));
    EXPECT_THAT(found.err, HasSubstr("\napp.ops:9:3: error: [OPS400] program 'p' of component 'Deployer' failed: "));
    EXPECT_THAT(found.err, Not(HasSubstr("[ ERROR")));
}

TEST_F(ReportingScript, OperationsOfTheDeployerThatFailTellFileAndLine) {
    const std::pair<const char*, const char*> cases[] = {
        {"import(none)", "could not import 'none': no such package or directory in the search path: "},
        {"loadLibrary(none)", "could not load library 'none': "},
        {"reloadLibrary(none)", "could not reload component library 'none': it is not loaded"},
        {"loadComponent(none, none)", "could not load component 'none': unknown component type 'none'"},
        {"loadComponent(\"one\", \"deploytest::Consumer\")",
         "could not load component 'one': a component of that name is already there"},
        {"unloadComponent(none)", "could not unload component 'none': it was not loaded by Deployer"},
        {"loadService(\"one\", none)", "could not load service 'none' into component 'one': no such service"},
        {"configureComponent(none)", "could not configure: no component 'none'"},
        {"startComponent(\"two\")", "could not start component 'two'"},
        {"stopComponent(none)", "could not stop: no component 'none'"},
        {"loadComponents(none)", "could not load what 'none' describes"},
        {"loadConfigurationString(\"<a\")", "could not load what the text describes"},
        {"startComponents()", "not starting components: the last configuration was not valid"},
        {"kickStart(none)", "could not deploy 'none'"},
        {"kickOutComponent(none)", "could not kick out component 'none': it was not loaded by Deployer"},
        {"connectPeers(\"one\", none)", "could not connect peers: no component 'none'"},
        {"addPeer(none, \"one\")", "could not add a peer: no component 'none'"},
        {"aliasPeer(none, \"one\", \"x\")", "could not add a peer: no component 'none'"},
        {"connectPorts(\"one\", none)", "could not connect ports: no component 'none'"},
        {"connectTwoPorts(\"one\", none, \"two\", \"numbers\")",
         "could not connect ports: component 'one' has no port 'none'"},
        {"connect(\"one.text\", \"two.numbers\", ConnPolicy())",
         "could not connect port one.text to two.numbers: output port two.numbers of type int is not compatible"},
        {"stream(\"one.text\", ConnPolicy())", "could not create a stream of port one.text: "},
        {"createStream(\"one\", none, ConnPolicy())", "could not create a stream: component 'one' has no port 'none'"},
        {"connectServices(\"one\", none)", "could not connect services: no component 'none'"},
        {"connectOperations(\"one.x\", \"two.y\")", "could not connect operations: component 'one' requires no"},
        {"setActivity(none, 0.1, 0, 0)", "could not set the activity: no component 'none'"},
        {"setActivityOnCPU(\"one\", 0.1, 0, 0, 99)", "could not set the activity of component 'one': CPU 99, expected"},
        {"setPeriodicActivity(\"one\", 0.0, 0, 0)",
         "could not set the activity of component 'one': a PeriodicActivity"},
        {"setFileDescriptorActivity(none, 1.0, 0, 0)", "could not set the activity: no component 'none'"},
        {"setSequentialActivity(none)", "could not set the activity: no component 'none'"},
        {"setSlaveActivity(none, 0.1)", "could not set the activity: no component 'none'"},
        {"setMasterSlaveActivity(none, \"one\")", "could not use as master: no component 'none'"},
        {"setWaitPeriodPolicy(none, 0)", "could not set the wait policy: no component 'none'"},
    };
    for (const auto& [call, reason] : cases) {
        const Outcome found = outcome({}, kTwo + "  " + call + "\none.configure()\n");
        EXPECT_THAT(found.err, HasSubstr(std::string("app.ops:5:3: warning: [OPS420] ") + reason)) << call;
        EXPECT_EQ(0, found.status) << call << found.err;
        EXPECT_THAT(found.out, HasSubstr("one: configured")) << call;
    }
}

TEST_F(ReportingScript, StrictMakesFailedOperationsOfTheDeployerErrors) {
    const char* const calls[] = {
        "import(none)",    "loadComponent(none, none)", "connectPorts(\"one\", none)", "setSlaveActivity(none, 0.1)",
        "kickStart(none)", "startComponents()"};
    for (const char* const call : calls) {
        const Outcome found = outcome({"--strict"}, kTwo + call + "\none.configure()\n");
        EXPECT_THAT(found.err, HasSubstr("app.ops:5:1: error: [OPS400] ")) << call;
        EXPECT_EQ(255, found.status) << call;
        EXPECT_THAT(found.out, Not(HasSubstr("one: configured"))) << "the script ends there";
    }
    const Outcome handled = outcome({"--strict"}, kTwo +
                                                      "if !addPeer(\"one\", none) then one.configure()\n"
                                                      "var bool added = addPeer(\"one\", none)\n"
                                                      "try addPeer(\"one\", none) catch { two.configure() }\n");
    EXPECT_EQ(0, handled.status) << handled.err;
    EXPECT_THAT(handled.out, HasSubstr("one: configured\ntwo: configured\n"));
}

TEST_F(ReportingScript, AResultOfFalseOfOtherOperationsIsSilent) {
    const Outcome found =
        outcome({"--strict", "-l", "error"}, kTwo + "two.start()\none.isRunning()\nisRunning()\none.setPeriod(-1.0)\n");
    EXPECT_EQ(0, found.status) << found.err;
    EXPECT_THAT(found.err, IsEmpty());
}

TEST_F(ReportingScript, WhatTheScriptLooksAtHasItsPlaceAsWell) {
    const Outcome found =
        outcome({}, kTwo +
                        "if !addPeer(\"one\", none) then nothing\nvar bool b = connectPeers(\"one\", none)\n"
                        "connectPeers(\"one\", \"two\") && connectPorts(none, \"two\")\n");
    EXPECT_EQ(0, found.status);
    EXPECT_THAT(found.err, HasSubstr("app.ops:5:5: warning: [OPS420] could not add a peer: no component 'none'"));
    EXPECT_THAT(found.err, HasSubstr("app.ops:6:14: warning: [OPS420] could not connect peers: no component 'none'"));
    EXPECT_THAT(found.err, HasSubstr("app.ops:7:31: warning: [OPS420] could not connect ports: no component 'none'"));
    EXPECT_THAT(found.err, Not(HasSubstr("[ ERROR")));
}

TEST_F(ReportingScript, WhatComponentsLogKeepsItsForm) {
    const Outcome found = outcome({}, kTwo + "startComponent(\"two\")\n");
    EXPECT_THAT(found.err, testing::ContainsRegex("^[0-9.]+ \\[ Warning\\]\\[[^]]*\\] two: start\\(\\) returns false"));
    EXPECT_THAT(found.err, EndsWith("\napp.ops:5:1: warning: [OPS420] could not start component 'two'\n"
                                    "startComponent(\"two\")\n^\n"));
}

TEST_F(ReportingScript, AMisspeltImportThatTheScriptComputesIsOneLine) {
    const Outcome found = outcome({"--strict"}, "var string name = \"deploytset\"\nimport(name)\n");
    EXPECT_THAT(found.err, StartsWith("app.ops:2:1: error: [OPS400] could not import 'deploytset': no such package"));
    EXPECT_EQ(3, std::count(found.err.begin(), found.err.end(), '\n')) << found.err;
}

TEST_F(ReportingScript, AGlobalServiceThatIsNotThereTellsItsPlaceOnce) {
    const Outcome found = outcome({}, "require(\"nosuch\")\nisRunning()\n");
    EXPECT_EQ(0, found.status);
    EXPECT_THAT(found.err,
                StartsWith("app.ops:1:1: warning: [OPS420] could not load service 'nosuch': no such service"));
    EXPECT_EQ(3, std::count(found.err.begin(), found.err.end(), '\n')) << found.err;
    EXPECT_EQ(255, outcome({"--strict"}, "require(\"nosuch\")\n").status);
    EXPECT_EQ(0, outcome({"--strict"}, "if !require(\"nosuch\") then nothing\nrequire(\"os\")\n").status);
}

TEST_F(ReportingScript, APackageWithOneBadLibraryIsOneWarningAndTheDeployerGoesOn) {
    std::filesystem::create_directories(directory_ / "bad" / OROCOS_TARGET_WORD / "half");
    directory_.write("bad/" OROCOS_TARGET_WORD "/half/libhalf-" OROCOS_TARGET_WORD ".so", "no library");
    const Outcome found = outcome({},
                                  "path(\"bad\")\nvar string half = \"half\"\nimport(half)\nstart()\n"
                                  "if inException() then import(\"nosuch\")\n");
    EXPECT_EQ(0, found.status) << found.err;
    EXPECT_THAT(found.err, StartsWith("app.ops:3:1: warning: [OPS420] could not import 'half': "));
    EXPECT_THAT(found.err, Not(HasSubstr("threw")));
    EXPECT_EQ(3, std::count(found.err.begin(), found.err.end(), '\n')) << found.err;
}

TEST_F(ReportingScript, TheLineOfAFailedOperationIsThatOfTheTextThatRuns) {
    const std::string call = "addPeer(\"one\", none)";
    const Outcome found =
        outcome({}, kTwo +
                        "scripting.eval(\"var string none\\n  addPeer(\\\"one\\\", none)\")\n"
                        "void f() {\n  addPeer(\"one\", \"noone\")\n}\nf()\nscripting.f()\n"
                        "StateMachine M { initial state A { entry {\n    addPeer(\"one\", \"nobody\") } } "
                        "final state B { } }\nRootMachine M m\nm.activate()\n");
    EXPECT_EQ(0, found.status) << found.err;
    EXPECT_THAT(found.err, HasSubstr("eval():2:3: warning: [OPS420] could not add a peer: no component ''\n"
                                     "  addPeer(\"one\", none)\n  ^\n"));
    EXPECT_THAT(found.err, HasSubstr("app.ops:7:3: warning: [OPS420] could not add a peer: no component 'noone'"));
    EXPECT_THAT(found.err, HasSubstr("\n  addPeer(\"one\", \"noone\")\n  ^\n"));
    EXPECT_THAT(found.err, HasSubstr("\n    addPeer(\"one\", \"nobody\") } } final state B { } }\n    ^\n"));
}

TEST_F(ReportingScript, OperationsOfServicesThatFailTellFileAndLine) {
    directory_.write("bad.ops", "nowhere()\n");
    const std::string before = kTwo + "loadService(\"one\", \"marshalling\")\n";
    const std::string file = "none: error: [XML001] cannot read the file: No such file or directory\n";
    const std::pair<const char*, std::string> cases[] = {
        {"one.loadService(none)", "could not load service 'none' into component 'one': no such service"},
        {"one.marshalling.loadProperties(none)", "could not load the properties of component 'one' from 'none'"},
        {"one.marshalling.readProperties(none)", "could not read the properties of component 'one' from 'none'"},
        {"one.marshalling.readProperty(none, none)", "could not read property 'none' of component 'one' from 'none'"},
        {"one.marshalling.updateProperties(none)", "could not update the properties of component 'one' from 'none'"},
        {"one.marshalling.storeProperties(\"no/x\")", "could not store the properties of component 'one' in 'no/x'"},
        {"one.marshalling.writeProperties(\"no/x\")", "could not write the properties of component 'one' to 'no/x'"},
        {"one.marshalling.writeProperty(none, \"no/x\")",
         "could not write property 'none' of component 'one' to 'no/x'"},
        {"one.marshalling.updateFile(\"no/x\")", "could not update 'no/x' with the properties of component 'one'"},
        {"one.marshalling.loadServiceProperties(none, none)", "one has no service called none"},
        {"one.marshalling.readServiceProperty(none, none, none)", "one has no service called none"},
        {"one.marshalling.loadServiceProperties(none, \"marshalling\")",
         "could not load the properties of service 'marshalling' of component 'one' from 'none'"},
        {"scripting.runScript(none)", "could not run script 'none'"},
        {"scripting.loadPrograms(none)", "could not load script 'none'"},
        {"scripting.loadStateMachines(none)", "could not load script 'none'"},
        {"scripting.eval(\"nowhere()\")", "could not run all of the text"},
        {"eval(\"nowhere()\")", "could not run all of the text"},
        {"scripting.loadProgramText(\"nowhere()\")", "could not load the text"},
        {"scripting.unloadProgram(none)", "program 'none' cannot be unloaded: there is none of that name"},
        {"scripting.unloadStateMachine(none)", "state machine 'none' cannot be unloaded: there is none of that name"},
        {"setMasterSlaveActivity(\"one\", \"o\" + \"ne\")",
         "could not set the activity of component 'one': it would be its own master"},
    };
    for (const auto& [call, reason] : cases) {
        const Outcome found = outcome({}, before + "  " + call + "\none.configure()\n");
        EXPECT_THAT(found.err, HasSubstr("app.ops:6:3: warning: [OPS420] " + reason)) << call;
        EXPECT_THAT(found.err, Not(HasSubstr("[ ERROR"))) << call;
        EXPECT_EQ(0, found.status) << call << found.err;
        EXPECT_THAT(found.out, HasSubstr("one: configured")) << call;
        const Outcome strict = outcome({"--strict"}, before + "  " + call + "\none.configure()\n");
        EXPECT_THAT(strict.err, HasSubstr("app.ops:6:3: error: [OPS400] " + reason)) << call;
        EXPECT_EQ(255, strict.status) << call;
    }
    EXPECT_THAT(outcome({}, before + "one.marshalling.loadProperties(none)\n").err, StartsWith(file));
}

TEST_F(ReportingScript, AComponentDoesNotBecomeASlaveOfItsSlaves) {
    const Outcome found = outcome({}, kTwo +
                                          "loadComponent(\"three\", \"deploytest::Consumer\")\n"
                                          "setMasterSlaveActivity(\"one\", \"two\")\n"
                                          "setMasterSlaveActivity(\"two\", \"three\")\n"
                                          "setMasterSlaveActivity(\"three\", \"one\")\n"
                                          "setActivity(\"one\", 0.01, 0, ORO_SCHED_OTHER)\n");
    EXPECT_THAT(found.err, StartsWith("app.ops:8:1: warning: [OPS420] could not set the activity of component 'one': "
                                      "through its masters it would be its own master\n"));
    EXPECT_EQ(3, std::count(found.err.begin(), found.err.end(), '\n')) << found.err;
    const Outcome checked = outcome({"--check"}, kTwo + "setMasterSlaveActivity(\"one\", \"one\")\n");
    EXPECT_THAT(checked.err, StartsWith("app.ops:5:31: error: [OPS420] component 'one' would be its own master\n"));
    EXPECT_EQ(255, checked.status);
}

}  // namespace
