// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Used by generated typekits: constant tables that describe types, and functions that turn a table into a generator for
// TypeInfoRepository::addType(). All tables must have static storage.
#ifndef ORO_GENERATED_TYPEKIT_HPP
#define ORO_GENERATED_TYPEKIT_HPP

#include "SequenceTable.hpp"
#include "StructTable.hpp"
#include "TypeInfoGenerator.hpp"
#include "TypeThunks.hpp"
#include "carray.hpp"

namespace RTT {
namespace types {

/** Adds a type to the registry and takes ownership of the generator. Logs an error and returns false if that fails. */
RTT_API bool addType(TypeInfoGenerator* generator);
/** Adds another name for the type `of`; false if there is no such type. */
RTT_API bool aliasType(const char* alias, const char* of);

/** A struct with the given members: live access by name, property bags, and the text form "{a = 1, b = 2}". */
template <class T>
TypeInfoGenerator* makeStructType(const char* name, const Member* members, std::size_t count, const char* doc = "") {
    return detail::newStructGenerator(name, members, count, doc, typeOps<T>(), typeThunks<T>());
}

/** An enum: its text form is the first name of the value; all names can be read. */
template <class E>
TypeInfoGenerator* makeEnumType(const char* name, const Enumerator* values, std::size_t count, const char* doc = "") {
    return detail::newEnumGenerator(name, values, count, doc, typeOps<E>(), typeThunks<E>(), enumOps<E>(), &typeRef<E>);
}

/** A container: std::vector, std::array and the like, others by a table of ContainerTable.hpp. */
template <class C>
TypeInfoGenerator* makeSequenceType(const char* name, const SequenceOps& elements = sequenceOps<C>()) {
    return detail::newSequenceGenerator(name, elements, typeOps<C>(), typeThunks<C>());
}

/** The type of members declared E m[N] or std::array<E, N> m. */
template <class E>
TypeInfoGenerator* makeArrayType(const char* name) {
    return detail::newArrayGenerator(name, arrayOps<E>(), typeOps<carray<E>>(), typeThunks<carray<E>>());
}

// The runtime instantiates them for fundamental types, so that typekits with such members need not.
#define ORO_FUNDAMENTAL_TYPES(USE) \
    USE(bool)                      \
    USE(char)                      \
    USE(signed char)               \
    USE(unsigned char)             \
    USE(short)                     \
    USE(unsigned short)            \
    USE(int)                       \
    USE(unsigned int)              \
    USE(long)                      \
    USE(unsigned long)             \
    USE(long long)                 \
    USE(unsigned long long)        \
    USE(float)                     \
    USE(double)
#define ORO_MADE_BY_RUNTIME(E) extern template TypeInfoGenerator* makeArrayType<E>(const char* name);
ORO_FUNDAMENTAL_TYPES(ORO_MADE_BY_RUNTIME)
#undef ORO_MADE_BY_RUNTIME

}  // namespace types
}  // namespace RTT

#endif
