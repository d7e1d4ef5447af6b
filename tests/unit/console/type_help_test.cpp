// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// `help` of types.
#include "console_fixture.hpp"

#include <types/sample_types.hpp>

namespace {

using testing::HasSubstr;
using testing::Not;

class TypeHelp : public ConsoleTest {
protected:
    TypeHelp() { sample::addTypes(); }
};

TEST_F(TypeHelp, AStructShowsItsMembersWithTypesUnitsAndWhatTheyAreFor) {
    EXPECT_EQ(
        "Type sample.Point\n"
        "    .x  double  = 0  east [m]\n"
        "    .y  double  = 0  north [m]\n",
        answer("help sample.Point"));
    const std::string tank = answer("help sample.Tank");
    EXPECT_THAT(tank, testing::StartsWith("Type sample.Tank\n  a tank\n    .id        int "));
    EXPECT_THAT(tank, testing::ContainsRegex("\n    \\.mode +sample\\.Mode +=  ?Idle\n"));
    EXPECT_EQ(tank, answer("help /sample/Tank"));
}

TEST_F(TypeHelp, AnEnumShowsItsValuesAndWhatItIsMadeFrom) {
    EXPECT_EQ(
        "Enum sample.Mode\n"
        "  made from: int, string\n"
        "    Idle      = 0\n"
        "    Filling   = 1\n"
        "    Draining  = 7\n"
        "    Emptying  = 7\n",
        answer("help sample.Mode"));
}

TEST_F(TypeHelp, ASequenceShowsWhatItsElementsAre) {
    EXPECT_THAT(answer("help array"), testing::StartsWith("Type array\n"));
    EXPECT_THAT(answer("help array"), HasSubstr("  elements: double\n"));
}

TEST_F(TypeHelp, OtherNamesOfTheTypeAreTold) {
    ASSERT_TRUE(RTT::types::Types()->aliasType("sample.Place", RTT::types::Types()->type("sample.Point")));
    EXPECT_THAT(answer("help sample.Place"), testing::StartsWith("Type sample.Point\n  also called: sample.Place\n"));
}

TEST_F(TypeHelp, WhatTheComponentHasComesFirst) {
    double value = 3;
    plant.addProperty("array", value);
    EXPECT_THAT(answer("help array"), testing::StartsWith("Property array  double"));
}

TEST_F(TypeHelp, TheNearestTypeIsTold) {
    EXPECT_THAT(complaint("help ConnPolizy"),
                HasSubstr("there is nothing called 'ConnPolizy' here; did you mean 'ConnPolicy'?"));
    EXPECT_EQ("", answer("help ConnPolizy"));
}

TEST_F(TypeHelp, AnUnknownEnumeratorThatIsTypedIsAnsweredWithTheOthersAndTheNearest) {
    sample::Mode mode = sample::Mode::Idle;
    plant.addProperty("mode", mode);
    EXPECT_EQ(
        "typed:1:8: error: [OPS154] 'Fillign' is no value of type /sample/Mode; expected 'Idle', 'Filling', 'Draining' "
        "or "
        "'Emptying'; did you mean 'Filling'?\n"
        "mode = \"Fillign\"\n"
        "       ^\n",
        complaint("mode = \"Fillign\""));
    EXPECT_THAT(complaint("mode = 3"), HasSubstr("'3' is no value of type /sample/Mode; expected 'Idle'"));
    EXPECT_EQ(" = Filling\n", answer("mode = \"Filling\""));
}

TEST_F(TypeHelp, EveryTypeHasOne) {
    for (const std::string& type : RTT::types::Types()->getDottedTypes()) {
        EXPECT_THAT(answer("help " + type), testing::ContainsRegex("^(Type|Enum) ")) << type;
        EXPECT_EQ("", err.str());
    }
}

}  // namespace
