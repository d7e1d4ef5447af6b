// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values as the console shows them.
#include "console_fixture.hpp"

namespace {

class ValueText : public ConsoleTest {};

TEST_F(ValueText, TextsAreQuoted) {
    EXPECT_EQ(" = \"\"\n", answer("\"\""));
    EXPECT_EQ(" = \"a\\\"b\\n\"\n", answer("\"a\\\"b\\n\""));
    EXPECT_EQ(" = 'x'\n", answer("'x'"));
}

TEST_F(ValueText, LettersThatCannotBeShownAreNumbers) {
    std::string text = "a\033[31mb\r\177\xC3\xB6";
    plant.addProperty("text", text);
    EXPECT_EQ(" = \"a\\x1b[31mb\\x0d\\x7fö\"\n", answer("text"));
    EXPECT_THAT(answer("ls"), testing::HasSubstr("= \"a\\x1b[31mb\\x0d\\x7fö\""));
    plant.properties()->removeProperty(plant.getProperty("text"));
}

TEST_F(ValueText, RealTimeTextsAreTexts) { EXPECT_EQ(" = \"abc\"\n", answer("rt_string(\"abc\")")); }

TEST_F(ValueText, NumbersKeepTheirDigits) {
    EXPECT_EQ(" = 1234567.25\n", answer("1234567.25"));
    EXPECT_EQ(" = 0.3\n", answer("0.1 * 3.0"));
    answer("var float f = 1.1");
    EXPECT_EQ(" = 1.1\n", answer("f"));
    EXPECT_EQ(" = 1e+20\n", answer("1.0e20"));
}

TEST_F(ValueText, TruthsAreWords) { EXPECT_EQ(" = true\n", answer("1 < 2")); }

TEST_F(ValueText, SequencesShowTheirFirstElements) {
    EXPECT_EQ(" = []\n", answer("array(0)"));
    EXPECT_EQ(" = [1.5, 2.5]\n", answer("array(1.5, 2.5)"));
    EXPECT_EQ(" = [0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, … 90 more]\n", answer("array(100, 0.5)"));
}

TEST_F(ValueText, StructsShowTheirMembers) {
    answer("var ConnPolicy p; p.size = 5;");
    EXPECT_THAT(answer("p"), testing::HasSubstr("size = 5, "));
    EXPECT_EQ(" = 5\n", answer("p.size"));
}

TEST_F(ValueText, ABagIsATable) {
    double speed = 1.5;
    std::string name = "left";
    RTT::PropertyBag bag;
    bag.addProperty("speed", speed).doc("of the drive [m/s]");
    bag.addProperty("name", name);
    RTT::Property<RTT::PropertyBag> drive("drive", "", bag);
    plant.addProperty(drive);
    EXPECT_EQ(
        " =\n"
        "    speed  double  = 1.5     m/s  of the drive\n"
        "    name   string  = \"left\"\n",
        answer("drive"));
    EXPECT_EQ(" = 1.5\n", answer("drive.speed"));
    plant.provides()->removeProperty(drive);
}

TEST_F(ValueText, AnEmptyBagIsAnEmptyStruct) { EXPECT_EQ(" = {}\n", answer("PropertyBag()")); }

}  // namespace
