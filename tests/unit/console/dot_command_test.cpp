// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Commands that begin with a dot.
#include "console_fixture.hpp"

namespace {

using oroforge::test::TempDir;
using testing::HasSubstr;

/** In a directory of its own. */
class DotCommands : public ConsoleTest {
protected:
    DotCommands() : before_(std::filesystem::current_path()) { std::filesystem::current_path(directory_.path()); }
    ~DotCommands() override { std::filesystem::current_path(before_); }
    TempDir directory_;

private:
    const std::filesystem::path before_;
};

TEST_F(DotCommands, TypesTypekitsServicesAndPluginsAreNamed) {
    EXPECT_THAT(answer(".types"), testing::AllOf(HasSubstr("Types:\n"), HasSubstr("double"), HasSubstr("ConnPolicy")));
    EXPECT_THAT(answer(".typekits"), HasSubstr("Typekits:\n"));
    EXPECT_THAT(answer(".services"), HasSubstr("scripting"));
    EXPECT_THAT(answer(".plugins"), HasSubstr("scripting"));
}

TEST_F(DotCommands, HexShowsWholeNumbersInHexadecimal) {
    EXPECT_EQ(" = 0xff\n", answer(".hex\n255"));
    EXPECT_EQ(" = 255\n", answer(".nohex\n255"));
}

TEST_F(DotCommands, ProvideLoadsServices) {
    EXPECT_EQ("service 'scripting' loaded into component 'plant'\n", answer(".provide scripting"));
    EXPECT_TRUE(plant.provides()->hasService("scripting"));
    EXPECT_EQ("component 'plant' has service 'scripting' already\n", answer(".provide scripting"));
    EXPECT_THAT(complaint(".provide scriptign"),
                HasSubstr("typed:3:10: error: service 'scriptign' cannot be loaded; did you mean 'scripting'?"));
    EXPECT_THAT(complaint(".provide"), HasSubstr("typed:4:9: error: expected the names of services"));
}

TEST_F(DotCommands, ConnectJoinsTwoPorts) {
    EXPECT_EQ("pump.flow and tank.flow are connected\n", answer(".connect pump.flow tank.flow"));
    EXPECT_TRUE(tank->getPort("flow")->connectedTo(pump->getPort("flow")));
    EXPECT_THAT(complaint(".connect pump.flow tank.flwo"),
                HasSubstr("typed:2:25: error: 'tank' has no port 'flwo'; did you mean 'flow'?"));
}

TEST_F(DotCommands, RecordMakesAFunctionInAFile) {
    answer("var int n = 1;");
    EXPECT_EQ(
        "recording; '.end' keeps it as twice.ops, '.cancel' does not\n"
        "export function twice {\n",
        answer(".record twice"));
    EXPECT_EQ("> ", console->prompt());
    EXPECT_EQ("", answer("n = n * 2"));
    EXPECT_EQ("}\nwritten to twice.ops and loaded into component 'plant'\n", answer(".end"));
    EXPECT_EQ("", err.str());
    EXPECT_EQ(
        "/* TaskBrowser macro 'twice' */\n\n"
        "export function twice {\n"
        "    n = n * 2\n"
        "}\n",
        oroforge::test::readFile("twice.ops"));
    EXPECT_EQ(" = 2\n", answer("twice(); n"));
}

TEST_F(DotCommands, CancelForgetsWhatIsRecorded) {
    answer(".record gone\n1 + 1\n.cancel");
    EXPECT_EQ("plant [S]> ", console->prompt());
    EXPECT_FALSE(std::filesystem::exists("gone.ops"));
    EXPECT_THAT(complaint(".end"), HasSubstr("error: nothing is being recorded"));
}

TEST_F(DotCommands, WhatIsRecordedHasAName) {
    EXPECT_THAT(complaint(".record 9x"), HasSubstr("typed:1:9: error: expected a name for the function, found '9x'"));
    EXPECT_THAT(complaint(".record ../x"), HasSubstr("found '../x'"));
    EXPECT_EQ("plant [S]> ", console->prompt());
}

TEST_F(DotCommands, OneFunctionIsRecordedAtATime) {
    answer(".record first\n1 + 1");
    EXPECT_THAT(complaint(".record second"),
                HasSubstr("error: 'first' is being recorded; '.end' or '.cancel' ends that"));
    EXPECT_THAT(answer(".end"), HasSubstr("written to first.ops"));
}

TEST_F(DotCommands, AFileThatWasNotRecordedIsKept) {
    directory_.write("startup.ops", "1 + 1\n");
    EXPECT_THAT(complaint(".record startup"), HasSubstr("error: there is a file 'startup.ops' that was not recorded"));
    EXPECT_EQ("plant [S]> ", console->prompt());
    for (const char* const line : {"1", "2"}) answer(".record mine\n" + std::string(line) + "\n.end");
    EXPECT_EQ("", err.str());
    EXPECT_THAT(oroforge::test::readFile("mine.ops"), HasSubstr("    2\n"));
}

TEST_F(DotCommands, ARecordedLineThatIsWrongIsTold) {
    answer(".record wrong\nnothere = 1");
    EXPECT_THAT(complaint(".end"), testing::AllOf(HasSubstr("wrong.ops:4:5: error: [OPS133]"),
                                                  HasSubstr("written to wrong.ops, but not loaded")));
    EXPECT_FALSE(plant.provides()->hasOperation("wrong"));
}

TEST_F(DotCommands, ProgramsAreLoadedFromFilesAndUnloaded) {
    directory_.write("p.ops", "program p { yield }\n");
    answer(".loadProgram p.ops");
    EXPECT_TRUE(plant.provides()->hasService("p"));
    answer(".unloadProgram p");
    EXPECT_FALSE(plant.provides()->hasService("p"));
    EXPECT_EQ("", err.str());
    EXPECT_THAT(complaint(".unloadProgram p"), HasSubstr("typed:3:16: error: that failed; the log says why"));
}

TEST_F(DotCommands, StateMachinesAreLoadedFromFilesAndUnloaded) {
    directory_.write("m.osd", "StateMachine M {\n  initial state A { }\n  final state B { }\n}\nRootMachine M m\n");
    answer(".loadStateMachine m.osd");
    EXPECT_TRUE(plant.provides()->hasService("m"));
    const std::string text = answer("ls");
    EXPECT_THAT(text, HasSubstr("\n  Services\n    scripting  "));
    EXPECT_THAT(text, HasSubstr("\n  State machines\n    m  inactive\n"));
    EXPECT_EQ(text.find("    m "), text.rfind("    m "));  // not among the services
    answer(".unloadStateMachine m");
    EXPECT_FALSE(plant.provides()->hasService("m"));
}

TEST_F(DotCommands, AnUnknownOneNamesTheNearest) {
    EXPECT_EQ(
        "typed:1:1: error: there is no command '.servces'; did you mean '.services'?\n"
        ".servces\n"
        "^\n",
        complaint(".servces"));
}

TEST_F(DotCommands, EveryCommandOfTheHelpIsThere) {
    const std::string help = answer("help");
    for (const char* const word : {".dark", ".light", ".nocolors", ".hex", ".nohex", ".record", ".end", ".cancel",
                                   ".provide", ".services", ".typekits", ".types", ".plugins"})
        EXPECT_THAT(help, HasSubstr(std::string("    ") + word)) << word;
}

}  // namespace
