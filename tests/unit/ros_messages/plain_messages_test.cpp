// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Rows for plain types, against the headers of gencpp.
#include <std_msgs/primitive_messages.hpp>
#include <std_msgs/vector_multi_array_adapter.h>

#include <ros/message_traits.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Duration.h>
#include <std_msgs/Float32.h>
#include <std_msgs/Float64.h>
#include <std_msgs/Int16.h>
#include <std_msgs/Int32.h>
#include <std_msgs/Int64.h>
#include <std_msgs/Int8.h>
#include <std_msgs/String.h>
#include <std_msgs/Time.h>
#include <std_msgs/UInt16.h>
#include <std_msgs/UInt32.h>
#include <std_msgs/UInt64.h>
#include <std_msgs/UInt8.h>

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace {

template <class... Messages>
std::map<std::string, std::string> sumsOf() {
    return {{ros::message_traits::datatype<Messages>(), ros::message_traits::md5sum<Messages>()}...};
}

TEST(PrimitiveMessages, sumsAreThoseOfTheHeaders) {
    const auto sums =
        sumsOf<std_msgs::Bool, std_msgs::Int8, std_msgs::UInt8, std_msgs::Int16, std_msgs::UInt16, std_msgs::Int32,
               std_msgs::UInt32, std_msgs::Int64, std_msgs::UInt64, std_msgs::Float32, std_msgs::Float64,
               std_msgs::String, std_msgs::Time, std_msgs::Duration, std_msgs::Int8MultiArray,
               std_msgs::UInt8MultiArray, std_msgs::Int16MultiArray, std_msgs::UInt16MultiArray,
               std_msgs::Int32MultiArray, std_msgs::UInt32MultiArray, std_msgs::Int64MultiArray,
               std_msgs::UInt64MultiArray, std_msgs::Float32MultiArray, std_msgs::Float64MultiArray>();
    const std_msgs::MessageTable table = std_msgs::primitiveMessages();
    EXPECT_EQ(table.count, sums.size() + 1) << "string and rt_string are one message";
    for (std::size_t i = 0; i != table.count; ++i) EXPECT_EQ(sums.at(table.first[i].message), table.first[i].md5);
}

template <class To, class From>
To through(const From& from) {
    std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(from));
    ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    ros::serialization::serialize(out, from);
    EXPECT_EQ(out.getLength(), 0u);
    To to;
    ros::serialization::IStream in(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    ros::serialization::deserialize(in, to);
    return to;
}

TEST(VectorMultiArrayAdapter, isTheMessage) {
    typedef std_msgs::VectorMultiArrayAdapter<double> Adapter;
    const auto message = through<std_msgs::Float64MultiArray>(Adapter({1, 2, 3}));
    ASSERT_EQ(message.layout.dim.size(), 1u);
    EXPECT_EQ(message.layout.dim[0].size, 3u);
    EXPECT_EQ(message.layout.dim[0].stride, 3u);
    EXPECT_EQ(message.data, std::vector<double>({1, 2, 3}));
    EXPECT_EQ(through<Adapter>(message).data, message.data);
    EXPECT_TRUE(through<Adapter>(std_msgs::Float64MultiArray()).data.empty());
    EXPECT_STREQ(ros::message_traits::datatype<Adapter>(), "std_msgs/Float64MultiArray");
    EXPECT_STREQ(ros::message_traits::md5sum(Adapter()), ros::message_traits::md5sum<std_msgs::Float64MultiArray>());
    EXPECT_EQ(through<std_msgs::UInt8MultiArray>(std_msgs::VectorMultiArrayAdapter<std::uint8_t>({7})).data.at(0), 7);
}

}  // namespace
