// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_FIELDS_HPP
#define ORO_OCL_REPORTING_FIELDS_HPP

#include <rtt/types/Shape.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace OCL::reporting {

enum class Number : unsigned char {
    Bool,
    Char,
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Float,
    Real,
    Text,        ///< no number at all
    Enumeration  ///< Tag::Other in records, see ValueType::numbers
};

struct ValueType {
    Number number = Number::Text;
    const RTT::types::EnumOps* numbers = nullptr;  ///< of an Enumeration
    std::vector<RTT::types::Shape::Enumerator> enumerators;
};

/**
 * What the records of a report consist of, from names to types. A record has the values in the same order, each
 * sequence with its present size, so that fields stay the same while sequences grow and shrink.
 */
struct Field {
    enum class Kind {
        Value,
        Group,    ///< has members: `parts`
        Sequence  ///< has elements of one kind: the only one of `parts`
    };

    std::string name;
    Kind kind = Kind::Value;
    ValueType type;        ///< of a Value
    bool mayGrow = false;  ///< of a Sequence
    std::string description, unit;
    std::vector<Field> parts;
};

/** Sets description and unit from a text such as "What comes in. [m3/s]". */
void describe(Field& field, const std::string& text);

}  // namespace OCL::reporting

#endif
