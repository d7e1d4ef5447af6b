// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Scripts that are looked through without being executed.
#include "service_host.hpp"

#include <rtt/scripting/check.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <sstream>

namespace {

using service_test::Host;
using service_test::ServiceTest;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class CheckedScripts : public ServiceTest {
protected:
    /** The messages; empty if the script is good. */
    std::string check(const std::string& text) {
        std::ostringstream messages;
        const bool good = RTT::scripting::checkScriptText(text, "x.ops", host, messages);
        EXPECT_EQ(good, messages.str().empty());
        return messages.str();
    }
};

TEST_F(CheckedScripts, AreNotExecuted) {
    EXPECT_THAT(
        check("count = 1\nnote(\"x\")\nconst int c = host.fail()\nvar int a = c\nscripting.eval(\"count = 2\")\n"),
        IsEmpty());
    EXPECT_EQ(0, host.count);
    EXPECT_THAT(host.notes, IsEmpty());
}

TEST_F(CheckedScripts, AllSyntaxErrorsAreFound) {
    const std::string text = check("count = = 1\ncount = 2\n)\n");
    EXPECT_THAT(text, StartsWith("x.ops:1:9: error: [OPS0"));
    EXPECT_THAT(text, HasSubstr("x.ops:3:1: error: [OPS0"));
}

TEST_F(CheckedScripts, UnknownNamesAreFoundInAllStatements) {
    const std::string text = check("cuont = 1\ncount = 2\nvar int a = cont\n");
    EXPECT_THAT(text, StartsWith("x.ops:1:1: error: [OPS133]"));
    EXPECT_THAT(text, HasSubstr("did you mean 'count'?"));
    EXPECT_THAT(text, HasSubstr("x.ops:3:13: error: [OPS133]"));
}

TEST_F(CheckedScripts, WhatFollowsFromAnErrorIsNoErrorOfItsOwn) {
    const auto errors = [&](const std::string& script) {
        const std::string text = check(script);
        int count = 0;
        for (std::size_t at = 0; (at = text.find(": error: ", at)) != std::string::npos; ++at) ++count;
        return count;
    };
    EXPECT_EQ(1, errors("const int a = cont\ncount = a\n"));
    EXPECT_EQ(1, errors("alias int a = cont\ncount = a\n"));
    EXPECT_EQ(1, errors("var no.such.type x\nx.y = 1\n"));
    EXPECT_EQ(1, errors("int f() { return cont }\ncount = f()\n"));
    EXPECT_EQ(1, errors("program p {\n  const int a = cont\n  count = a\n}\np.start()\n"));
    EXPECT_EQ(1, errors("StateMachine T { initial state a { entry { cont = 1 } } }\nRootMachine T m\nm.start()\n"));
}

TEST_F(CheckedScripts, NamesMayComeFromOperations) {
    EXPECT_THAT(
        check("scripting.eval(\"x\")\nrobot.configure\nrobot.gain = 2\nvar KDL.Frame f = KDL.Frame()\nf.p.x = 1.0\n"),
        IsEmpty());
}

TEST_F(CheckedScripts, ArgumentsOfKnownOperationsAreChecked) {
    const std::string text = check("note(\"a\")\nrobot.start()\nnote(1, 2)\n");
    EXPECT_THAT(text, StartsWith("x.ops:3:1: error: [OPS142]"));
}

TEST_F(CheckedScripts, TypesAreChecked) {
    EXPECT_THAT(check("note(\"a\")\ncount = \"text\"\n"), StartsWith("x.ops:2:9: error: [OPS128]"));
}

TEST_F(CheckedScripts, DefinitionsAreKnownToWhatFollows) {
    EXPECT_THAT(check("int f(int a) { return a + 1 }\n"
                      "program p { count = f(1) }\n"
                      "StateMachine T { initial state a { entry { count = f(2) } } final state b { } }\n"
                      "RootMachine T m\n"
                      "count = f(3)\n"
                      "p.start()\n"
                      "m.activate()\n"),
                IsEmpty());
    EXPECT_FALSE(host.provides()->hasService("p"));
    EXPECT_FALSE(host.provides()->hasService("m"));
    EXPECT_FALSE(service->hasOperation("f"));
}

TEST_F(CheckedScripts, BodiesOfDefinitionsAreChecked) {
    EXPECT_THAT(check("void f() {\n  cuont = 1\n}\n"), StartsWith("x.ops:2:3: error: [OPS133]"));
    EXPECT_THAT(check("program p {\n  cuont = 1\n}\np.start()\n"), StartsWith("x.ops:2:3: error: [OPS133]"));
    EXPECT_THAT(
        check(
            "StateMachine T {\n  initial state a { }\n  final state b { }\n  final state c { }\n}\nRootMachine T m\n"),
        StartsWith("x.ops:4:"));
    EXPECT_THAT(check("void f() { }\nvoid f() { }\n"),
                HasSubstr("[OPS201] function 'f' is defined twice in this script"));
    EXPECT_THAT(check("program p { }\nprogram p { }\n"),
                HasSubstr("[OPS203] program 'p' is defined twice in this script"));
}

TEST_F(CheckedScripts, AFileIsCheckedLikeAText) {
    const oroforge::test::TempDir directory;
    const std::string file = directory.write("x.ops", "count = 1\ncount = cont\n");
    std::ostringstream messages;
    EXPECT_FALSE(RTT::scripting::checkScript(file, host, messages));
    EXPECT_THAT(messages.str(), StartsWith(file + ":2:9: error: [OPS133]"));
    std::ostringstream missing;
    EXPECT_FALSE(RTT::scripting::checkScript("/nowhere/x.ops", host, missing));
    EXPECT_EQ("/nowhere/x.ops: error: [OPS411] cannot read the script: No such file or directory\n", missing.str());
}

TEST_F(CheckedScripts, NamesThatAreTakenAreFound) {
    EXPECT_EQ(check("void eval() { }\n"),
              "x.ops:1:6: error: [OPS204] function 'eval' cannot be added: 'scripting' has an operation of that name, "
              "which no script defined\n"
              "void eval() { }\n"
              "     ^\n");
    EXPECT_THAT(check("export void note() { }\n"), StartsWith("x.ops:1:13: error: [OPS204]"));
    EXPECT_EQ(check("program scripting { }\n"),
              "x.ops:1:9: error: [OPS203] program 'scripting' cannot be loaded: component 'host' has a service of that "
              "name already\n"
              "program scripting { }\n"
              "        ^\n");
    EXPECT_EQ(check("program m { }\nStateMachine T { initial state a { } final state b { } }\nRootMachine T m\n"),
              "x.ops:3:15: error: [OPS303] state machine 'm' cannot be loaded: component 'host' has a program of that "
              "name already\n"
              "RootMachine T m\n"
              "              ^\n"
              "x.ops:1:9: note: first defined here\n"
              "program m { }\n"
              "        ^\n");
}

TEST_F(CheckedScripts, ATypeOfStateMachinesMayComeFromAnotherScript) {
    EXPECT_THAT(check("scripting.runScript(\"types.osd\")\nRootMachine T m\nm.activate()\n"), IsEmpty());
    EXPECT_THAT(check("RootMachine T m\n"), StartsWith("x.ops:1:13: error: [OPS305]"));
    EXPECT_EQ(
        check("StateMachine T {\n  initial state a { transition select c }\n  final state b { }\n}\nRootMachine T m\n"),
        "x.ops:2:39: error: [OPS306] there is no state 'c' in 'T'\n"
        "  initial state a { transition select c }\n"
        "                                      ^\n")
        << "and nothing about what follows from that";
}

TEST_F(CheckedScripts, EventsMayBeThoseOfComponentsThatTheScriptMakes) {
    const auto machine = [](const std::string& event) {
        return "StateMachine T {\n  var string s\n  initial state a { transition " + event +
               " select b }\n  final state b { }\n}\nRootMachine T m\n";
    };
    EXPECT_THAT(check(machine("robot.moved(s)")), StartsWith("x.ops:3:32: error: [OPS311]"));
    EXPECT_THAT(check("note(\"a\")\n" + machine("robot.moved(s)")), IsEmpty());
    EXPECT_THAT(check(machine("moved(s)")), StartsWith("x.ops:3:32: error: [OPS312]"));
    EXPECT_THAT(check("note(\"a\")\n" + machine("moved(s)")), IsEmpty());
    EXPECT_THAT(check("note(\"a\")\n" + machine("note(s)")), StartsWith("x.ops:4:32: error: [OPS313]"));
}

TEST_F(CheckedScripts, AComponentThatRanTheScriptMayCheckIt) {
    const std::string text = "void f() { }\nprogram p { f() }\n";
    EXPECT_TRUE(eval(text));
    EXPECT_THAT(check(text), IsEmpty());
}

}  // namespace
