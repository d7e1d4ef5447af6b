// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEMA_MESSAGE_SCHEMA_HPP
#define OROFORGE_SCHEMA_MESSAGE_SCHEMA_HPP

#include "part_taker.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace oroforge::schema {

/** Types that bytes are read as. An enum is an integer, and a char a UInt8. */
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

/** A sequence, or an array of so many elements. */
struct Many {
    bool isSequence = false;
    std::size_t count = 0;
};

struct Field {
    std::string name;
    Basic basic = Basic::Struct;
    std::string type;                  ///< of a struct: its name as the field has it
    std::size_t structAt = 0;          ///< of a struct: its index
    std::vector<Many> lists;           ///< the outermost first; a single value has none
    std::vector<std::int64_t> labels;  ///< of a union: the values of the discriminator that choose this field
    bool isDefault = false;            ///< of a union: all other values do
    std::size_t line = 0;              ///< of the text
};

struct Struct {
    std::string name;  ///< "package/Name", or "module::Name" in IDL; in ros2msg, that of the message itself is empty
    std::vector<Field> fields;
    bool hasByte = false;  ///< it has no fields and one byte
    bool isUnion = false;
    Basic discriminator = Basic::UInt32;  ///< of a union
};

/** The fields of a message, as a text in one of the languages of recordings describes them. */
class MessageSchema {
public:
    /** Is it "ros2msg", "omgidl" or "ros2idl"? */
    static bool isKnown(const std::string& encoding);

    /** Reads the text of a schema. `name` is that of the type of the message, "tank/msg/Level" or "tank::Level", which
        ros2msg does not need. False, with the reason and the line, if the text is not valid or describes what cannot
        be read. */
    bool read(const std::string& encoding, const std::string& name, const std::string& text, std::string& why);

    /** Takes a message apart, which is plain CDR of either byte order. False, with the reason and the byte, if the
        bytes do not fit the schema; the parts before that have been given. */
    bool walk(const unsigned char* data, std::size_t size, PartTaker& taker, std::string& why) const;

    /** All structs; fields refer to them by index. */
    const std::vector<Struct>& structs() const { return structs_; }
    /** The message itself. Requires that read() was successful. */
    const Struct& root() const { return structs_[root_]; }

private:
    std::vector<Struct> structs_;
    std::size_t root_ = 0;
};

}  // namespace oroforge::schema

#endif
