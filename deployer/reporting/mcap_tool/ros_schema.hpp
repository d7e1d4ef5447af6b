// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_TOOL_ROS_SCHEMA_HPP
#define OROFORGE_MCAP_TOOL_ROS_SCHEMA_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace oroforge::mcap {

/** Receives the parts of a message in their order. */
class PartTaker {
public:
    virtual ~PartTaker() = default;
    virtual void beginStruct() = 0;
    virtual void field(std::string_view name) = 0;
    virtual void endStruct() = 0;
    virtual void beginList() = 0;
    virtual void element(std::size_t index) = 0;
    virtual void endList() = 0;
    /** A number or truth value, as JSON writes it but for nan and inf. */
    virtual void number(std::string_view text) = 0;
    virtual void text(std::string_view text) = 0;
};

/** The fields of a message, as a schema with the encoding ros2msg describes them. */
class RosSchema {
public:
    /** False, with the reason and the line, if the text is not valid. */
    bool parse(const std::string& text, std::string& why);

    /** Takes a message apart, which is plain CDR of either byte order. False, with the reason and the byte, if the
        bytes do not fit the schema; the parts before that have been given. */
    bool walk(const unsigned char* data, std::size_t size, PartTaker& taker, std::string& why) const;

    enum class Basic : std::uint8_t {
        Struct,
        Bool,
        Int8,
        UInt8,
        Int16,
        UInt16,
        Int32,
        UInt32,
        Int64,
        UInt64,
        Float32,
        Float64,
        Text,
        WideText
    };
    struct Field {
        std::string name;
        Basic basic = Basic::Struct;
        std::string type;          // of a struct
        std::size_t structAt = 0;  // of a struct: its index
        enum { One, Array, Sequence } many = One;
        std::size_t count = 0;  // of an array
    };
    struct Struct {
        std::string name;  // "package/Name"; empty for the message itself
        std::vector<Field> fields;
    };

private:
    bool addLine(std::string_view line, std::string& why);
    bool resolve(std::string& why);
    /** Why the types of a struct cannot be walked through; null if they can. */
    const char* refusal(std::size_t at, std::size_t depth, std::vector<char>& known) const;

    std::vector<Struct> structs_;
};

}  // namespace oroforge::mcap

#endif
