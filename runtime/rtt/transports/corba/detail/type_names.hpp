// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_TYPE_NAMES_HPP
#define ORO_CORBA_DETAIL_TYPE_NAMES_HPP

#include <string>

namespace RTT {
namespace types {
class TypeInfo;
}
namespace corba {
namespace detail {

/** The name of a type in IDL, and its repository id. */
struct IdlName {
    std::string id, name;
};

/** Of a struct, an enumeration or a union: "/a/b/T" is T in the module orogen::a::b::Corba. */
IdlName idlNameOf(const types::TypeInfo& type);
/** Of a container of elements of a type, which is in the module of that type: "vector__a_b_T_". */
IdlName idlNameOfContainer(const types::TypeInfo& container, const types::TypeInfo& element);
/** Of a member or an enumerator: a word that begins with a letter. */
std::string idlMember(const std::string& name);

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
