// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What running a text does, and what is said when it does not work.
#include "service_host.hpp"

#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <filesystem>

namespace {

using service_test::Host;
using service_test::ServiceTest;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class ScriptsOfService : public ServiceTest {
protected:
    /** Runs a file with that text; messages call it "main.ops". */
    bool runMain(const std::string& text) {
        directory.write("main.ops", text);
        std::filesystem::current_path(directory.path());
        return service->runScript("main.ops");
    }

    oroforge::test::TempDir directory;
};

TEST_F(ScriptsOfService, EvalExecutesStatements) {
    EXPECT_TRUE(eval("count = 1 + 2*3"));
    EXPECT_EQ(7, host.count);
    EXPECT_THAT(logged(), IsEmpty());
}

TEST_F(ScriptsOfService, AnEmptyTextIsAScript) {
    EXPECT_TRUE(eval(""));
    EXPECT_TRUE(eval("\n # nothing\n"));
}

TEST_F(ScriptsOfService, AFileIsRunLikeAText) {
    EXPECT_TRUE(runMain("var int a = 20\nfor (var int i = 0; i < 4; i = i + 1) { a = a + i }\ncount = a"));
    EXPECT_EQ(26, host.count);
}

TEST_F(ScriptsOfService, OneSyntaxErrorKeepsAllFromBeingExecuted) {
    EXPECT_FALSE(eval("count = 1\ncount = = 2\ncount = 3\n)\n"));
    EXPECT_EQ(0, host.count);
    const std::string text = logged();
    EXPECT_THAT(text, StartsWith("eval():2:9: error: [OPS0"));
    EXPECT_THAT(text, HasSubstr("eval():4:1: error: [OPS0"));
}

TEST_F(ScriptsOfService, AStatementThatCannotBeResolvedStopsTheScript) {
    EXPECT_FALSE(runMain("count = 1\ncuont = 2\ncount = 3\n"));
    EXPECT_EQ(1, host.count);
    EXPECT_THAT(logged(), StartsWith("main.ops:2:1: error: [OPS1"));
}

TEST_F(ScriptsOfService, AStatementThatFailsStopsTheScript) {
    EXPECT_FALSE(runMain("count = 1\n  host.fail()\ncount = 3\n"));
    EXPECT_EQ(1, host.count);
    EXPECT_EQ(
        "ERROR: operation 'fail' threw in component 'host': the arm is stuck\n"
        "main.ops:2:3: error: [OPS400] the arm is stuck\n"
        "  host.fail()\n"
        "  ^\n",
        logged());
}

TEST_F(ScriptsOfService, FalseIsNoFailure) {
    EXPECT_TRUE(eval("refuse()\ncount = 2"));
    EXPECT_EQ(2, host.count);
}

TEST_F(ScriptsOfService, YieldsAreCounted) {
    EXPECT_TRUE(eval("var int i = 0\nwhile (i < 50) { i = i + 1\n yield }\ncount = i"));
    EXPECT_EQ(50, host.count);
    EXPECT_FALSE(eval("count = 1\nwhile (true) { yield }\ncount = 2"));
    EXPECT_EQ(1, host.count);
    EXPECT_THAT(logged(), StartsWith("eval():2:16: error: [OPS410] the statement yielded 10000 times and did not "
                                     "end; what has to wait longer belongs into a program\n"));
}

TEST_F(ScriptsOfService, NothingWaitsAsLongAsItTakes) {
    EXPECT_TRUE(
        eval("int later() { var int i = 0\nwhile i < 10100 { i = i + 1\n nothing }\nreturn i }\n"
             "count = later()"))
        << logged();
    EXPECT_EQ(10100, host.count);
}

TEST_F(ScriptsOfService, AMissingFileIsAnError) {
    EXPECT_FALSE(service->runScript("/nowhere/x.ops"));
    EXPECT_EQ("/nowhere/x.ops: error: [OPS411] cannot read the script: No such file or directory\n", logged());
    EXPECT_FALSE(service->runScript("/tmp"));
    EXPECT_EQ("/tmp: error: [OPS411] cannot read the script: Is a directory\n", logged());
}

TEST_F(ScriptsOfService, AnEmptyFileIsAScript) { EXPECT_TRUE(runMain("")); }

TEST_F(ScriptsOfService, VariablesEndWithTheirScript) {
    EXPECT_TRUE(eval("var int a = 1"));
    EXPECT_FALSE(eval("count = a"));
    EXPECT_THAT(logged(), HasSubstr("[OPS1"));
}

TEST_F(ScriptsOfService, AScriptThatIsRunByAnotherSeesItsVariables) {
    directory.write("parts/inner.ops", "a = a + 1\nvar int b = 5\nscripting.eval(\"count = a + b\")\n");
    EXPECT_TRUE(
        runMain("var int a = 1\nscripting.runScript(\"parts/inner.ops\")\nvar int b = 100\ncount = count + b\n"));
    EXPECT_EQ(107, host.count);
}

TEST_F(ScriptsOfService, VariablesOfAScriptThatWasRunAreNotSeen) {
    directory.write("inner.ops", "var int b = 5\n");
    EXPECT_FALSE(runMain("scripting.runScript(\"inner.ops\")\ncount = b\n"));
    EXPECT_THAT(logged(), StartsWith("main.ops:2:"));
}

TEST_F(ScriptsOfService, AFileIsAlsoFoundBesideTheScriptThatRunsIt) {
    directory.write("parts/outer.ops", "scripting.runScript(\"inner.ops\")\n");
    directory.write("parts/inner.ops", "count = 12\n");
    std::filesystem::current_path(directory.path());
    EXPECT_TRUE(service->runScript("parts/outer.ops"));
    EXPECT_EQ(12, host.count);
}

TEST_F(ScriptsOfService, VariablesAreNotSeenByOtherComponents) {
    Host other("other");
    ASSERT_TRUE(other.loadService("scripting"));
    ASSERT_TRUE(host.addPeer(&other));
    EXPECT_TRUE(eval("var int a = 3\nother.scripting.eval(\"count = a\")\n"));
    EXPECT_EQ(0, other.count);
    EXPECT_THAT(logged(), StartsWith("eval():1:9: error: [OPS1"));
}

TEST_F(ScriptsOfService, AScriptThatFailsDoesNotEndTheOneThatRunsIt) {
    directory.write("inner.ops", "fail()\n");
    EXPECT_TRUE(runMain("var bool good = scripting.runScript(\"inner.ops\")\nif (!good) then count = 9\n"));
    EXPECT_EQ(9, host.count);
    EXPECT_THAT(logged(), HasSubstr("inner.ops:1:1: error: [OPS400] the arm is stuck\n"));
}

TEST_F(ScriptsOfService, TheOldNamesOfEvalWork) {
    EXPECT_EQ(0, service->execute("count = 4"));
    EXPECT_EQ(-1, service->execute("count = "));
    EXPECT_TRUE(service->doExecute("count = 5"));
    EXPECT_TRUE(service->evalInternal("console", "count = 6"));
    EXPECT_EQ(6, host.count);
    logged();
    EXPECT_FALSE(service->evalInternal("console", "fail()"));
    EXPECT_THAT(logged(), HasSubstr("console:1:1: error: [OPS400] the arm is stuck\n"));
}

TEST_F(ScriptsOfService, AFunctionIsDefinedOnceInAScript) {
    EXPECT_FALSE(eval("void f() { }\nvoid g() { }\nvoid f() { }\ncount = 1"));
    EXPECT_EQ(
        "eval():3:6: error: [OPS201] function 'f' is defined twice in this script\n"
        "void f() { }\n"
        "     ^\n"
        "eval():1:6: note: first defined here\n"
        "void f() { }\n"
        "     ^\n",
        logged());
    EXPECT_EQ(0, host.count);
}

TEST_F(ScriptsOfService, TextsForProgramsTakeNothingElse) {
    EXPECT_FALSE(service->loadProgramText(
        "program p { }\ncount = 1\nStateMachine T { initial state s { } final state e { } }\n"));
    EXPECT_FALSE(service->hasProgram("p"));
    EXPECT_EQ(
        "string:2:1: error: [OPS412] found a statement, expected functions and programs only; runScript "
        "takes everything\n"
        "count = 1\n"
        "^\n"
        "string:3:1: error: [OPS412] found a type of state machines, expected functions and programs only; "
        "runScript takes everything\n"
        "StateMachine T { initial state s { } final state e { } }\n"
        "^\n",
        logged());
}

TEST_F(ScriptsOfService, TextsForStateMachinesTakeNothingElse) {
    EXPECT_FALSE(
        service->loadStateMachineText("void f() { }\nprogram p { }\nStateMachine T { initial state a { } final "
                                      "state b { } }\n"));
    EXPECT_EQ(
        "string: error: [OPS413] found no RootMachine, expected at least one\n"
        "string:1:1: error: [OPS412] found a function, expected state machines only; runScript takes everything\n"
        "void f() { }\n"
        "^\n"
        "string:2:1: error: [OPS412] found a program, expected state machines only; runScript takes everything\n"
        "program p { }\n"
        "^\n",
        logged());
}

TEST_F(ScriptsOfService, StatementsAreExecutedInTheOrderOfTheText) {
    EXPECT_TRUE(eval("note(\"a\")\nvoid f() { }\nnote(\"b\"); note(\"c\")\n"));
    EXPECT_THAT(host.notes, ElementsAre("a", "b", "c"));
}

TEST_F(ScriptsOfService, AServiceWithoutComponentRunsNothing) {
    const auto lonely = boost::make_shared<RTT::scripting::ScriptingService>(nullptr);
    EXPECT_FALSE(lonely->eval("count = 1"));
    EXPECT_EQ("ERROR: a script cannot be run: service 'scripting' belongs to no component\n", logged());
    EXPECT_FALSE(lonely->loadProgram(nullptr));
}

TEST_F(ScriptsOfService, CannotRunThemselves) {
    EXPECT_FALSE(runMain("count = count + 1\nscripting.runScript(\"main.ops\")\nscripting.runScript(\"main.ops\")\n"));
    EXPECT_EQ(50, host.count);
    EXPECT_EQ("main.ops: error: [OPS414] scripts run each other more than 50 deep\n", logged());
    EXPECT_TRUE(runMain("count = 1\n"));
}

TEST_F(ScriptsOfService, HandlesOfTheirFunctionsDoNotKeepThem) {
    EXPECT_TRUE(eval("void f() { count = 5 }\nvar SendHandle h = scripting.f.send()\n"));
    host.step();
    EXPECT_EQ(5, host.count);
    const boost::weak_ptr<const RTT::OperationInterfacePart> part =
        RTT::OperationInterfacePart::hold(service->getPart("f"));
    ASSERT_FALSE(part.expired());
    service->clear();
    EXPECT_TRUE(part.expired());
}

TEST_F(ScriptsOfService, FunctionsCallWhatTheyWereDefinedWith) {
    EXPECT_TRUE(eval("int one() { return 1 }\nint f() { return one() }\n"));
    EXPECT_TRUE(eval("int one() { return 2 }\ncount = scripting.f()\n"));
    EXPECT_EQ(1, host.count);
    EXPECT_TRUE(eval("program p { count = 10 + f() }\np.start()\n"));
    host.step();
    EXPECT_EQ(11, host.count);
}

TEST_F(ScriptsOfService, OfAnotherComponentsThreadReportTheirErrorsThere) {
    Host other("other");
    const auto there = other.getProvider<RTT::scripting::ScriptingService>("scripting");
    other.addOperation("runs", [&](const std::string& text) { return there->evalInternal("there.ops", text); });
    other.provides()->setOperationThread("runs", RTT::OwnThread);
    ASSERT_TRUE(other.setActivity(new RTT::Activity(0, 0.0, nullptr, "other")));
    ASSERT_TRUE(other.getActivity()->start());
    host.addPeer(&other);
    logged();
    EXPECT_FALSE(service->evalInternal("here.ops",
                                       "var int x = 1\n"
                                       "if other.runs(\"count = 3\") then count = x\n"
                                       "if !other.runs(\"count = 4\\ncount = x\") then count = count + 1\n"
                                       "count = y\n"));
    other.getActivity()->stop();
    EXPECT_EQ(
        "there.ops:2:9: error: [OPS133] component 'other' has no value or operation 'x'\n"
        "count = x\n"
        "        ^\n"
        "here.ops:4:9: error: [OPS133] component 'host' has no value or operation 'y'\n"
        "count = y\n"
        "        ^\n",
        logged());
    EXPECT_EQ(4, other.count);
    EXPECT_EQ(2, host.count);
}

}  // namespace
