// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What is certain of scripts before they run, and what is not: a script that runs must run whatever the check thinks of it.
#include "checked_script.hpp"

#include <gmock/gmock.h>

#include <utility>

namespace {

using namespace oroforge::test;
using deployer_test::CheckedScript;
using deployer_test::kImport;
using deployer_test::kOne;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

TEST_F(CheckedScript, FunctionsOfTheScriptAreOperationsAsInARun) {
    const char* const texts[] = {
        "export bool foo(int i) { return true }\nthis.foo(1)\nDeployer.foo(1)\ntask.foo(1)\nfoo.send(1)\nfoo.cmd(1)\n"
        "foo.call(1)\nvar bool b = this.foo(1) && Deployer.foo.call(2)\n",
        "bool foo(int i) { return true }\nvar SendHandle g\ng = foo.send(1)\nvar bool r\ng.collect(r)\n"
        "scripting.foo(1)\nfoo.cmd(2)\nfoo(3)\n",
        "global double foo(int i) { return 1.5 }\nfoo.send(1)\nfoo.cmd(1)\nvar double d = foo(1)\n",
        "export void nop() { }\nthis.nop\nnop.send()\nvar SendHandle g\ng = Deployer.nop.send()\ng.collect()\n",
        "export void nop() { }\nprogram p { this.nop() }\nfoo2()\nvoid foo2() { this.nop() }\nfoo2()\n",
    };
    for (const char* const text : texts) {
        const bool fails = std::string(text).find("foo2()\nvoid") != std::string::npos;
        EXPECT_EQ(fails ? 255 : 0, outcome({"--check"}, text).status) << text;
        const Outcome found = outcome({}, text);
        EXPECT_EQ(fails ? 255 : 0, found.status) << text << found.err;
    }
    EXPECT_THAT(checked("export bool foo(int i) { return true }\nthis.foo()\n"),
                StartsWith("app.ops:2:1: error: [OPS142]"));
    EXPECT_THAT(checked("export bool foo(int i) { return true }\nfoo.send(\"x\")\n"),
                StartsWith("app.ops:2:10: error: [OPS143]"));
}

TEST_F(CheckedScript, AFunctionWithAnErrorIsOneErrorHoweverItIsCalled) {
    const std::string said = checked("export bool foo(int i) { retrun true }\nthis.foo(1)\nfoo.send(1)\nfoo(1)\n");
    EXPECT_THAT(said, StartsWith("app.ops:1:")) << said;
    EXPECT_EQ(said.find(": error: "), said.rfind(": error: ")) << said;
}

TEST_F(CheckedScript, AFunctionThatAScriptDefinesAgainHasItsNewArguments) {
    directory_.write("first.ops", "export bool foo(int i) { return true }\nbool bar() { return true }\n");
    directory_.write("again.ops", "int bar(int i, int j) { return i }\nexport int foo(int i) { return i }\n");
    const std::string mine = "int bar() { return 1 }\nexport int foo() { return 1 }\nrunScript(\"again.ops\")\n";
    for (const std::vector<std::string>& options : {std::vector<std::string>{}, std::vector<std::string>{"--check"}}) {
        const Outcome other = outcome(options, mine +
                                                   "bar(1, 2)\nvar int n = bar(1, 2)\nn = 3\nbar.send(1, 2)\n"
                                                   "foo(1)\nthis.foo(1)\nprogram p { bar(1, n) }\n");
        EXPECT_EQ(0, other.status) << other.err;
    }
    const Outcome found =
        outcome({"-s", "first.ops"},
                "export bool foo(int i, int j) { return true }\nbool bar(int i) { return true }\nthis.foo(1, 2)\n"
                "foo(1, 2)\nbar.send(1)\nbar(1)\n");
    EXPECT_EQ(0, found.status) << found.err;
}

TEST_F(CheckedScript, WhatComponentsBringIsNoErrorOfTheScriptThatLoadsThem) {
    const std::string one = kImport + "loadComponent(\"c\", \"deploytest::Brings\")\n", two = one + "c.configure()\n";
    const auto uses = [](const std::string& when, const std::string& type) {
        return std::vector<std::string>{
            "var " + type + ".Type x\nx.x = 2.0\n",
            "var double d = " + type + ".Type().x\n",
            when + ".two()\n" + when + "Global()\n",
            "var int n = " + when + "Global() + " + when + ".two + c." + when + "Own.two()\n",
            "loadComponent(\"d\", \"" + when + "::Component\")\nd.configure()\nd.numbers.write(1)\n",
            "program p { var int n = " + when + ".two() }\np.start()\nwhile p.isRunning() yield\n",
        };
    };
    const std::string start = "setActivity(\"Deployer\", 0.01, 0, ORO_SCHED_OTHER)\nstart()\n";
    for (const auto& [before, when] : {std::make_pair(one, "early"), std::make_pair(two, "late"),
                                       std::make_pair(one + "configureComponent(\"c\")\n", "late"),
                                       std::make_pair(one + "var bool b = c.configure()\n", "late"),
                                       std::make_pair(one + "void f() { c.configure() }\nf()\n", "late"),
                                       std::make_pair(one + "if c.configure() then c.start()\n", "late")})
        for (const std::string& use : uses(when, "early")) {
            const bool starts = use.find("p.start") != std::string::npos;
            const std::string text = before + (starts ? start : "") + use;
            for (const std::string option : {"", "--check"}) {
                const Outcome found =
                    outcome(option.empty() ? std::vector<std::string>{} : std::vector<std::string>{option}, text);
                EXPECT_EQ(0, found.status) << option << "\n" << text << found.err;
            }
        }
}

TEST_F(CheckedScript, WhatNewComponentsBringToOldOnesIsNoError) {
    directory_.write("first.ops", kImport + "loadComponent(\"old\", \"deploytest::Late\")\n");
    const std::string load = "loadComponent(\"new\", \"deploytest::Brings\")\n";
    for (const char* const wire : {"addPeer(\"new\", \"old\")\n", "connectPeers(\"old\", \"new\")\n",
                                   "aliasPeer(\"new\", \"old\", \"x\")\n", "connectPeers(\"new\", \"old\")\n"})
        for (const std::string name : {"old", "new.old"}) {
            if (name == "new.old" && std::string(wire).find("alias") != std::string::npos) continue;
            const std::string text = load + wire + "new.configure()\nvar int n = " + name + ".added.two()\n" + name +
                                     ".configure()\n" + name + ".numbers.write(1)\n";
            for (const std::vector<std::string>& options : {std::vector<std::string>{"-s", "first.ops"},
                                                            std::vector<std::string>{"--check", "-s", "first.ops"}}) {
                const Outcome found = outcome(options, text);
                EXPECT_EQ(0, found.status) << options.front() << "\n" << text << found.err;
            }
        }
}

TEST_F(CheckedScript, AComponentMayReplaceItsOperations) {
    directory_.write("first.ops", kImport + "loadComponent(\"old\", \"deploytest::Brings\")\n");
    const Outcome found = outcome({"-s", "first.ops"}, "old.configure()\nvar int n = old.grow(1)\n");
    EXPECT_EQ(0, found.status) << found.err;
    EXPECT_THAT(outcome({"-s", "first.ops"}, "old.grow(1)\n").err, StartsWith("app.ops:1:1: error: [OPS142]"));
}

TEST_F(CheckedScript, WhatRunningComponentsBringIsNoError) {
    directory_.write("first.ops", kOne +
                                      "export void work() { loadComponent(\"made\", \"deploytest::Consumer\") }\n"
                                      "program w { work() }\n"
                                      "setActivity(\"Deployer\", 0.01, 0, ORO_SCHED_OTHER)\nstart()\nw.start()\n");
    const Outcome found = outcome({"-s", "first.ops"}, "require(\"os\")\nos.sleep(1)\nmade.start()\n");
    EXPECT_EQ(0, found.status) << found.err;
}

TEST_F(CheckedScript, AComponentTakesThePlaceOfAGlobalServiceOrAVariableOfItsName) {
    for (const std::string& text :
         {"require(\"print\")\n" + kImport + "loadComponent(\"print\", \"deploytest::Consumer\")\nprint.start()\n",
          "require(\"os\")\n" + kImport + "loadComponent(\"os\", \"deploytest::Late\")\nos.configure\nos.sleep\n",
          "var double arm = 1.0\n" + kImport +
              "loadComponent(\"arm\", \"deploytest::Consumer\")\narm.start\narm.stop()\nthis.arm.start()\n"
              "Deployer.arm.stop()\narm = 2.0\n",
          "require(\"print\")\n" + kImport +
              "loadComponent(\"print\", \"deploytest::Consumer\")\nStateMachine M { var int n = 0\n initial state A { "
              "transition print.numbers(n) select B } final state B { } }\nRootMachine M m\n"}) {
        const bool sleeps = text.find("os.sleep") != std::string::npos;
        const Outcome found = outcome({}, text);
        EXPECT_EQ(sleeps ? 255 : 0, found.status) << text << found.err;
        if (sleeps) {
            EXPECT_THAT(found.out, HasSubstr("os: configured")) << "a run ends where it fails";
        }
    }
}

TEST_F(CheckedScript, AComponentThatIsLoadedAgainMayBeAnotherOne) {
    for (const char* const unload :
         {"unloadComponent(\"one\")\n", "kickOutComponent(\"one\")\n", "unloadComponents()\n", "kickOutAll()\n",
          "var string s = \"one\"\nunloadComponent(s)\n", "this.unloadComponent(\"one\")\n"}) {
        const std::string text = kOne + unload +
                                 "loadComponent(\"one\", \"deploytest::Brings\")\none.configure()\n"
                                 "one.lateOwn.two()\nconnectPorts(\"one\", \"one\")\n";
        for (const std::vector<std::string>& options :
             {std::vector<std::string>{}, std::vector<std::string>{"--check"}}) {
            const Outcome found = outcome(options, text);
            EXPECT_EQ(0, found.status) << text << found.err;
        }
    }
    EXPECT_THAT(checked(kOne + "unloadComponent(\"one\")\nconect(\"one.x\", \"one.y\")\n"),
                HasSubstr("app.ops:4:1: error: [OPS134] component 'Deployer' has no operation 'conect'"))
        << "the rest is checked";
    EXPECT_THAT(checked(kOne + "unloadComponent(\"noe\")\n"), StartsWith("app.ops:3:17: error: [OPS420]"));
}

TEST_F(CheckedScript, ARunImportsInAdvanceOnlyWhatItImportsFirst) {
    directory_.write("sub/empty.txt", "");
    const std::string late = "loadComponent(\"early\", \"OCL::HelloWorld\")\n" + kImport +
                             "var bool ok = loadComponent(\"one\", \"deploytest::Consumer\")\n";
    for (const std::string first : {"require(\"os\")\nos.sleep(0)\n", "var bool b = isRunning()\n",
                                    "var int i = 0\nwhile i < 3 { i = i + 1\n nothing }\n"}) {
        // What is imported in advance knows its types in advance.
        const Outcome found = outcome({}, first + kImport + "loadComponent(\"one\", \"deploytest::Consmer\")\n");
        EXPECT_EQ(0, found.status) << first << found.err;
        EXPECT_THAT(found.err, HasSubstr("warning: [OPS420] could not load component 'one'"));
        EXPECT_EQ(255,
                  outcome({"--check"}, first + kImport + "loadComponent(\"one\", \"deploytest::Consmer\")\n").status);
    }
    EXPECT_EQ(0, outcome({}, late).status);
}

TEST_F(CheckedScript, DefinitionsOfScriptsBeforeAreKnown) {
    directory_.write("first.ops",
                     "int foo(int i) { return i }\nexport void bar() { }\nprogram p { nothing }\n"
                     "StateMachine M { initial state A { } final state B { } }\nRootMachine M m\n");
    const std::string text =
        "foo(1)\nvar int n = foo(2)\nbar()\nthis.bar()\nbar.send()\np.start()\nDeployer.p.stop()\nm.activate()\n"
        "RootMachine M other\nStateMachine N { SubMachine M sub\n initial state A { entry { foo(1) } } "
        "final state B { } }\nRootMachine N n2\n";
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--check", "-s", "first.ops"}, std::vector<std::string>{"-s", "first.ops"}}) {
        const Outcome found = outcome(options, text);
        EXPECT_EQ(0, found.status) << found.err;
        EXPECT_THAT(found.err, Not(HasSubstr("app.ops")));
    }
    EXPECT_EQ(255, outcome({"--check", "-s", "first.ops"}, "fooo(1)\n").status);
}

TEST_F(CheckedScript, QueriesAndServicesOfTheToolchainLeaveTheRestCheckable) {
    for (const char* const statement :
         {"var int n = one.numbers.last\n", "var int n\none.numbers.read(n)\n", "one.numbers.clear()\n",
          "var bool b = one.numbers.connected()\n", "loadService(\"one\", \"scripting\")\n",
          "loadService(\"one\", \"marshalling\")\n"}) {
        EXPECT_THAT(checked("import(\"deploytest\")\nloadComponent(\"one\", \"deploytest::Consumer\")\n" +
                            std::string(statement) + "one.nosuch()\n"),
                    HasSubstr("one.nosuch()\n    ^\n"))
            << statement;
        const Outcome found = outcome({"--check"}, kOne + statement + "one.nosuch()\n");
        EXPECT_EQ(255, found.status) << statement << found.err;
    }
    EXPECT_THAT(checked(kOne + "loadService(\"one\", \"marshalling\")\none.marshalling.nosuch()\n"),
                StartsWith("app.ops:4:17: error: [OPS134]"));
}

TEST_F(CheckedScript, NamesThatAreLikeKnownOnesAreDoubtedWhereTheyAreNotCertain) {
    const std::pair<const char*, const char*> cases[] = {
        {"one.configure()\none.strt()\n",
         "app.ops:4:5: warning: [OPS134] component 'one' has no operation 'strt' until now; did you mean 'start'?"},
        {"one.configure()\noen.start()\n",
         "app.ops:4:1: warning: [OPS133] component 'Deployer' has no peer, service or value 'oen' until now; did you "
         "mean 'one'?"},
        {"one.configure()\nloadComponent(\"two\", \"deploytest::Consmer\")\n",
         "app.ops:4:22: warning: [DEP031] could not load component 'two': unknown component type "
         "'deploytest::Consmer'; did you mean 'deploytest::Consumer'?"},
        {"runScript(\"oth\" + \"er.ops\")\nimport(\"deploytset\")\n", "app.ops:4:8: warning: [DEP030]"}};
    directory_.write("other.ops", "");
    for (const auto& [text, warning] : cases) {
        EXPECT_THAT(checked(kOne + text), StartsWith(warning));
        EXPECT_EQ(0, outcome({"--check"}, kOne + text).status);
        EXPECT_THAT(outcome({}, kOne + text).err, Not(HasSubstr("until now")));
    }
}

// Whatever components add, nothing of theirs is called almost like these.
TEST_F(CheckedScript, ASlipInACallOfTheDeployerIsCertainBehindCodeOfComponents) {
    const std::string slip = "conect(\"one.numbers\", \"one.text\", ConnPolicy())\n";
    for (const std::string before : {"one.configure()\n", "one.start()\nrequire(\"os\")\n"}) {
        EXPECT_THAT(checked(kOne + before + slip),
                    HasSubstr(": error: [OPS134] component 'Deployer' has no operation 'conect'"));
        EXPECT_THAT(outcome({}, kOne + before + slip).err, HasSubstr("app.ops:")) << "when the script comes there";
    }
}

TEST_F(CheckedScript, ASlipInACallThatEveryComponentHasIsAnErrorOfACheck) {
    EXPECT_THAT(checked(kOne + "one.configure()\none.confgure()\none.isRuning()\n"),
                AllOf(HasSubstr("app.ops:4:5: error: [OPS134] component 'one' has no operation 'confgure'"),
                      HasSubstr("app.ops:5:5: error: [OPS134] component 'one' has no operation 'isRuning'")));
    EXPECT_THAT(checked(kOne + "one.configure()\none.configureArm()\n"), HasSubstr("app.ops:4:5: warning: [OPS134]"))
        << "it may have that then";
}

TEST_F(CheckedScript, AMemberOfAKnownTypeIsCertainWhateverWasCalled) {
    for (const std::string before : {"one.configure()\n", "import(none)\n", "runScript(none)\n"})
        EXPECT_THAT(checked("var string none = \"none\"\n" + kOne + before + "var ConnPolicy cp\ncp.nome = \"x\"\n"),
                    StartsWith("app.ops:6:4: error: [OPS123] type ConnPolicy has no member 'nome'"));
    EXPECT_THAT(checked(kOne + "one.configure()\nvar PropertyBag b\nvar flow f\n"), Not(HasSubstr("OPS123")));
}

TEST_F(CheckedScript, AMisspeltOperationOrImportDoesNotHideWhatFollows) {
    const std::string said = checked(
        "conect(\"a\", \"b\")\nimport(\"nosuch2\")\nimport(\"deploytest\")\n"
        "loadComponent(\"h\", \"deploytest::Consmer\")\nimport(\"nosuch3\")\nconect(\"a\", \"b\")\n"
        "setActivity(\"x\", 0.1)\n");
    EXPECT_THAT(said, StartsWith("app.ops:1:1: error: [OPS134]"));
    EXPECT_THAT(said, HasSubstr("app.ops:2:8: error: [DEP030]"));
    EXPECT_THAT(said, HasSubstr("app.ops:4:20: warning: [DEP031]"));
    EXPECT_THAT(said, HasSubstr("app.ops:5:8: error: [DEP030]"));
    EXPECT_THAT(said, HasSubstr("app.ops:6:1: error: [OPS134]"));
    EXPECT_THAT(said, HasSubstr("app.ops:7:1: error: [OPS142]"));
    EXPECT_THAT(checked("conect(\"a\", \"b\")\n" + kImport + "loadComponent(\"h\", \"deploytest::Consmer\")\n"),
                HasSubstr("app.ops:3:20: error: [DEP031]"));
}

TEST_F(CheckedScript, AServiceThatNobodyHasIsAnErrorWithItsPlace) {
    EXPECT_EQ(
        "app.ops:1:9: error: [DEP033] could not load service 'nosuch': there is no service or plugin of that "
        "name\nrequire(\"nosuch\")\n        ^\n",
        checked("require(\"nosuch\")\n"));
    EXPECT_THAT(checked("if !require(\"nosuch\") then nothing\nvar bool b = require(\"os\")\nos.sleep(0)\n"),
                IsEmpty());
}

TEST_F(CheckedScript, AFileThatIsNotThereIsAnError) {
    const std::pair<const char*, const char*> cases[] = {
        {"runScript(\"nope.ops\")\n",
         "app.ops:1:11: error: [OPS411] cannot read the script 'nope.ops': No such file or directory"},
        {"loadComponents(\"nope.xml\")\n",
         "app.ops:1:16: error: [DEP020] cannot read the file 'nope.xml': No such file or directory"},
        {"kickStart(\"nope.xml\")\n", "app.ops:1:11: error: [DEP020]"},
        {"connectOperations(\"one.x\", \"two.y\")\n", "app.ops:1:19: error: [OPS420] no component 'one'"}};
    for (const auto& [statement, error] : cases) {
        EXPECT_THAT(checked(statement), StartsWith(error));
        EXPECT_EQ(0, outcome({}, statement).status) << "a run goes on, with a warning";
    }
    EXPECT_THAT(checked("if !runScript(\"nope.ops\") then nothing\nvar bool b = kickStart(\"nope.xml\")\n"), IsEmpty());
    directory_.write("sub/a.ops", "runScript(\"b.ops\")\n");
    directory_.write("sub/b.ops", "\n");
    EXPECT_EQ(0, outcome({"--check", "-s", "sub/a.ops"}, "\n").status);
}

TEST_F(CheckedScript, ANameMayBeUsedAgainAfterItWasUnloaded) {
    const std::string text =
        "program p { nothing }\nunloadProgram(\"p\")\nprogram p { yield }\nunloadProgram(\"p\")\n"
        "StateMachine M { initial state A { } final state B { } }\nRootMachine M p\n";
    EXPECT_THAT(checked(text), IsEmpty());
    EXPECT_EQ(0, outcome({}, text).status);
}

}  // namespace
