// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What is told of scripts before they run: --check, --dry-run, and a run that does not begin.
#include "checked_script.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace {

using namespace oroforge::test;
using deployer_test::CheckedScript;
using deployer_test::kImport;
using deployer_test::kOne;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

TEST_F(CheckedScript, AMisspeltImportIsOneErrorWithItsPlaceAndNothingIsExecuted) {
    const std::string text =
        "import(\"deploytset\")\n" + kOne +
        "setActivity(\"one\", 0.1, 0, ORO_SCHED_OTHER)\naddPeer(\"one\", \"Deployer\")\none.start()\n";
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{}, std::vector<std::string>{"--check"}, std::vector<std::string>{"--dry-run"}}) {
        const Outcome found = outcome(options, text);
        EXPECT_EQ(255, found.status);
        EXPECT_THAT(found.err,
                    StartsWith("app.ops:1:8: error: [DEP030] could not import 'deploytset': no such package"));
        EXPECT_THAT(found.err, testing::EndsWith("; did you mean 'deploytest'?\nimport(\"deploytset\")\n       ^\n"));
        EXPECT_EQ(3, std::count(found.err.begin(), found.err.end(), '\n')) << found.err;
        EXPECT_THAT(found.out, Not(HasSubstr("started")));
        if (options.empty()) {
            EXPECT_THAT(found.out, IsEmpty());
        }
    }
}

TEST_F(CheckedScript, AMisspeltOperationOfAComponentThatTheScriptLoads) {
    EXPECT_EQ(checked(kOne + "one.confgure()\n"),
              "app.ops:3:5: error: [OPS134] component 'one' has no operation 'confgure'; did you mean 'configure'?\n"
              "one.confgure()\n    ^\n");
    EXPECT_THAT(checked(kOne + "program p {\n  one.strat()\n}\n"),
                StartsWith("app.ops:4:7: error: [OPS134] component 'one' has no operation 'strat'"));
    const std::string doubted =
        "app.ops:5:5: warning: [OPS134] component 'one' has no operation 'strat' until now; did you mean "
        "'start'?\none.strat()\n    ^\n";
    EXPECT_EQ(checked(kOne + "one.setPeriod(0.1)\nif one.isRunning() then one.stop()\none.strat()\n"), doubted)
        << "stop() may be executed, and what it does is not known";
    EXPECT_THAT(checked(kOne + "one.setPeriod(0.1)\nvar bool runs = one.isRunning()\none.confgure()\n"),
                StartsWith("app.ops:5:5: error: [OPS134] component 'one' has no operation 'confgure'"));
    EXPECT_THAT(checked(kOne + "one.confgure\n"), StartsWith("app.ops:3:5: error: [OPS133]"));
}

TEST_F(CheckedScript, TheArgumentsOfOperationsOfSuchAComponentAndOfTheDeployer) {
    EXPECT_THAT(checked(kOne + "one.configure(1)\n"), StartsWith("app.ops:3:1: error: [OPS142]"));
    EXPECT_THAT(checked(kOne + "one.setPeriod(\"fast\")\n"), StartsWith("app.ops:3:15: error: [OPS143]"));
    EXPECT_THAT(checked("import()\nconnect(\"a.b\")\n"), StartsWith("app.ops:1:1: error: [OPS142]"));
}

TEST_F(CheckedScript, AllErrorsAreToldAtOnce) {
    const std::string said = checked(kOne +
                                     "one.confgure()\nloadComponent(\"two\", \"deploytest::Consmer\")\ntwo.start()\n"
                                     "tow.start()\none.strat()\n");
    EXPECT_THAT(said, HasSubstr("app.ops:3:5: error: [OPS134]"));
    EXPECT_THAT(said, HasSubstr("app.ops:4:22: error: [DEP031] could not load component 'two': unknown component type "
                                "'deploytest::Consmer'; did you mean 'deploytest::Consumer'?"));
    EXPECT_THAT(said,
                HasSubstr("app.ops:6:1: error: [OPS133] component 'Deployer' has no peer, service or value 'tow'"));
    EXPECT_THAT(said, HasSubstr("app.ops:7:5: error: [OPS134]"));
    EXPECT_THAT(said, Not(HasSubstr("app.ops:5:"))) << "which only follows from line 4";
}

TEST_F(CheckedScript, ARunDoesNotBeginIfSomethingBehindIsKnownToBeWrong) {
    const std::pair<const char*, const char*> cases[] = {
        {"loadComponent(\"two\", \"deploytest::Consmer\")\n", "app.ops:2:22: error: [DEP031]"},
        {"import(\"nosuch\")\n", "app.ops:2:8: error: [DEP030]"},
        {"loadLibrary(\"nosuch.so\")\n", "app.ops:2:13: error: [DEP030]"},
        {"conect(\"one.numbers\", \"one.text\", ConnPolicy())\n", "app.ops:2:1: error: [OPS134]"},
        {"loadComponent(\"one\", \"deploytest::Consumer\")\nsetActivity(\"one\", 0.1)\n",
         "app.ops:3:1: error: [OPS142]"},
        {"loadComponent(\"one\", \"deploytest::Consumer\")\nvar ConnPolicy c\nc.nome = 1\n",
         "app.ops:4:3: error: [OPS123]"},
        {"two.start()\n", "app.ops:2:1: error: [OPS133]"}};
    for (const auto& [statement, error] : cases) {
        const Outcome found = outcome({}, kImport + statement);
        EXPECT_EQ(255, found.status);
        EXPECT_THAT(found.err, StartsWith(error));
        EXPECT_THAT(found.out, IsEmpty()) << "no component was created";
    }
}

TEST_F(CheckedScript, WiringOfWhatIsNotThereIsAnErrorOfACheck) {
    const std::pair<const char*, const char*> cases[] = {
        {"connect(\"one.numbrs\", \"two.numbers\", ConnPolicy())\n",
         "app.ops:3:9: error: [OPS420] component 'one' has no port 'numbrs'; did you mean 'numbers'?"},
        {"connectPorts(\"one\", \"tow\")\n", "app.ops:3:21: error: [OPS420] no component 'tow'"},
        {"addPeer(\"noe\", \"one\")\n", "app.ops:3:9: error: [OPS420] no component 'noe'"},
        {"setActivity(\"noe\", 0.1, 0, 0)\n", "app.ops:3:13: error: [OPS420] no component 'noe'"},
        {"loadService(\"one\", \"marshaling\")\n",
         "app.ops:3:20: error: [DEP033] could not load service 'marshaling' into component 'one': there is no service "
         "or "
         "plugin of that name; did you mean 'marshalling'?"}};
    for (const auto& [statement, error] : cases) EXPECT_THAT(checked(kOne + statement), StartsWith(error));
}

TEST_F(CheckedScript, WhatCannotBeKnownIsNoError) {
    directory_.write("other.ops", "loadComponent(\"made\", \"deploytest::Consumer\")\n");
    directory_.write("made.xml",
                     "<properties>\n<struct name=\"made\" type=\"deploytest::Consumer\"/>\n</properties>\n");
    const char* const statements[] = {
        // Names that the script computes, and components that others make.
        "var string name = \"two\"\nloadComponent(name, \"deploytest::Consumer\")\ntwo.confgure()\n",
        "var string type = \"deploytest::Late\"\nloadComponent(\"two\", type)\ntwo.confgure()\nvar int v = "
        "two.number\n",
        "var string other = \"other.ops\"\nrunScript(other)\nmade.confgure()\n",
        "loadComponents(\"made.xml\")\nmade.confgure()\n",
        "scripting.eval(\"loadComponent(\\\"made\\\", \\\"deploytest::Consumer\\\")\")\nmade.confgure()\n",
        // What may be executed or not.
        "var int n = 1\nif n == 1 then loadComponent(\"two\", \"deploytest::Consumer\")\ntwo.confgure()\n",
        "var int n = 1\nif n == 2 then import(\"nosuch\") else import(\"deploytest\")\nloadComponent(\"x\", "
        "\"no::Such\")\n",
        "var int n = 1\nwhile n < 1 { import(\"nosuch\")\n n = n + 1 }\nvar no.such.type x\nx.y = 1\n",
        // What the script looks at itself.
        "try import(\"nosuch\")\n",
        "if !import(\"nosuch\") then nothing\nloadComponent(\"x\", \"no::Such\")\n",
        "var bool there = import(\"nosuch\") || import(\"deploytest\")\n",
        "var bool made = loadComponent(\"one\", \"deploytest::Consumer\")\n",
        // What a component may have later.
        "loadComponent(\"late\", \"deploytest::Late\")\nlate.configure()\nlate.numbers.clear()\nlate.gripper.close()\n",
        "loadComponent(\"late\", \"deploytest::Late\")\nlate.configure()\n"
        "connect(\"late.anything\", \"one.numbers\", ConnPolicy())\n",
        "loadComponent(\"late\", \"deploytest::Late\")\nlate.configure()\nconst double c = late.length\n"
        "var double d = 2.0 * c\nalias double e = late.width\nd = e\n",
        "loadComponent(\"late\", \"deploytest::Late\")\nlate.configure()\nvar SendHandle h\nh = "
        "late.open.send()\nh.collect()\n",
        "loadComponent(\"late\", \"deploytest::Late\")\nconfigureComponent(\"late\")\nlate.gripper.close()\n",
        "loadComponent(\"late\", \"deploytest::Late\")\naddPeer(\"one\", "
        "\"late\")\none.configure()\none.late.gripper.close()\n",
        "addPeer(\"one\", \"Deployer\")\none.configure()\nmade.start()\n",
        "loadService(\"one\", \"marshalling\")\none.marshalling.writeProperties(\"out.cpf\")\n",
        // What the script itself brings.
        "aliasPeer(\"this\", \"one\", \"uno\")\nuno.configure()\n",
        "void make() { loadComponent(\"two\", \"deploytest::Consumer\") }\nmake()\ntwo.confgure()\n",
        "program make { loadComponent(\"two\", \"deploytest::Consumer\") }\nmake.start()\ntwo.confgure()\n",
        "unloadComponent(\"one\")\nloadComponent(\"one\", \"deploytest::Producer\")\none.first = 2\n",
        "StateMachine M { initial state A { transition one.arrived() select B } final state B { } }\n",
        "one.configure()\nStateMachine M { initial state A { transition one.arrived() select B } final state B { } }\n"
        "RootMachine M m\nm.activate()\n",
        "require(\"print\")\nprint.ln(\"x\")\n",
        "task.one.configure()\nDeployer.one.start()\nthis.loadComponent(\"two\", "
        "\"deploytest::Consumer\")\ntwo.start()\n",
    };
    for (const char* const text : statements) {
        for (const char* const option : {"--check", "--dry-run"}) {
            const Outcome found = outcome({option}, kOne + text);
            EXPECT_EQ(0, found.status) << option << "\n" << text << found.err;
            EXPECT_THAT(found.err, IsEmpty()) << text;
        }
    }
}

TEST_F(CheckedScript, ComponentsOfFilesBeforeAreKnown) {
    directory_.write("first.ops", kOne);
    directory_.write("plan.xml",
                     "<properties>\n<struct name=\"planned\" type=\"deploytest::Producer\"/>\n</properties>\n");
    EXPECT_EQ(0, outcome({"--check", "-s", "first.ops"}, "one.start()\n").status);
    EXPECT_EQ(
        0, outcome({"--dry-run", "-s", "first.ops", "-s", "plan.xml"}, "planned.start()\nplanned.whatever()\n").status);
    const Outcome wrong = outcome({"--check", "-s", "first.ops"}, "one.strat()\n");
    EXPECT_EQ(255, wrong.status);
    EXPECT_THAT(wrong.err, StartsWith("app.ops:1:5: error: [OPS134]"));
}

TEST_F(CheckedScript, ChecksStartNothingAndRemoveWhatTheyCreate) {
    for (const char* const option : {"--check", "--dry-run"}) {
        const Outcome found = outcome(
            {option}, kOne + "one.configure()\none.start()\nconnect(\"one.text\", \"one.text\", ConnPolicy())\n");
        EXPECT_EQ(0, found.status) << found.err;
        EXPECT_EQ("one: created\none: cleaned up\none: deleted\n", found.out);
    }
}

TEST_F(CheckedScript, AGoodScriptThatIsCheckedBeforeItRunsIsExecutedOnce) {
    const Outcome found = outcome({}, "path(\".\")\n" + kOne + "one.configure()\none.start()\n");
    EXPECT_EQ(0, found.status);
    EXPECT_THAT(found.err, IsEmpty());
    EXPECT_EQ("one: created\none: configured\none: started\none: stopped\none: cleaned up\none: deleted\n", found.out);
}
}  // namespace
