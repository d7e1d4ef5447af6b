// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Enumerators that scripts write: unknown ones are answered with the others and the nearest, numbers have to be of one of them.
#include "script_fixture.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/types/GeneratedTypekit.hpp>
#include <rtt/types/Types.hpp>

#include <gmock/gmock.h>

namespace enums {

enum class Mode : std::uint8_t { Rest, Steal, Give = 7 };
enum class Level { Low = -5, High = 5 };
enum Options { One = 1, Two = 2, Four = 4 };
enum class Slot {};
struct Plan {
    Mode mode = Mode::Rest;
    std::vector<Mode> next;
};

namespace t = RTT::types;

constexpr t::Enumerator modes[] = {{"Rest", 0, ""}, {"Steal", 1, ""}, {"Give", 7, ""}};
constexpr t::Enumerator levels[] = {{"Low", -5, ""}, {"High", 5, ""}};
constexpr t::Enumerator options[] = {{"One", 1, ""}, {"Two", 2, ""}, {"Four", 4, ""}};
constexpr t::Member members[] = {
    {"mode", offsetof(Plan, mode), &t::typeRef<Mode>, 0, "", ""},
    {"next", offsetof(Plan, next), &t::typeRef<std::vector<Mode>>, 0, "", ""},
};

void addTypes() {
    const auto types = t::Types();
    types->addType(t::makeEnumType<Mode>("/n/Mode", modes, 3));
    types->addType(t::makeEnumType<Level>("/n/Level", levels, 2));
    types->addType(t::makeEnumType<Options>("/n/Options", options, 3));
    types->addType(t::makeEnumType<Slot>("/n/Slot", nullptr, 0));
    types->addType(t::makeSequenceType<std::vector<Mode>>("/std/vector</n/Mode>"));
    types->addType(t::makeStructType<Plan>("/n/Plan", members, 2));
}

}  // namespace enums

using enums::Mode;
using ::testing::HasSubstr;

namespace {

class Enums : public ScriptTest {
protected:
    Enums() {
        enums::addTypes();
        component.addProperty("mode", mode);
        component.addProperty("plan", plan);
        component.addOperation("turn", &Enums::turn, this);
        component.addOperation("both", &Enums::both, this);
        component.ports()->addPort(out);
    }
    void turn(Mode given) { mode = given; }
    void both(int, Mode given) { mode = given; }

    /** Not one of them is executed. */
    void expectRefused(const std::string& text, const std::string& place, const std::string& found = "'Stael'",
                       const std::string& nearest = "; did you mean 'Steal'?") {
        EXPECT_FALSE(run(text)) << text;
        EXPECT_EQ("script.ops:" + place + ": error: [OPS154] " + refusal(found) + nearest + "\n", messages()) << text;
        EXPECT_EQ(Mode::Rest, mode) << text;
    }
    static std::string refusal(const std::string& found) {
        return found + " is no value of type /n/Mode; expected 'Rest', 'Steal' or 'Give'";
    }

    Mode mode = Mode::Rest;
    enums::Plan plan;
    RTT::OutputPort<Mode> out{"out"};
};

}  // namespace

TEST_F(Enums, UnknownOnesAreAnsweredWithTheOthersAndTheNearest) {
    expectRefused("var n.Mode m = \"Stael\"", "1:16");
    ASSERT_TRUE(run("var n.Mode k")) << messages();
    expectRefused("k = \"Stael\"", "1:5");
    expectRefused("const n.Mode c = \"Stael\"", "1:18");
    expectRefused("mode = \"Stael\"", "1:8");
    expectRefused("robot.mode = \"Stael\"", "1:14");
    expectRefused("k = n.Mode(\"Stael\")", "1:12");
    expectRefused("k = \"Nothing like it\"", "1:5", "'Nothing like it'", "");
}

TEST_F(Enums, MembersOfStructsAndElementsOfSequences) {
    plan.next.resize(2);
    expectRefused("plan.mode = \"Stael\"", "1:13");
    expectRefused("plan.next[1] = \"Stael\"", "1:16");
    expectRefused("plan.next[1] = 2", "1:16", "'2'", "");
    EXPECT_TRUE(run("plan.next[1] = \"Steal\"\nplan.mode = 7")) << messages();
    EXPECT_EQ(Mode::Steal, plan.next[1]);
    EXPECT_EQ(Mode::Give, plan.mode);
}

TEST_F(Enums, WhatIsPassedSentAndWritten) {
    expectRefused("turn(\"Stael\")", "1:6");
    expectRefused("both(1, \"Stael\")", "1:9");
    expectRefused("both(1, 2)", "1:9", "'2'", "");
    expectRefused("turn.send(\"Stael\")", "1:11");
    expectRefused("turn.call(\"Stael\")", "1:11");
    expectRefused("turn.cmd(\"Stael\")", "1:10");
    expectRefused("var SendHandle h = turn.send(\"Stael\")", "1:30");
    expectRefused("out.write(\"Stael\")", "1:11");
    expectRefused("void give(n.Mode m) { turn(m) }\ngive(\"Stael\")", "2:6");
    expectRefused("n.Mode made() { return \"Stael\" }\nturn(made())", "1:24");
    EXPECT_TRUE(run("turn(\"Give\")\nout.write(\"Steal\")")) << messages();
    EXPECT_EQ(Mode::Give, mode);
    EXPECT_EQ(Mode::Steal, out.getLastWrittenValue());
}

TEST_F(Enums, NumbersAreThoseOfTheEnumerators) {
    expectRefused("mode = 2", "1:8", "'2'", "");
    expectRefused("mode = \"2\"", "1:8", "'2'", "");
    expectRefused("var n.Mode m = 256", "1:16", "'256'", "");
    EXPECT_TRUE(run("mode = 7")) << messages();
    EXPECT_EQ(Mode::Give, mode);
    EXPECT_TRUE(run("mode = \"1\"")) << messages();
    EXPECT_EQ(Mode::Steal, mode);
    EXPECT_TRUE(run("var n.Level l = -5")) << messages();
    EXPECT_FALSE(run("var n.Level least = -4"));
    EXPECT_THAT(messages(), HasSubstr("'-4' is no value of type /n/Level; expected 'Low' or 'High'\n"));
}

TEST_F(Enums, FlagsMayBeCombinedAndEnumsWithoutNamesTakeAllNumbers) {
    EXPECT_TRUE(run("var n.Options o = 5\no = 0\nvar n.Slot s = 99")) << messages();
    EXPECT_FALSE(run("o = 8"));
    EXPECT_THAT(messages(), HasSubstr("'8' is no value of type /n/Options; expected 'One', 'Two' or 'Four'\n"));
    EXPECT_FALSE(run("s = \"x\""));
    EXPECT_THAT(messages(), HasSubstr("'x' is no value of type /n/Slot; expected a number\n"));
}

TEST_F(Enums, WhatIsKnownWhenItIsExecutedOnly) {
    ASSERT_TRUE(run("var string text = \"Stael\"\nvar int number = 2")) << messages();
    const std::string why = "[OPS400] " + refusal("'Stael'") + "; did you mean 'Steal'?\n";
    for (const char* statement : {"mode = text", "turn(text)", "turn.send(text)", "out.write(text)", "plan.mode = text",
                                  "mode = n.Mode(text)"}) {
        EXPECT_FALSE(run(statement)) << statement;
        EXPECT_EQ("script.ops:1:1: error: " + why, messages()) << statement;
    }
    EXPECT_FALSE(run("mode = number"));
    EXPECT_THAT(messages(), HasSubstr("[OPS400] " + refusal("'2'") + "\n"));
    EXPECT_EQ(Mode::Rest, mode);
    EXPECT_TRUE(run("text = \"Give\"\nmode = text")) << messages();
    EXPECT_EQ(Mode::Give, mode);
}

TEST_F(Enums, TheReasonIsThatOfTheStatementThatFails) {
    ASSERT_TRUE(run("var string text = \"Stael\"")) << messages();
    EXPECT_FALSE(run("try turn(text) catch { yield }\nvar ints i(1)\ni[0] = 1 / (i[0] - i[0])"));
    EXPECT_THAT(messages(), ::testing::Not(HasSubstr("Stael")));
}

TEST_F(Enums, AreComparedWithTheirNamesAndAllNumbers) {
    expectRefused("var bool b1 = mode == \"Stael\"", "1:23");
    expectRefused("var bool b2 = \"Stael\" != mode", "1:15");
    EXPECT_TRUE(result<bool>("bool", "mode == \"Rest\""));
    EXPECT_TRUE(result<bool>("bool", "\"Rest\" == mode"));
    EXPECT_TRUE(result<bool>("bool", "mode == 0"));
    EXPECT_TRUE(result<bool>("bool", "mode != 2"));
    EXPECT_TRUE(result<bool>("bool", "2 != mode"));
    EXPECT_FALSE(result<bool>("bool", "mode == 2"));
    mode = static_cast<Mode>(9);
    EXPECT_TRUE(result<bool>("bool", "mode == 9")) << "a value that C++ made";
}
