// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The texts of programs and state machines.
#include "console_fixture.hpp"

#include <rtt/extras/SlaveActivity.hpp>

namespace {

using testing::HasSubstr;
using testing::Not;

class ListProgram : public ConsoleTest {
protected:
    /** Executes one step of the component. */
    void step() { plant.engine()->getActivity()->execute(); }
    ListProgram() {
        plant.setActivity(new RTT::extras::SlaveActivity(0.01));
        answer("\n\nprogram count {\n  yield\n  yield\n  yield\n}");
        plant.start();
    }
};

TEST_F(ListProgram, ShowsItsLinesWithTheirNumbersInTheirFile) {
    EXPECT_EQ(
        "   3 program count {\n"
        "   4   yield\n"
        "   5   yield\n"
        "   6   yield\n"
        "   7 }\n",
        answer("list count"));
}

TEST_F(ListProgram, BeforeTheBeginTheFirstLinesAreShown) {
    answer(std::string(20, '\n') + "program late {\n  yield\n}");
    const std::string all = answer("list late");
    EXPECT_THAT(all, HasSubstr(" program late {\n"));
    EXPECT_EQ(all, answer("list late 1"));
}

TEST_F(ListProgram, BehindTheEndItSaysSo) {
    answer("list count");
    EXPECT_EQ("'count' ends with line 7\n", answer("list"));
    EXPECT_EQ("'count' ends with line 7\n", answer("list count 100"));
    EXPECT_EQ("'count' ends with line 7\n", answer("list 99999999999999999999"));
}

TEST_F(ListProgram, TraceWithoutProgramsSaysSo) {
    EXPECT_EQ("component 'tank' has no programs or state machines\n", answer("cd tank\ntrace"));
}

TEST_F(ListProgram, MarksTheLineItIsAt) {
    answer("count.start()");
    step();
    EXPECT_THAT(answer("list count"), HasSubstr("   4   yield\nR> 5   yield\n   6   yield\n"));
    answer("count.pause()");
    step();
    EXPECT_THAT(answer("list count"), HasSubstr("P> 5   yield\n"));
}

TEST_F(ListProgram, OfAFileTheNumbersAreThoseOfTheFile) {
    const oroforge::test::TempDir directory;
    directory.write("m.osd",
                    "// A comment\n"
                    "StateMachine M {\n"
                    "  initial state A {\n"
                    "    run { yield }\n"
                    "  }\n"
                    "  final state B { }\n"
                    "}\n"
                    "RootMachine M m\n");
    answer(".loadStateMachine " + (directory / "m.osd").string());
    answer("m.activate(); m.start()");
    step();
    EXPECT_THAT(answer("list m"), testing::AllOf(testing::StartsWith("   1 // A comment\n   2 StateMachine M {\n"),
                                                 HasSubstr("R> 4     run { yield }\n")));
    answer(".unloadStateMachine m");
}

TEST_F(ListProgram, TraceShowsItWhenItHasMoved) {
    EXPECT_THAT(answer("trace count"), HasSubstr("   4   yield\n"));
    out.str("");
    console->prompt();
    EXPECT_EQ("", out.str());
    answer("count.start()");
    step();
    out.str("");
    console->prompt();
    EXPECT_THAT(out.str(), testing::AllOf(testing::StartsWith("count: running\n"), HasSubstr("R> 5   yield\n")));
    out.str("");
    console->prompt();
    EXPECT_EQ("", out.str());
    step();
    answer("untrace count");
    out.str("");
    console->prompt();
    EXPECT_EQ("", out.str());
}

TEST_F(ListProgram, TraceWithoutANameTracesAll) {
    EXPECT_THAT(answer("trace"), HasSubstr("   3 program count {\n"));
    answer("count.start()");
    step();
    out.str("");
    console->prompt();
    EXPECT_THAT(out.str(), HasSubstr("count: running\n"));
    answer("untrace");
    step();
    out.str("");
    console->prompt();
    EXPECT_EQ("", out.str());
}

TEST_F(ListProgram, OfAnUnknownNameTheNearestIsTold) {
    EXPECT_THAT(complaint("list cuont"),
                HasSubstr("component 'plant' has no program or state machine 'cuont'; did you mean 'count'?"));
    EXPECT_THAT(complaint("trace cuont"), HasSubstr("did you mean 'count'?"));
    EXPECT_THAT(complaint("untrace count"), HasSubstr("'count' is not traced"));
}

TEST_F(ListProgram, WithoutANameItGoesOnWithTheLast) {
    EXPECT_THAT(complaint("list"), HasSubstr("nothing was listed before"));
    answer("list count 1");
    EXPECT_EQ("   6   yield\n   7 }\n", answer("list 6"));
    EXPECT_THAT(complaint("list count x"), HasSubstr("expected the number of a line, found 'x'"));
}

}  // namespace
