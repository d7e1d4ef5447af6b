// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "primitive_messages.hpp"

namespace std_msgs {

namespace {

using rtt_roscomm::MessageEntry;

#define ORO_RULE "================================================================================\n"
#define ORO_LAYOUT                                                        \
    ORO_RULE                                                              \
    "MSG: std_msgs/MultiArrayLayout\nMultiArrayDimension[] dim\nuint32 data_offset\n" \
    ORO_RULE "MSG: std_msgs/MultiArrayDimension\nstring label\nuint32 size\nuint32 stride\n"

constexpr MessageEntry all[] = {
    {"bool", "std_msgs/Bool", "8b94c1b53db61fb6aed406028ad6332a", "bool data\n"},
    {"int8", "std_msgs/Int8", "27ffa0c9c4b8fb8492252bcad9e5c57b", "int8 data\n"},
    {"uint8", "std_msgs/UInt8", "7c8164229e7d2c17eb95e9231617fdee", "uint8 data\n"},
    {"int16", "std_msgs/Int16", "8524586e34fbd7cb1c08c5f5f1ca0e57", "int16 data\n"},
    {"uint16", "std_msgs/UInt16", "1df79edf208b629fe6b81923a544552d", "uint16 data\n"},
    {"int", "std_msgs/Int32", "da5909fbe378aeaf85e547e830cc1bb7", "int32 data\n"},
    {"uint", "std_msgs/UInt32", "304a39449588c7f8ce2df6e8001c5fce", "uint32 data\n"},
    {"int64", "std_msgs/Int64", "34add168574510e6e17f5d23ecc077ef", "int64 data\n"},
    {"uint64", "std_msgs/UInt64", "1b2a79973e8bf53d7b53acb71299cb57", "uint64 data\n"},
    {"float", "std_msgs/Float32", "73fcbf46b49191e672908e50842a83d4", "float32 data\n"},
    {"double", "std_msgs/Float64", "fdb28210bfa9d7c91146260178d9a584", "float64 data\n"},
    {"string", "std_msgs/String", "992ce8a1687cec8c8bd883ec73ca41d1", "string data\n"},
    {"time", "std_msgs/Time", "cd7166c74c552c311fbcc2fe5a7bc289", "time data\n"},
    {"duration", "std_msgs/Duration", "3e286caf4241d664e55f3ad380e2ae46", "duration data\n"},
    {"rt_string", "std_msgs/String", "992ce8a1687cec8c8bd883ec73ca41d1", "string data\n"},
    {"int8[]", "std_msgs/Int8MultiArray", "d7c1af35a1b4781bbe79e03dd94b7c13",
     "MultiArrayLayout layout\nint8[] data\n" ORO_LAYOUT},
    {"uint8[]", "std_msgs/UInt8MultiArray", "82373f1612381bb6ee473b5cd6f5d89c",
     "MultiArrayLayout layout\nuint8[] data\n" ORO_LAYOUT},
    {"int16[]", "std_msgs/Int16MultiArray", "d9338d7f523fcb692fae9d0a0e9f067c",
     "MultiArrayLayout layout\nint16[] data\n" ORO_LAYOUT},
    {"uint16[]", "std_msgs/UInt16MultiArray", "52f264f1c973c4b73790d384c6cb4484",
     "MultiArrayLayout layout\nuint16[] data\n" ORO_LAYOUT},
    {"int32[]", "std_msgs/Int32MultiArray", "1d99f79f8b325b44fee908053e9c945b",
     "MultiArrayLayout layout\nint32[] data\n" ORO_LAYOUT},
    {"uint32[]", "std_msgs/UInt32MultiArray", "4d6a180abc9be191b96a7eda6c8a233d",
     "MultiArrayLayout layout\nuint32[] data\n" ORO_LAYOUT},
    {"int64[]", "std_msgs/Int64MultiArray", "54865aa6c65be0448113a2afc6a49270",
     "MultiArrayLayout layout\nint64[] data\n" ORO_LAYOUT},
    {"uint64[]", "std_msgs/UInt64MultiArray", "6088f127afb1d6c72927aa1247e945af",
     "MultiArrayLayout layout\nuint64[] data\n" ORO_LAYOUT},
    {"float32[]", "std_msgs/Float32MultiArray", "6a40e0ffa6a17a503ac3f8616991b1f6",
     "MultiArrayLayout layout\nfloat32[] data\n" ORO_LAYOUT},
    {"array", "std_msgs/Float64MultiArray", "4b7d974086d4060e7db4613a7e6c3ba4",
     "MultiArrayLayout layout\nfloat64[] data\n" ORO_LAYOUT},
};

}  // namespace

MessageTable primitiveMessages() { return {all, sizeof all / sizeof all[0]}; }

}  // namespace std_msgs
