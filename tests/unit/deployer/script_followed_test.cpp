// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Scripts that a script which is checked runs: they are looked through as well.
#include "checked_script.hpp"

#include <gmock/gmock.h>

namespace {

using namespace oroforge::test;
using deployer_test::CheckedScript;
using deployer_test::kImport;
using deployer_test::kOne;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string kRun = "runScript(\"more.ops\")\n";

TEST_F(CheckedScript, ErrorsOfAScriptThatItRunsHaveTheirOwnPlaces) {
    for (const std::string run : {"runScript(\"more.ops\")", "Deployer.runScript(\"more.ops\")",
                                  "this.runScript(\"more.ops\")", "scripting.runScript(\"more.ops\")",
                                  "if !runScript(\"more.ops\") then nothing", "var bool b = runScript(\"more.ops\")",
                                  "void f() { runScript(\"more.ops\") }\nf()", "runScript.send(\"more.ops\")"}) {
        directory_.write("more.ops", "isRunning()\nvar int a = \n");
        EXPECT_THAT(checked(run + "\n"), StartsWith("more.ops:2:")) << run;
        directory_.write("more.ops", "isRunning()\nisRuning()\n");
        EXPECT_EQ(
            "more.ops:2:1: error: [OPS134] component 'Deployer' has no operation 'isRuning'; did you mean "
            "'isRunning'?\nisRuning()\n^\n",
            checked(run + "\n"))
            << run;
    }
}

TEST_F(CheckedScript, ErrorsOfBothScriptsAreTold) {
    directory_.write("more.ops", "loadComponent(\"one\", \"deploytest::Consumr\")\n");
    const std::string said = checked(kImport + kRun + "conect(\"a\", \"b\")\n");
    EXPECT_THAT(said, HasSubstr("app.ops:3:1: error: [OPS134]"));
    EXPECT_THAT(said, HasSubstr("more.ops:1:22: error: [DEP031]"));
    EXPECT_EQ(0, outcome({}, kImport + kRun).status) << "a run goes on, with a warning";
}

TEST_F(CheckedScript, WhatAScriptThatItRanMadeIsKnownAfterwards) {
    directory_.write("more.ops",
                     kOne + "int twice(int n) { return 2 * n }\nprogram p { twice(1) }\nvar int mine = 1\n");
    const std::string good = kRun + "one.configure()\np.stop()\nvar int n = twice(2)\n";
    EXPECT_THAT(checked(good), IsEmpty());
    EXPECT_EQ(0, outcome({}, good).status);
    EXPECT_THAT(checked(kRun + "one.confgure()\n"), StartsWith("app.ops:2:5: error: [OPS134] component 'one' has no"));
    EXPECT_THAT(checked(kRun + "loadComponent(\"one\", \"deploytest::Consumer\")\n"),
                StartsWith("app.ops:2:15: error: [DEP032]"));
    EXPECT_THAT(checked(kRun + "mine = 2\n"), StartsWith("app.ops:2:1: error: [OPS1"));
}

TEST_F(CheckedScript, AScriptThatItRunsSeesItsVariablesAndFunctions) {
    directory_.write("more.ops", "n = twice(n)\none.configure()\nprogram p { twice(1) }\n");
    const std::string text = kOne + "var int n = 1\nint twice(int n) { return 2 * n }\n" + kRun + "p.stop()\n";
    EXPECT_THAT(checked(text), IsEmpty());
    EXPECT_EQ(0, outcome({}, text).status);
}

TEST_F(CheckedScript, WhatAScriptMadeThatMayNotRunIsNoError) {
    directory_.write("more.ops", "loadComponent(\"two\", \"deploytest::Consumer\")\n");
    directory_.write("other.ops", "loadComponent(\"two\", \"deploytest::Producer\")\n");
    const std::string text = kImport +
                             "var int n = 1\nif n == 1 then runScript(\"more.ops\") else runScript(\"other.ops\")\n"
                             "two.configure()\ntwo.port1.connected()\n";
    EXPECT_THAT(checked(text), IsEmpty());
}

TEST_F(CheckedScript, ScriptsThatRunEachOtherAreLookedThroughOnce) {
    directory_.write("more.ops",
                     "isRuning()\nif isRunning() then runScript(\"app.ops\")\n"
                     "if isRunning() then runScript(\"./more.ops\")\n");
    const std::string said = checked(kRun + kRun);
    EXPECT_THAT(said, StartsWith("more.ops:1:1: error: [OPS134]"));
    EXPECT_EQ(said.find(": error: "), said.rfind(": error: ")) << said;
    EXPECT_THAT(checked("if isRunning() then runScript(\"app.ops\")\n"), IsEmpty());
    // Each twice the next one.
    for (int i = 0; i != 40; ++i) {
        const std::string next = "runScript(\"s" + std::to_string(i + 1) + ".ops\")\n";
        directory_.write("s" + std::to_string(i) + ".ops", next + next);
    }
    directory_.write("s40.ops", "isRunning()\n");
    EXPECT_THAT(checked("runScript(\"s0.ops\")\n"), IsEmpty());
}

TEST_F(CheckedScript, AScriptThatIsMissingInAScriptThatItRunsIsAnErrorThere) {
    directory_.write("sub/a.ops", "runScript(\"b.ops\")\n");
    directory_.write("sub/b.ops", "isRunning()\n  runScript(\"nope.ops\")\n");
    EXPECT_THAT(checked("runScript(\"sub/a.ops\")\n"),
                StartsWith("sub/b.ops:2:13: error: [OPS411] cannot read the script 'nope.ops': No such file"));
    EXPECT_THAT(checked(kOne + "loadService(\"one\", \"scripting\")\none.scripting.runScript(\"nope.ops\")\n"),
                StartsWith("app.ops:4:25: error: [OPS411] cannot read the script 'nope.ops'"));
    directory_.write("more.lua", "no OPS at all");
    EXPECT_THAT(checked("runScript(\"more.lua\")\n"), IsEmpty());
}

TEST_F(CheckedScript, AServiceThatAComponentIsToLoadIsLookedFor) {
    EXPECT_THAT(
        checked(kOne + "one.loadService(\"marshaling\")\n"),
        StartsWith("app.ops:3:17: error: [DEP033] could not load service 'marshaling' into component 'one': there "
                   "is no service or plugin of that name; did you mean 'marshalling'?"));
    EXPECT_THAT(checked(kOne + "one.loadService(\"marshalling\")\none.marshalling.loadPropertis(\"x\")\n"),
                StartsWith("app.ops:4:17: error: [OPS134]"));
    EXPECT_THAT(checked(kOne + "if !one.loadService(\"nope\") then nothing\n"), IsEmpty());
}

}  // namespace
