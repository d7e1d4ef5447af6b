// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENUM_CONSTRUCTORS_HPP
#define ORO_ENUM_CONSTRUCTORS_HPP

#include <rtt/types/StructTable.hpp>
#include <string>

namespace RTT {
namespace types {

class TypeInfo;

namespace detail {

/** The names of values; the tables belong to the typekit. */
struct EnumNames {
    const Enumerator* values;
    std::size_t count;
    const EnumOps& ops;

    /** Sets a value by a name or number; false if the text is neither. Real-time safe. */
    bool set(const std::string& text, void* value) const;
    /** True for the value of an enumerator, for a combination of flags, and for all values of an enum without
        enumerators. */
    bool takes(long long number) const;
    /** The first name of that value, or null. */
    const char* nameOf(const void* value) const;
    /** The first name of the value, or its number. */
    std::string textOf(const void* value) const;
};

/** False if the text is anything else than a whole number in the range of int. */
RTT_API bool readNumber(const std::string& text, int& number);

/** Adds the silent conversions from int and from a name to the enum and back, and the operators == and !=. */
void addEnumConstructors(TypeInfo& info, TypeRef enumType, const EnumNames& names);

}  // namespace detail

}  // namespace types
}  // namespace RTT

#endif
