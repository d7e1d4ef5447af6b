// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_TYPE_CODES_HPP
#define ORO_CORBA_DETAIL_TYPE_CODES_HPP

#include <omniORB4/CORBA.h>

#include <string>

namespace RTT {
namespace types {
class TypeInfo;
}
namespace corba {
namespace detail {

/**
 * How CORBA describes a type, made from its shape, with the ids that the generated transports of the original toolchain
 * have: a struct a::b::T is "IDL:orogen/a/b/Corba/T:1.0". Nil, with the reason in `why`, if the type, or a part of it,
 * has no shape. The bytes of its values are those of encoding::Plan with corbaRules().
 */
CORBA::TypeCode_var typeCodeOf(const types::TypeInfo& type, CORBA::ORB_ptr orb, std::string& why);

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
