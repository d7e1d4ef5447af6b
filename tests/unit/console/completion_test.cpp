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
    std::string moreOf(const std::string& line) const { return console->complete(line).more(line); }
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
    EXPECT_THAT(wordsFor("tank.fill(untr"), ElementsAre());
    EXPECT_THAT(wordsFor("  untr"), ElementsAre("untrace"));
}

TEST_F(CompletionTest, WhereATypeIsDeclaredThereAreOnlyTypes) {
    for (const char* const line : {"var ", "const  ", "1; var ", "for (var "}) {
        EXPECT_THAT(wordsFor(line), IsSupersetOf({"double", "string", "ConnPolicy"})) << line;
        EXPECT_THAT(wordsFor(line), Not(Contains("start"))) << line;
        EXPECT_THAT(wordsFor(line), Not(Contains("tank"))) << line;
    }
    EXPECT_THAT(wordsFor("var doub"), ElementsAre("double"));
    EXPECT_THAT(wordsFor("var ta"), ElementsAre());
    EXPECT_THAT(wordsFor("var double x = ta"), ElementsAre("tank"));
    EXPECT_THAT(wordsFor("myvar ta"), ElementsAre("tank"));
}

TEST_F(CompletionTest, WithinAPieceOfScriptALineIsIndented) {
    answer("if true then {");
    EXPECT_EQ("    ", moreOf(""));
    EXPECT_EQ("    ", moreOf("    "));
    EXPECT_EQ("nk.", moreOf("    ta"));
}

TEST_F(CompletionTest, BehindAComponentThereAreItsMembers) {
    EXPECT_THAT(wordsFor("tank."), IsSupersetOf({"capacity", "label", "fillings", "fill", "flow", "level"}));
    EXPECT_THAT(wordsFor("tank."), Not(Contains("ls")));
}

TEST_F(CompletionTest, ADotFollowsWhatHasMembers) {
    EXPECT_EQ("nk.", moreOf("ta"));
    EXPECT_EQ(".", moreOf("tank"));
    EXPECT_EQ("el.", moreOf("1.0 + tank.lev"));
    EXPECT_EQ("ty", moreOf("tank.capaci"));
    EXPECT_EQ("pty", moreOf("tank.em"));
    EXPECT_EQ("", moreOf("tank.nothing"));
}

TEST_F(CompletionTest, NoDotFollowsWhereThereIsAChoice) {
    RTT::TaskContext other("tank2");
    plant.addPeer(&other);
    EXPECT_EQ("nk", moreOf("ta"));
    EXPECT_EQ("", moreOf("tank"));
    EXPECT_EQ(".", moreOf("tank2"));
}

TEST_F(CompletionTest, TheDotIsForWhatTheCommandTakes) {
    EXPECT_EQ("nk", moreOf("cd ta"));
    EXPECT_EQ("nk.", moreOf("help ta"));
    EXPECT_EQ("nk.", moreOf(".connect ta"));
    EXPECT_EQ("vel", moreOf(".connect tank.le"));
    tank->addPeer(pump.get());
    EXPECT_EQ("nk.", moreOf("cd ta"));
}

TEST_F(CompletionTest, CommandsTakeAPathThatEndsInADot) {
    answer("cd tank.");
    EXPECT_EQ("tank [U]> ", console->prompt());
    answer("cd ..");
    // Its thread may be beginning, and then the attributes that count its steps change.
    const auto begin = [](const std::string& text) { return text.substr(0, text.find("Attributes")); };
    EXPECT_EQ(begin(answer("ls tank")), begin(answer("ls tank.")));
    EXPECT_EQ(answer("help tank.level"), answer("help tank.level."));
    EXPECT_EQ(answer("tank.level"), answer("tank.level."));
    EXPECT_EQ(begin(answer("tank")), begin(answer("tank.")));
    EXPECT_EQ("", err.str());
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

TEST_F(CompletionTest, HelpTakesCommands) {
    EXPECT_THAT(wordsFor("help untr"), ElementsAre("untrace"));
    EXPECT_THAT(wordsFor("help .conn"), ElementsAre(".connect"));
}

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

TEST_F(CompletionTest, ABlankFollowsADotCommandThatTakesMore) {
    EXPECT_EQ("vide ", moreOf(".pro"));
    EXPECT_EQ(" ", moreOf(".provide"));
    EXPECT_EQ("", moreOf(".type"));
    EXPECT_EQ("", moreOf(".types"));
}

TEST_F(CompletionTest, TypesOfComponentsStandWhereOneIsLoaded) {
    EXPECT_THAT(wordsFor("loadComponent(\"tank2\", \"filling::T"), ElementsAre("filling::Tank"));
    EXPECT_THAT(wordsFor("Deployer.loadComponent( name , \"filling::"), ElementsAre("filling::Pump", "filling::Tank"));
    EXPECT_THAT(wordsFor("loadComponent(\"filling::"), ElementsAre());
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
