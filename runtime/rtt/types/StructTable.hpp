// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_STRUCT_TABLE_HPP
#define ORO_STRUCT_TABLE_HPP

#include <rtt/rtt-config.h>
#include "SequenceOps.hpp"
#include <cstddef>
#include <type_traits>
#include <typeinfo>

namespace RTT {
namespace types {

class TypeInfoGenerator;
struct TypeOps;
struct TypeThunks;

template <class T>
const char* typeRef() {
    return typeid(T).name();
}

/** One field of a struct. */
struct Member {
    const char* name;
    std::size_t offset;
    TypeRef type;       ///< the type of the field, or of the element of an array
    std::size_t count;  ///< 0 if it is not an array
    const char* doc;
    const char* unit;
    TypeRef whole = nullptr;              ///< the type of an array that is a class, such as boost::array
    const SequenceOps* access = nullptr;  ///< for a field without an address (see memberAccess()), which has no offset
    const char* range = "";               ///< legal values, as text: "0..5"
    const char* also = "";                ///< another name for scripts and property files
};

/** Copies a field out of its struct and back: bit-fields, packed fields and fields behind functions. Without `store` it
    is read-only. The index is not used. */
constexpr SequenceOps memberAccess(void (*load)(const void* object, std::size_t, void* field),
                                   void (*store)(void* object, std::size_t, const void* field)) {
    constexpr auto any = [](const void*) { return ~std::size_t(0); };
    return {any, any, nullptr, nullptr, load, store, nullptr};
}

struct Enumerator {
    const char* name;
    long long value;  ///< for unsigned types of 64 bits: the same bits
    const char* doc;
};

/** Reads and writes the number behind an enum. */
struct EnumOps {
    long long (*get)(const void* value);
    void (*set)(void* value, long long number);
    bool isUnsigned;
};

template <class E>
const EnumOps& enumOps() {
    using Number = std::underlying_type_t<E>;
    static constexpr EnumOps table = {
        [](const void* value) { return static_cast<long long>(static_cast<Number>(*static_cast<const E*>(value))); },
        [](void* value, long long number) { *static_cast<E*>(value) = static_cast<E>(static_cast<Number>(number)); },
        std::is_unsigned_v<Number>,
    };
    return table;
}

namespace detail {
RTT_API TypeInfoGenerator* newStructGenerator(const char* name, const Member* members, std::size_t count,
                                              const char* doc, const TypeOps& ops, const TypeThunks& thunks);
RTT_API TypeInfoGenerator* newEnumGenerator(const char* name, const Enumerator* values, std::size_t count,
                                            const char* doc, const TypeOps& ops, const TypeThunks& thunks,
                                            const EnumOps& enumOps, TypeRef type);
}  // namespace detail

}  // namespace types
}  // namespace RTT

#endif
