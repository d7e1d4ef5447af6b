// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Types as texts for programs that do not know them. Whether such programs read them is in tests/judges.
#include "encoded_types.hpp"

#include <rtt/encoding/SchemaText.hpp>
#include <rtt/types/StructTable.hpp>

#include <gmock/gmock.h>

using encoded::EncodedTypes;
using RTT::encoding::SchemaLanguage;
using RTT::encoding::SchemaText;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::Pair;

namespace schema_test {

struct Joint {
    double angleRad = 0;
    float speed = 0;
    std::vector<std::vector<int>> rows;
    short string = 0;
};
constexpr RTT::types::Member kJointMembers[] = {
    {"angleRad", offsetof(Joint, angleRad), &RTT::types::typeRef<double>, 0, "The angle\nof it.", "rad"},
    {"speed", offsetof(Joint, speed), &RTT::types::typeRef<float>, 0, "", "rad/s"},
    {"rows", offsetof(Joint, rows), &RTT::types::typeRef<std::vector<std::vector<int>>>, 0, "", ""},
    {"string", offsetof(Joint, string), &RTT::types::typeRef<short>, 0, "", ""},
};

}  // namespace schema_test

namespace {

using schema_test::Joint;

SchemaText described(const RTT::types::TypeInfo* type, SchemaLanguage language = SchemaLanguage::Auto,
                     bool rosNames = false) {
    SchemaText result;
    std::string why;
    EXPECT_TRUE(RTT::encoding::describeType(*type, language, rosNames, result, why)) << why;
    return result;
}

template <class T>
SchemaText described(SchemaLanguage language = SchemaLanguage::Auto, bool rosNames = false) {
    return described(RTT::types::Types()->getTypeById(typeid(T).name()), language, rosNames);
}

class SchemaTexts : public EncodedTypes {
protected:
    static void SetUpTestSuite() {
        EncodedTypes::SetUpTestSuite();
        if (RTT::types::Types()->getTypeById(typeid(Joint).name())) return;
        RTT::types::Types()->addType(RTT::types::makeSequenceType<std::vector<std::vector<int>>>("/test/Rows"));
        RTT::types::Types()->addType(
            RTT::types::makeStructType<Joint>("/test/arm/Joint", schema_test::kJointMembers, 4));
    }
};

TEST_F(SchemaTexts, NumbersAndTextsAreThoseOfRos) {
    EXPECT_EQ("std_msgs/msg/Float64", described<double>().name);
    EXPECT_EQ("float64 data\n", described<double>().text);
    EXPECT_EQ("std_msgs/msg/String", described<std::string>().name);
    EXPECT_EQ("std_msgs/msg/Bool", described<bool>().name);
    EXPECT_EQ("std_msgs::Int32", described<int>(SchemaLanguage::OmgIdl).name);
    EXPECT_EQ("module std_msgs {\nstruct Int32 {\n  int32 data;\n};\n};\n",
              described<int>(SchemaLanguage::OmgIdl).text);
    EXPECT_EQ("float64[] data\n", described<std::vector<double>>().text);
}

TEST_F(SchemaTexts, StructsFollowEachOther) {
    const SchemaText text = described<sample::Tank>();
    EXPECT_EQ("ros2msg", text.encoding);
    EXPECT_EQ("", text.illegal);
    EXPECT_THAT(text.text, HasSubstr("string label\n"));
    EXPECT_THAT(text.text, HasSubstr("float64[] levels\n"));
    EXPECT_THAT(text.text, HasSubstr("[3] weights\n"));
    EXPECT_THAT(text.text, HasSubstr(" MODE_FILLING="));
    EXPECT_THAT(text.text, HasSubstr("\n" + std::string(80, '=') + "\nMSG: "));
}

TEST_F(SchemaTexts, CapitalsMakeItIdlWithUnitsAndDescriptions) {
    const SchemaText text = described<Joint>();
    EXPECT_EQ("omgidl", text.encoding);
    EXPECT_EQ("test_arm::Joint", text.name);
    EXPECT_THAT(text.text, HasSubstr("module test_arm {\nstruct Joint {\n"
                                     "  double angleRad;  // The angle of it. [rad]\n"
                                     "  float speed;  // [rad/s]\n"));
    EXPECT_THAT(text.text, HasSubstr("  int16 _string;\n};\n};\n"));
    EXPECT_THAT(text.units, ElementsAre(Pair("angleRad", "rad"), Pair("speed", "rad/s")));
    EXPECT_THAT(text.illegal, HasSubstr("the field 'angleRad' of test_arm/Joint"));
}

TEST_F(SchemaTexts, RosNamesAreMadeOnRequest) {
    const SchemaText text = described<Joint>(SchemaLanguage::Auto, true);
    EXPECT_EQ("ros2msg", text.encoding);
    EXPECT_EQ("test_arm/msg/Joint", text.name);
    EXPECT_THAT(text.text, HasSubstr("float64 angle_rad  # The angle of it. [rad]\n"));
    EXPECT_THAT(text.units, ElementsAre(Pair("angle_rad", "rad"), Pair("speed", "rad/s")));
    SchemaText none;
    std::string why;
    EXPECT_FALSE(RTT::encoding::describeType(*RTT::types::Types()->getTypeById(typeid(Joint).name()),
                                             SchemaLanguage::Ros2Msg, false, none, why));
    EXPECT_THAT(why, HasSubstr("'angleRad'"));
}

TEST_F(SchemaTexts, StructsWithoutFieldsHaveTheirByte) {
    EXPECT_EQ("uint8 structure_needs_at_least_one_member\n", described<encoded::Nothing>().text);
    EXPECT_EQ("module encoded {\nstruct Nothing {\n  uint8 structure_needs_at_least_one_member;\n};\n};\n",
              described<encoded::Nothing>(SchemaLanguage::OmgIdl).text);
}

TEST_F(SchemaTexts, TypesThatContainThemselvesAreIdl) {
    const SchemaText text = described<encoded::Tree>();
    EXPECT_EQ("omgidl", text.encoding);
    EXPECT_THAT(text.illegal, HasSubstr("encoded/Tree contains itself"));
}

TEST_F(SchemaTexts, TypesWithoutAShapeHaveNone) {
    SchemaText none;
    std::string why;
    EXPECT_FALSE(
        RTT::encoding::describeType(*RTT::types::Types()->unknownType(), SchemaLanguage::Auto, false, none, why));
    EXPECT_NE("", why);
}

}  // namespace
