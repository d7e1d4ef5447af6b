// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Pieces of script that are typed.
#include "console_fixture.hpp"

#include <rtt/internal/DataSource.hpp>

namespace {

using testing::HasSubstr;
using testing::Not;

class ScriptInput : public ConsoleTest {};

TEST_F(ScriptInput, ShowsTheValueOfAnExpression) { EXPECT_EQ(" = 5\n", answer("2 + 3")); }

TEST_F(ScriptInput, SemicolonKeepsTheValueBack) {
    EXPECT_EQ("", answer("var int x = 3;"));
    EXPECT_EQ("", answer("x = 7; ;"));
    EXPECT_EQ(" = 7\n", answer("x"));
}

TEST_F(ScriptInput, OfSeveralStatementsTheLastAnswers) { EXPECT_EQ(" = 12\n", answer("var int y = 3; y = 4; y * 3")); }

TEST_F(ScriptInput, BlankLinesAndCommentsDoNothing) {
    EXPECT_EQ("", answer("\n   \n// nothing\n# nothing"));
    EXPECT_EQ("", err.str());
}

TEST_F(ScriptInput, CallWithoutResultSaysSo) { EXPECT_EQ(" = (void)\n", answer("tank.empty()")); }

TEST_F(ScriptInput, StatementsThatAreNoExpressionsSayNothing) {
    EXPECT_EQ("", answer("var int n = 0;\nwhile n < 5 { n = n + 1 }"));
    EXPECT_EQ(" = 5\n", answer("n"));
}

TEST_F(ScriptInput, ValuesOfPeersAreReadAndAssigned) {
    EXPECT_EQ(" = 1.5\n", answer("tank.capacity = 1.5"));
    EXPECT_EQ(" = 1.5\n", answer("tank.capacity"));
}

TEST_F(ScriptInput, OperationsOfAnotherThreadAreCalledAndSent) {
    answer("tank.capacity = 2.0; tank.configure(); tank.start()");
    EXPECT_EQ(" = true\n", answer("tank.fill(1.5)"));
    EXPECT_EQ(" = false\n", answer("tank.fill(2.5)"));
    EXPECT_EQ("", answer("var SendHandle h"));
    answer("h = tank.fill.send(0.5)");
    EXPECT_EQ("", err.str());
    answer("var bool filled = false;");
    EXPECT_EQ(" = SendSuccess\n", answer("h.collect(filled)"));
    EXPECT_EQ(" = true\n", answer("filled"));
}

TEST_F(ScriptInput, VariablesBecomeAttributesOfTheComponent) {
    EXPECT_EQ(" = 1.5\n", answer("var double x = 1.5"));
    ASSERT_TRUE(plant.provides()->hasAttribute("x"));
    answer("x = 2.5");
    auto* const value = RTT::internal::DataSource<double>::narrow(plant.getAttribute("x")->getDataSource().get());
    ASSERT_NE(nullptr, value);
    EXPECT_EQ(2.5, value->get());
    EXPECT_EQ("", err.str());
}

TEST_F(ScriptInput, VariablesOfOneComponentAreThereAfterComingBack) {
    answer("var int kept = 4");
    answer("cd tank\ncd ..");
    EXPECT_EQ(" = 4\n", answer("kept"));
}

TEST_F(ScriptInput, ConstantsCannotBeAssigned) {
    EXPECT_EQ(" = 3\n", answer("const int three = 3"));
    EXPECT_THAT(complaint("three = 4"), HasSubstr("typed:2:1: error: [OPS127]"));
}

TEST_F(ScriptInput, AliasesAreComputedAtEachUse) {
    answer("var int i = 1\nalias int twice = 2 * i\ni = 5");
    EXPECT_EQ(" = 10\n", answer("twice"));
}

TEST_F(ScriptInput, ANameThatIsTakenIsRefused) {
    EXPECT_THAT(complaint("cd tank\nvar double capacity = 1.0"),
                HasSubstr("typed:2:12: error: [OPS111] 'capacity' is a property of component 'tank' already"));
    EXPECT_FALSE(tank->provides()->hasAttribute("capacity"));
}

TEST_F(ScriptInput, AVariableThatIsDeclaredTwiceShowsTheFirstPlace) {
    EXPECT_EQ(
        "typed:3:12: error: [OPS111] 'x' is already declared in this script\n"
        "var double x\n"
        "           ^\n"
        "typed:1:9: note: first declared here\n"
        "var int x = 1\n"
        "        ^\n",
        complaint("var int x = 1\n\nvar double x"));
}

TEST_F(ScriptInput, ErrorsHaveACaretAndTheNearestName) {
    EXPECT_EQ(
        "typed:1:6: error: [OPS133] component 'tank' has no value or operation 'capasity'; did you mean 'capacity'?\n"
        "tank.capasity = 1.5\n"
        "     ^\n",
        complaint("tank.capasity = 1.5"));
    EXPECT_EQ("", out.str());
}

TEST_F(ScriptInput, LinesAreCountedAcrossTheSession) {
    EXPECT_THAT(complaint("1 + 1\nls\n2 +* 3"), HasSubstr("typed:3:4: error: "));
    EXPECT_THAT(err.str(), HasSubstr("\n2 +* 3\n"));
}

TEST_F(ScriptInput, AllSyntaxErrorsOfALineAreTold) {
    const std::string both = complaint("x = ; y = ;");
    EXPECT_THAT(both, HasSubstr("typed:1:5: error"));
    EXPECT_THAT(both, HasSubstr("typed:1:11: error"));
}

TEST_F(ScriptInput, AFailureIsTold) {
    EXPECT_THAT(complaint("1 / 0"), HasSubstr("typed:1:3: error: [OPS400] division by zero"));
}

TEST_F(ScriptInput, AnOpenBraceGoesOnInTheNextLines) {
    answer("var int sum = 0;");
    EXPECT_EQ("plant [S]> ", console->prompt());
    answer("for (var int i = 1; i < 5; i = i + 1) {");
    EXPECT_EQ("> ", console->prompt());
    EXPECT_EQ("", answer("    sum = sum + i"));
    EXPECT_EQ("", answer("}"));
    EXPECT_EQ("plant [S]> ", console->prompt());
    EXPECT_EQ(" = 10\n", answer("sum"));
}

TEST_F(ScriptInput, ErrorsInLaterLinesHaveTheirLine) {
    EXPECT_EQ(
        "typed:2:5: error: [OPS133] component 'plant' has no value or operation 'nothere'\n"
        "    nothere = 1\n"
        "    ^\n",
        complaint("if true then {\n    nothere = 1\n}"));
}

TEST_F(ScriptInput, APieceThatWasBegunCanBeForgotten) {
    answer("if true then {");
    console->forget();
    EXPECT_EQ(" = 2\n", answer("1 + 1"));
}

TEST_F(ScriptInput, AtTheEndOfTheInputWhatWasBegunIsTold) {
    answer("if true then {");
    console->finish();
    EXPECT_THAT(err.str(), HasSubstr("error: "));
}

TEST_F(ScriptInput, FunctionsAreDefinedAndCalled) {
    EXPECT_EQ("", answer("export int twice(int x) {\n  return 2 * x\n}"));
    EXPECT_EQ("", err.str());
    EXPECT_EQ(" = 14\n", answer("twice(7)"));
}

TEST_F(ScriptInput, ErrorsOfDefinitionsAreToldWithTheirPlace) {
    EXPECT_EQ(
        "typed:3:10: error: [OPS133] component 'plant' has no value or operation 'y'\n"
        "  return y\n"
        "         ^\n",
        complaint("1;\nexport int f(int x) {\n  return y\n}"));
    EXPECT_FALSE(plant.provides()->hasOperation("f"));
}

TEST_F(ScriptInput, ProgramsRunInTheComponent) {
    plant.setPeriod(0.001);
    answer(
        "var int steps = 0;\nprogram count { while steps < 3 { steps = steps + 1; yield } }\nplant.start(); "
        "count.start()");
    for (int i = 0; i < 2000 && answer("count.isRunning()") == " = true\n"; ++i) usleep(1000);
    EXPECT_EQ(" = 3\n", answer("steps"));
    plant.stop();
    answer(".unloadProgram count");
    EXPECT_EQ("", err.str());
}

TEST_F(ScriptInput, TheNameOfAComponentShowsItsInterface) {
    const std::string text = answer("tank");
    EXPECT_THAT(text, HasSubstr("Component tank\n"));
    EXPECT_THAT(text, HasSubstr("    bool fill(double level)\n"
                                "      Fills it up to a level. False if that is more than it holds.\n"
                                "      level  in m3\n"));
}

TEST_F(ScriptInput, TheNameOfAPortShowsIt) {
    EXPECT_EQ(
        "Input port flow  double\n"
        "  What comes in. [m3/s]\n"
        "    tank.flow.read(x)\n",
        answer("tank.flow"));
}

TEST_F(ScriptInput, AStatementThatDestroysTheComponentEndsTheVisit) {
    answer("cd tank");
    tank.reset();
    EXPECT_EQ("component 'tank' is gone; back in 'plant'\n", complaint("1 + 1"));
    EXPECT_EQ(" = 2\n", answer("1 + 1"));
    EXPECT_EQ("plant [S]> ", console->prompt());
}

TEST_F(ScriptInput, AnotherComponentOfTheSameNameIsVisitedAnew) {
    answer("cd tank\nvar int mine = 1");
    tank.reset();
    tank = loadTank("tank", "filling::Tank");
    plant.addPeer(tank.get());
    EXPECT_THAT(complaint("mine"), HasSubstr("component 'tank' has no value or operation 'mine'"));
}

TEST_F(ScriptInput, ASentCallIsAHandleAndSentOnce) {
    answer("tank.capacity = 1.0; tank.configure(); tank.start();");
    EXPECT_EQ(" = SendHandle\n", answer("tank.fill.send(0.5)"));
    answer("tank.fill(0.25)");
    EXPECT_EQ(" = 2\n", answer("tank.fillings"));
}

TEST_F(ScriptInput, WhoeverWantsToLeaveIsToldHow) {
    for (const char* const line : {"exit", "quit()", "bye;", " exit () "})
        EXPECT_THAT(complaint(line), testing::EndsWith("note: 'quit' leaves the console\n")) << line;
    EXPECT_THAT(complaint("exits"), testing::Not(testing::HasSubstr("note: 'quit'")));
}

}  // namespace
