// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A C++ type as the plugin being compiled knows it, which ports compare when they are connected.
#ifndef ORO_TYPES_SCHEMA_HPP
#define ORO_TYPES_SCHEMA_HPP

#include <rtt/rtt-config.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

namespace RTT {
namespace types {

struct Schema;

/** One field of a struct, alternative of a variant, or enumerator. */
struct SchemaField {
    const char* name;
    const char* type;       ///< C++ type with array bounds, and with the width of a bit-field; "" for an enumerator
    long long place;        ///< in bits from the start of the struct, -1 if it has none; the value of an enumerator
    const char* unit;       ///< "" if unknown
    const Schema& (*of)();  ///< for user types and types made of them; otherwise null
};

/** A type as one plugin knows it. A constant with static storage in that plugin. */
struct Schema {
    const char* name;           ///< C++ name; "" if only the size is known
    std::size_t size, align;    ///< bytes
    const SchemaField* fields;  ///< for a container without a name: its element
    std::size_t count;
    bool isEnum;
};

/** Names T for overloads of describeType(), which generated headers (<package/typekit/Types.hpp>) declare. */
template <class T>
struct TypeTag {};

template <class T>
RTT_HIDE const Schema& schemaOf();

namespace detail {

template <class T, class = void>
struct IsComplete : std::false_type {};
template <class T>
struct IsComplete<T, std::void_t<decltype(sizeof(T))>> : std::is_object<T> {};

/** The field that stands for all elements of a container. */
template <class T, class = void>
struct RTT_HIDE ElementField {
    static constexpr const SchemaField* fields = nullptr;
    static constexpr std::size_t count = 0;
};
template <class T>
struct RTT_HIDE ElementField<
    T, std::enable_if_t<!std::is_same<typename T::value_type, T>::value && IsComplete<typename T::value_type>::value>> {
    static constexpr SchemaField fields[] = {{"[]", "", 0, "", &schemaOf<typename T::value_type>}};
    static constexpr std::size_t count = 1;
};

/** The entries of maps, and pairs. */
template <class T>
struct RTT_HIDE ElementField<
    T, std::enable_if_t<IsComplete<typename T::first_type>::value && IsComplete<typename T::second_type>::value>> {
    static constexpr SchemaField fields[] = {{"first", "", -1, "", &schemaOf<typename T::first_type>},
                                             {"second", "", -1, "", &schemaOf<typename T::second_type>}};
    static constexpr std::size_t count = 2;
};

}  // namespace detail

/** For types without a generated header: the size, and the elements of a container. */
template <class T>
RTT_HIDE const Schema& describeType(TypeTag<T>) {
    static constexpr Schema schema = {
        "", sizeof(T), alignof(T), detail::ElementField<T>::fields, detail::ElementField<T>::count, false};
    return schema;
}

/** What this plugin knows of T. Hidden, so that each plugin has its own. Generated headers may be included anywhere in
    the translation unit. Thread-safe, real-time safe. */
template <class T>
const Schema& schemaOf() {
    return describeType(TypeTag<T>());
}

/**
 * Empty if samples can pass between plugins with these schemas. Otherwise the first difference, as a sentence that
 * calls the two `here` and `there`: "field 'pose.x' is at byte 8 in A.out, at byte 16 in B.in". Names, types, places
 * and units of fields must agree if both sides know them; enumerators that both have must have the same number.
 * Allocates.
 */
RTT_API std::string schemaDifference(const Schema& a, const Schema& b, const std::string& here,
                                     const std::string& there);

/** Equal for equal sizes, alignments and places of all fields, inner ones included, whatever their names. Allocates. */
RTT_API std::uint64_t layoutHash(const Schema& schema);
/** Equal for equal names and types of all fields and enumerators, inner ones included. Allocates. */
RTT_API std::uint64_t schemaHash(const Schema& schema);

}  // namespace types
}  // namespace RTT

#endif
