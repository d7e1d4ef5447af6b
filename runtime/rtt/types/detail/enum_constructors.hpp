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

/** The enumerators by which a value is called; the tables belong to the typekit. */
struct EnumNames {
    const Enumerator* values;
    std::size_t count;
    const EnumOps& ops;

    /** By a name, or a number; false, and nothing changed, if it is neither. Real-time safe. */
    bool set(const std::string& text, void* value) const;
    /** True for the value of an enumerator and, where these are flags, for a combination of them; for all of an enum
        without enumerators. */
    bool takes(long long number) const;
    /** The first name of that value, or null. */
    const char* nameOf(const void* value) const;
    /** That name, else its number. */
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
