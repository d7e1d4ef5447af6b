// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values that clients give, and what is said of those that are wrong.
#include "requests_fixture.hpp"

#include <rtt/types/CArrayTypeInfo.hpp>
#include <rtt/types/StructTypeInfo.hpp>
#include <rtt/types/Types.hpp>

#include <boost/serialization/array.hpp>
#include <boost/serialization/nvp.hpp>

#include <functional>
#include <limits>

namespace live_test {

struct Shot {
    double at[3] = {7, 8, 9};
    long long number = 5;
};

template <class Archive>
void serialize(Archive& archive, Shot& shot, unsigned) {
    archive& boost::serialization::make_nvp("at", shot.at);
    archive& boost::serialization::make_nvp("number", shot.number);
}

namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST_F(RequestsTest, AnArrayInAStructIsSetInPartsAndAsAWhole) {
    if (!RTT::types::Types()->type("shot")) {
        RTT::types::Types()->addType(new RTT::types::CArrayTypeInfo<RTT::types::carray<double>>("/double[]"));
        RTT::types::Types()->addType(new RTT::types::StructTypeInfo<Shot>("shot"));
    }
    Shot shot;
    arm->addProperty("shot", shot);
    EXPECT_EQ(json({7, 8, 9}), result("get", {{"path", "Arm.shot.at"}})["value"]);
    EXPECT_EQ(json({1, 2, 3}), result("set", {{"path", "Arm.shot.at"}, {"text", "[1, 2, 3]"}})["value"]);
    EXPECT_EQ(3, shot.at[2]);
    EXPECT_EQ(json({4, 5, 6}), result("set", {{"path", "Arm.shot.at"}, {"value", {4, 5, 6}}})["value"]);
    (void)result("set", {{"path", "Arm.shot.at[1]"}, {"value", 50}});
    EXPECT_EQ(50, shot.at[1]);
    EXPECT_THAT(failure("set", {{"path", "Arm.shot.at"}, {"value", {1, 2}}}),
                HasSubstr("Arm.shot.at: found an array of 2, expected an array of 3"));
    EXPECT_THAT(failure("set", {{"path", "Arm.shot.at"}, {"text", "5"}}), HasSubstr("expected an array of 3"));
    EXPECT_THAT(failure("set", {{"path", "Arm.shot.at"}, {"value", {1, 2, "a"}}}), HasSubstr("Arm.shot.at[2]: found"));
    EXPECT_EQ(4, shot.at[0]);
}

TEST_F(RequestsTest, WholeNumbersHaveTheirWholeRange) {
    long long number = 0;
    arm->addProperty("number", number);
    (void)result("set", {{"path", "Arm.number"}, {"text", "-9223372036854775808"}});
    EXPECT_EQ(std::numeric_limits<long long>::min(), number);
    (void)result("set", {{"path", "Arm.number"}, {"text", "9223372036854775807"}});
    EXPECT_EQ(std::numeric_limits<long long>::max(), number);
    EXPECT_THAT(failure("set", {{"path", "Arm.number"}, {"text", "-9223372036854775809"}}), StartsWith("LIV006"));
}

TEST_F(RequestsTest, NumbersAreReadInAllTheirForms) {
    for (const char* const text : {".5", "+.5", "0.5", "5e-1"})
        EXPECT_EQ(0.5, result("set", {{"path", "Arm.gain"}, {"text", text}})["value"]) << text;
    EXPECT_EQ(-0.5, result("set", {{"path", "Arm.gain"}, {"text", "-.5"}})["value"]);
    for (const char* const text : {"nan", "-nan"})
        EXPECT_EQ("NaN", result("set", {{"path", "Arm.gain"}, {"text", text}})["value"]) << text;
    for (const char* const text : {".", "-", "+", ".e", "-.x", "--1"})
        EXPECT_THAT(failure("set", {{"path", "Arm.gain"}, {"text", text}}), StartsWith("LIV006")) << text;
    EXPECT_THAT(failure("set", {{"path", "Arm.gain"}, {"text", "ü"}}), HasSubstr("found 'ü'"));
}

TEST_F(RequestsTest, NamesOfMembersMayHaveDots) {
    double level = 4;
    RTT::OutputPort<double> dotted("out.b");
    arm->addPort(dotted);
    arm->addProperty("le.vel.x", level);
    arm->addProperty("policy.size", level);
    arm->provides("gripper")->addProperty("f.g", level);
    EXPECT_EQ(4, result("get", {{"path", "Arm.le.vel.x"}})["value"]);
    EXPECT_EQ(5, result("set", {{"path", "Arm.le.vel.x"}, {"value", 5}})["value"]);
    EXPECT_EQ("port", result("show", {{"path", "Arm.out.b"}})["kind"]);
    EXPECT_EQ(5, result("get", {{"path", "Arm.policy.size"}})["value"]);
    EXPECT_EQ(5, result("get", {{"path", "Arm.gripper.f.g"}})["value"]);
    EXPECT_THAT(failure("get", {{"path", "Arm.le.vel"}}), HasSubstr("'le' in 'Arm'"));
    arm->ports()->removePort("out.b");
}

TEST_F(RequestsTest, AFieldHasOneValue) {
    EXPECT_THAT(failure("set", {{"path", "Arm.policy"}, {"text", "{size = 5, size = 6}"}}),
                HasSubstr("field 'size' has two values"));
}

TEST_F(RequestsTest, APartOfAnotherKindIsNoUnknownName) {
    EXPECT_EQ("LIV003: 'Arm.gain' is no operation", failure("call", {{"path", "Arm.gain"}}));
    EXPECT_EQ("LIV003: 'Arm.out' is no operation", failure("call", {{"path", "Arm.out"}}));
    EXPECT_EQ("LIV003: 'Arm.gain' is no component", failure("lifecycle", {{"component", "Arm.gain"}, {"do", "stop"}}));
}

TEST_F(RequestsTest, AWrongFieldOfAnArgumentIsNamed) {
    const std::function<int(const RTT::ConnPolicy&)> size = [](const RTT::ConnPolicy& policy) { return policy.size; };
    arm->addOperation("size", size);
    EXPECT_EQ(5, result("call", {{"path", "Arm.size"}, {"arguments", {"{size = 5}"}}})["value"]);
    EXPECT_THAT(failure("call", {{"path", "Arm.size"}, {"arguments", {"{size = 5, nope = 1}"}}}),
                HasSubstr("there is no field 'nope'"));
    EXPECT_THAT(failure("call", {{"path", "Arm.size"}}), HasSubstr("has 1 argument, found 0"));
}

}  // namespace
}  // namespace live_test
