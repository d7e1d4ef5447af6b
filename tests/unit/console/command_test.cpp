// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// ls, cd, peers, help, leave and enter.
#include "console_fixture.hpp"

#include <console/table.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>

namespace {

using testing::HasSubstr;
using testing::Not;

class Commands : public ConsoleTest {};

TEST_F(Commands, LsShowsAComponentInAlignedTables) {
    answer("tank.capacity = 1.5; tank.configure(); tank.start()");
    const std::string text = answer("ls tank");
    EXPECT_THAT(text, testing::StartsWith("Component tank [R]\n"
                                          "\n"
                                          "  Properties\n"
                                          "    capacity  double  = 1.5      m3  What it holds.\n"
                                          "    label     string  = \"water\"      What is written on its side.\n"));
    EXPECT_THAT(text, HasSubstr("\n  Ports\n"
                                "    in   flow   double       not connected  What comes in. [m3/s]\n"
                                "    out  level  double  = 0  not connected  What is in it. [m3]\n"));
    EXPECT_THAT(text, HasSubstr("    fillings        int   = 0\n"));
}

TEST_F(Commands, OperationsOfTheComponentComeBeforeThoseOfEveryOne) {
    EXPECT_THAT(answer("ls tank"),
                HasSubstr("\n  Operations\n    empty  fill\n\n  Operations of every component\n    activate "));
    EXPECT_THAT(answer("ls"),
                testing::AllOf(Not(HasSubstr("  Operations\n")), HasSubstr("  Operations of every component\n")));
    plant.loadService("scripting");
    EXPECT_THAT(answer("ls scripting"), testing::AllOf(HasSubstr("  Operations\n"), Not(HasSubstr("every component"))));
    EXPECT_THAT(answer("help tank"), testing::ContainsRegex("\n  Operations\n    void empty(.|\n)*bool fill(.|\n)*"
                                                            "\n  Operations of every component\n    bool activate"));
}

TEST_F(Commands, LookingConnectsNoPort) {
    answer("ls tank\ncd tank\nls\nhelp tank\ntank.flow");
    EXPECT_FALSE(tank->getPort("flow")->connected());
    EXPECT_FALSE(tank->getPort("level")->connected());
}

TEST_F(Commands, LsNamesTheOtherEndOfAConnection) {
    answer(".connect pump.flow tank.flow");
    EXPECT_THAT(answer("ls tank"), HasSubstr("in   flow   double  <- pump.flow"));
    EXPECT_THAT(answer("ls pump"), HasSubstr("out  flow  double  -> tank.flow"));
}

TEST_F(Commands, LsShowsPeersWithTheirStates) {
    EXPECT_THAT(answer("ls"), HasSubstr("\n  Peers\n    pump [S]  tank [U]\n"));
    EXPECT_EQ("pump  [S]\ntank  [U]\n", answer("peers"));
    EXPECT_EQ("component 'tank' has no peers\n", answer("cd tank\npeers"));
}

TEST_F(Commands, LsOfAServiceShowsItsOperations) {
    answer("if true then { }");
    plant.loadService("scripting");
    const std::string text = answer("ls scripting");
    EXPECT_THAT(text, testing::StartsWith("Service scripting  Runs scripts"));
    EXPECT_THAT(text, HasSubstr("loadPrograms"));
}

struct Odd {};

TEST_F(Commands, LsTellsWhatAnUnknownTypeIs) {
    const char* const note = "\n  unknown_t: no typekit that is loaded has this type\n";
    EXPECT_THAT(answer("ls"), Not(HasSubstr(note)));
    {
        RTT::OutputPort<Odd> port("odd");
        plant.ports()->addPort(port);
        EXPECT_THAT(answer("ls"), HasSubstr(note));
    }
    EXPECT_THAT(answer("ls"), Not(HasSubstr(note)));
    Odd odd;
    plant.addProperty("odd", odd);
    EXPECT_THAT(answer("ls"), HasSubstr(note));
}

TEST_F(Commands, LsOfAnUnknownPathNamesTheNearest) {
    EXPECT_EQ(
        "typed:1:5: error: there is no peer or service 'tnak'; did you mean 'tank'?\n"
        "ls  tnak\n"
        "    ^\n",
        complaint("ls  tnak"));
    EXPECT_THAT(complaint("ls tank.scriptign"), HasSubstr("typed:2:9: error: there is no peer or service 'scriptign'"));
    EXPECT_THAT(complaint("cd ../.."), HasSubstr("typed:3:4: error: expected the name of a peer or service\n"));
}

TEST_F(Commands, CdGoesToPeersAndBack) {
    EXPECT_EQ("plant [S]> ", console->prompt());
    answer("cd tank");
    EXPECT_EQ("tank [U]> ", console->prompt());
    EXPECT_EQ(" = 0\n", answer("capacity"));
    answer("cd ..");
    EXPECT_EQ("plant [S]> ", console->prompt());
    answer("cd pump\ncd");
    EXPECT_EQ("plant [S]> ", console->prompt());
    EXPECT_EQ("", err.str());
}

TEST_F(Commands, CdBeyondTheFirstVisitIsAnError) {
    EXPECT_EQ("typed:1:4: error: there was no visit before this one\ncd ..\n   ^\n", complaint("cd .."));
}

TEST_F(Commands, CdFollowsAPathOfPeers) {
    tank->addPeer(pump.get());
    answer("cd tank.pump");
    EXPECT_EQ("pump [S]> ", console->prompt());
}

TEST_F(Commands, CdToAServiceIsAnError) {
    plant.loadService("scripting");
    EXPECT_THAT(complaint("cd scripting"),
                HasSubstr("typed:1:4: error: 'scripting' is a service, expected a component"));
    EXPECT_EQ("plant [S]> ", console->prompt());
}

TEST_F(Commands, CdToWhereOneIsChangesNothing) { EXPECT_EQ("already in tank\n", answer("cd tank\ncd this")); }

TEST_F(Commands, CommandsAreWholeWords) {
    EXPECT_THAT(complaint("lsfoo"), HasSubstr("error: [OPS133]"));
    EXPECT_THAT(complaint("entering"), HasSubstr("error: [OPS133]"));
    EXPECT_EQ(" = 3\n", answer("var int list = 3"));
    EXPECT_EQ(" = 4\n", answer("list = 4"));
    EXPECT_EQ(" = 4\n", answer("this.list"));
}

TEST_F(Commands, WordsThatACommandDoesNotTakeAreErrors) {
    EXPECT_EQ(
        "typed:1:9: error: 'cd' takes [PATH], found 'pump' as well\n"
        "cd tank pump\n"
        "        ^\n",
        complaint("cd tank pump"));
    EXPECT_EQ("plant [S]> ", console->prompt());
    EXPECT_THAT(complaint("quit now"), HasSubstr("error: 'quit' takes nothing, found 'now' as well"));
    EXPECT_FALSE(console->quits());
    EXPECT_THAT(complaint(".connect a b c"), HasSubstr("'.connect' takes PORT PORT, found 'c' as well"));
}

TEST_F(Commands, WhatIsShownFitsIntoTheTerminal) {
    console->screen().width = [] { return std::size_t(60); };
    console->screen().cutsTables = true;
    plant.loadService("scripting");
    for (const char* const line :
         {"help", "help cd", "help leave", "ls", "tank", "scripting", "help scripting.eval", "ls scripting", "peers",
          ".services", ".types", "help tank.capacity", "help tank.level"}) {
        std::istringstream shown(answer(line));
        for (std::string row; std::getline(shown, row);)
            EXPECT_LE(OCL::console::widthOf(row), 60u) << line << ": " << row;
    }
    EXPECT_THAT(answer("help"), HasSubstr("goes to a peer; '..' is the\n"));
}

TEST_F(Commands, ALongValueLeavesRoomForTheDocumentation) {
    console->screen().width = [] { return std::size_t(80); };
    console->screen().cutsTables = true;
    std::string text(60, 'x');
    plant.addProperty("text", text).doc("what is to be told to all who listen");
    EXPECT_THAT(answer("ls"), HasSubstr("x…  what is to be told to all who l…"));
    plant.properties()->removeProperty(plant.getProperty("text"));
}

TEST_F(Commands, GlobalsAreShown) {
    for (const char* const line : {"GlobalsRepository", "ls GlobalsRepository", "help GlobalsRepository"})
        EXPECT_THAT(answer(line), testing::ContainsRegex("^Globals\n\n  Attributes\n(.*\n)*    ORO_SCHED_RT "));
}

TEST_F(Commands, LeaveConnectsTheConsoleAndEnterDisconnectsIt) {
    answer("tank.capacity = 1.5; tank.configure(); tank.start()");
    answer("cd tank\nleave");
    EXPECT_EQ("", err.str());
    EXPECT_EQ("Watching tank [R]> ", console->prompt());
    EXPECT_TRUE(tank->getPort("level")->connected());
    EXPECT_TRUE(tank->getPort("flow")->connected());
    answer("var double x = 0.0;");
    EXPECT_EQ(" = NewData\n", answer("tank.fill(0.5); level.read(x)"));
    EXPECT_EQ(" = 0.5\n", answer("x"));
    answer("enter");
    EXPECT_EQ("tank [R]> ", console->prompt());
    EXPECT_FALSE(tank->getPort("level")->connected());
    EXPECT_EQ(nullptr, browser.getPort("level"));
}

TEST_F(Commands, AWatchedComponentThatGoesIsLeft) {
    answer("cd tank\nleave");
    tank.reset();
    EXPECT_EQ("component 'tank' is gone; back in 'plant'\n", complaint("1"));
    EXPECT_EQ("plant [S]> ", console->prompt());
}

TEST_F(Commands, HelpExplainsTheConsole) {
    const std::string text = answer("help");
    for (const char* const part : {"ls [PATH]", ".provide SERVICE…", "Ctrl-R", "tank.fill.send(1.5)"})
        EXPECT_THAT(text, HasSubstr(part));
}

TEST_F(Commands, HelpExplainsACommand) {
    EXPECT_EQ("peers  shows the peers and their states\n", answer("help peers"));
    EXPECT_THAT(answer("help .hex"), HasSubstr("hexadecimal"));
}

TEST_F(Commands, HelpExplainsAnOperation) {
    EXPECT_EQ(
        "bool fill(double level)\n"
        "  Fills it up to a level. False if that is more than it holds.\n"
        "  level  in m3\n",
        answer("help tank.fill"));
    EXPECT_EQ("void empty()\n  Empties it.\n", answer("cd tank\nhelp empty"));
}

TEST_F(Commands, HelpExplainsAProperty) {
    EXPECT_EQ("Property capacity  double  = 0 m3\n  What it holds.\n", answer("help tank.capacity"));
}

TEST_F(Commands, HelpShowsTheMembersOfAStruct) {
    answer("var ConnPolicy policy;");
    const std::string text = answer("help policy");
    EXPECT_THAT(text, testing::StartsWith("Attribute policy  ConnPolicy  = {type = 0, "));
    EXPECT_THAT(text, HasSubstr("\n    .size "));
}

TEST_F(Commands, HelpForSomethingUnknownNamesTheNearest) {
    EXPECT_THAT(complaint("help tank.capasity"),
                HasSubstr("typed:1:11: error: there is nothing called 'capasity' here; did you mean 'capacity'?"));
    EXPECT_THAT(complaint("help qiut"), HasSubstr("did you mean 'quit'?"));
}

TEST_F(Commands, QuitEnds) {
    EXPECT_FALSE(console->quits());
    answer("quit");
    EXPECT_TRUE(console->quits());
}

TEST_F(Commands, TheEndOfTheFirstComponentEnds) {
    auto root = std::make_unique<RTT::TaskContext>("root");
    OCL::console::Console other(browser, *root, out, err, "typed");
    root.reset();
    other.execute("1 + 1");
    EXPECT_TRUE(other.quits());
    EXPECT_EQ("component 'root' is gone\n", err.str());
}

TEST_F(Commands, ColoursAreInThePromptAndOutput) {
    answer(".dark");
    EXPECT_THAT(console->prompt(), HasSubstr("\033["));
    EXPECT_THAT(answer("peers"), HasSubstr("\033["));
    answer(".nocolors");
    EXPECT_EQ("plant [S]> ", console->prompt());
}

TEST_F(Commands, LocalOperationsAreNotForTools) {
    RTT::Operation<int(int)> local("hidden", [](int n) { return n; });
    ASSERT_TRUE(tank->provides()->addLocalOperation(local));
    EXPECT_EQ("", complaint("ls tank\nhelp tank"));
    EXPECT_THAT(answer("ls tank\nhelp tank"), Not(HasSubstr("hidden")));
    EXPECT_THAT(complaint("help tank.hidden"), HasSubstr("hidden"));
    tank->provides()->removeOperation("hidden");
}

}  // namespace
