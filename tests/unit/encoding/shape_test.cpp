// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/types/Shape.hpp>

#include <rtt/rtt-config.h>

#include "encoded_types.hpp"

using encoded::EncodedTypes;
using RTT::types::Shape;

namespace {

Shape shapeOf(const std::string& type) { return types_test::type(type)->shape(); }

}  // namespace

TEST_F(EncodedTypes, ShapesOfFundamentalTypes) {
    EXPECT_EQ(shapeOf("double").number, Shape::Number::Float64);
    EXPECT_EQ(shapeOf("int").number, Shape::Number::Int32);
    EXPECT_EQ(shapeOf("bool").number, Shape::Number::Bool);
    EXPECT_EQ(shapeOf("uint8").number, Shape::Number::UInt8);
    EXPECT_EQ(shapeOf("string").text->get(std::make_unique<std::string>("abc").get()), "abc");
    EXPECT_EQ(shapeOf("rt_string").kind, Shape::Kind::Text);
    EXPECT_EQ(shapeOf("array").kind, Shape::Kind::Sequence);
    EXPECT_EQ(shapeOf("ConnPolicy").kind, Shape::Kind::Struct);
    EXPECT_EQ(shapeOf("FlowStatus").enumerators.size(), 3U);
}

TEST_F(EncodedTypes, ShapesOfStructsAreTheirTables) {
    const Shape tank = shapeOf("/sample/Tank");
    ASSERT_EQ(tank.fields.size(), 10U);
    EXPECT_EQ(tank.fields[5].name, "weights");
    EXPECT_EQ(tank.fields[5].count, 3U);
    EXPECT_EQ(tank.fields[5].offset, offsetof(sample::Tank, weights));
    EXPECT_EQ(tank.ops->size, sizeof(sample::Tank));
}

TEST_F(EncodedTypes, MembersOfATypekitOfUserCodeAreFoundInAValue) {
    const Shape foreign = shapeOf("/encoded/Foreign");
    ASSERT_EQ(foreign.kind, Shape::Kind::Struct) << foreign.reason;
    ASSERT_EQ(foreign.fields.size(), 2U);
    EXPECT_EQ(foreign.fields[1].name, "b");
    EXPECT_EQ(foreign.fields[1].offset, offsetof(encoded::Foreign, b));
    const encoded::Foreign value{5, 1.0};
    EXPECT_EQ(bytesOf(value), std::string("\5\0\0\0\0\0\0\0\0\0\0\0\0\0\xf0\x3f", 16));
}

TEST_F(EncodedTypes, ASerializationFunctionMustShowAllMembers) {
    EXPECT_EQ(shapeOf("/encoded/Partial").reason,
              "its serialization function has values without a name or without a place in the object");
}

TEST_F(EncodedTypes, TypesWithoutValuesHaveNone) {
    EXPECT_EQ(shapeOf("void").reason, "it has no values");
    EXPECT_FALSE(shapeOf("PropertyBag"));
    EXPECT_FALSE(RTT::types::Types()->unknownType()->shape());
}
