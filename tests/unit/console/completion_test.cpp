// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "console_fixture.hpp"

namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsSupersetOf;
using testing::Not;

class CompletionTest : public ConsoleTest {
protected:
    std::vector<std::string> wordsFor(const std::string& line) const { return console->complete(line).words; }
};

TEST_F(CompletionTest, TheLineEndsInWhatIsReplaced) {
    const auto found = console->complete("1 + tank.capa");
    EXPECT_EQ(9u, found.begin);
    EXPECT_THAT(found.words, ElementsAre("capacity"));
}

TEST_F(CompletionTest, CommonIsWhatAllWordsBeginWith) {
    EXPECT_EQ("f", console->complete("tank.f").common());
    EXPECT_THAT(wordsFor("tank.fi"), ElementsAre("fill", "fillings"));
    EXPECT_EQ("fill", console->complete("tank.fi").common());
    EXPECT_EQ("", console->complete("nothing like it").common());
}

TEST_F(CompletionTest, AtTheBeginningThereAreCommandsPeersOperationsTypesAndGlobals) {
    EXPECT_THAT(wordsFor(""), IsSupersetOf({"ls", "quit", "tank", "pump", "start", "double", "ORO_SCHED_RT"}));
    EXPECT_THAT(wordsFor("ta"), ElementsAre("tank"));
    EXPECT_THAT(wordsFor("Conn"), ElementsAre("ConnPolicy"));
}

TEST_F(CompletionTest, CommandsStandOnlyFirst) {
    EXPECT_THAT(wordsFor("untr"), ElementsAre("untrace"));
    EXPECT_THAT(wordsFor("1 + untr"), ElementsAre());
}

TEST_F(CompletionTest, BehindAComponentThereAreItsMembers) {
    EXPECT_THAT(wordsFor("tank."), IsSupersetOf({"capacity", "label", "fillings", "fill", "flow", "level"}));
    EXPECT_THAT(wordsFor("tank."), Not(Contains("ls")));
}

TEST_F(CompletionTest, BehindAnOperationThereIsSend) { EXPECT_THAT(wordsFor("tank.fill.s"), ElementsAre("send")); }

TEST_F(CompletionTest, BehindAValueThereAreItsMembers) {
    answer("var ConnPolicy policy;");
    EXPECT_THAT(wordsFor("policy.si"), ElementsAre("size"));
    EXPECT_THAT(wordsFor("policy.nothing"), ElementsAre());
}

TEST_F(CompletionTest, ArgumentsAreExpressions) {
    EXPECT_THAT(wordsFor("tank.fill(tank.capa"), ElementsAre("capacity"));
}

TEST_F(CompletionTest, CdTakesPeersAndLsServicesToo) {
    tank->loadService("scripting");
    EXPECT_THAT(wordsFor("cd "), ElementsAre("pump", "tank"));
    EXPECT_THAT(wordsFor("cd tank."), ElementsAre());
    EXPECT_THAT(wordsFor("ls tank.scr"), ElementsAre("scripting"));
}

TEST_F(CompletionTest, HelpTakesOperations) { EXPECT_THAT(wordsFor("help tank.emp"), ElementsAre("empty")); }

TEST_F(CompletionTest, ListTakesProgramsAndStateMachines) {
    answer("program count { yield }");
    EXPECT_THAT(wordsFor("list "), ElementsAre("count"));
    EXPECT_THAT(wordsFor("untrace co"), ElementsAre("count"));
}

TEST_F(CompletionTest, DotCommandsAndTheirArguments) {
    EXPECT_THAT(wordsFor(".type"), ElementsAre(".typekits", ".types"));
    EXPECT_THAT(wordsFor(".provide scr"), ElementsAre("scripting"));
    EXPECT_THAT(wordsFor(".connect pump.flow tank.fl"), ElementsAre("flow"));
}

TEST_F(CompletionTest, FilesStandInTextsAndBehindCommands) {
    const oroforge::test::TempDir directory;
    directory.write("start.ops", "");
    directory.write("stop.ops", "");
    directory.write("sub/x.ops", "");
    const std::string path = directory.path().string() + "/";
    const auto found = console->complete("runScript(\"" + path + "st");
    EXPECT_EQ(11u + path.size(), found.begin);
    EXPECT_THAT(found.words, ElementsAre("start.ops", "stop.ops"));
    EXPECT_THAT(wordsFor(".loadProgram " + path + "su"), ElementsAre("sub/"));
}

TEST_F(CompletionTest, BehindAClosedTextThereAreExpressions) {
    EXPECT_THAT(wordsFor("\"text\" + tank.capa"), ElementsAre("capacity"));
}

TEST_F(CompletionTest, ServicesOfAllComponentsAndTheirOperations) {
    plant.loadService("scripting");
    EXPECT_THAT(wordsFor("scripting.loadProg"), ElementsAre("loadProgramText", "loadPrograms"));
}

}  // namespace
