// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENUM_CONSTRUCTORS_HPP
#define ORO_ENUM_CONSTRUCTORS_HPP

#include <rtt/types/StructTable.hpp>

namespace RTT {
namespace types {

class TypeInfo;

namespace detail {

/** Adds the silent conversions from int to the enum and, if int is registered, from the enum to int. */
void addEnumConstructors(TypeInfo& info, TypeRef enumType, const EnumOps& numbers);

}  // namespace detail

}  // namespace types
}  // namespace RTT

#endif
