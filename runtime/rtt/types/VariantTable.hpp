// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_VARIANT_TABLE_HPP
#define ORO_VARIANT_TABLE_HPP

#include <rtt/rtt-config.h>
#include "StructTable.hpp"
#include "TypeThunks.hpp"
#include <utility>
#include <variant>

namespace RTT {
namespace types {

/** Access to the alternatives of a std::variant of an erased type. One constant table per variant type. */
struct VariantOps {
    std::size_t (*index)(const void* variant);
    void (*choose)(void* variant, std::size_t index);  ///< assigns a default value of that type
    /** As for a container with one element of each type, of which only the one at index() exists. Storing changes
        index(). */
    SequenceOps elements;
    const TypeRef* types;
    std::size_t count;
};

namespace detail {

template <class V, class Indices = std::make_index_sequence<std::variant_size_v<V>>>
struct Alternatives;

template <class V, std::size_t... I>
struct Alternatives<V, std::index_sequence<I...>> {
    static std::size_t index(const void* variant) { return static_cast<const V*>(variant)->index(); }
    static std::size_t count(const void*) { return sizeof...(I); }

    template <std::size_t i>
    static void* get(void* variant) {
        return std::get_if<i>(static_cast<V*>(variant));
    }
    template <std::size_t i>
    static void copy(const void* variant, void* to) {
        using T = std::variant_alternative_t<i, V>;
        const T* const from = std::get_if<i>(static_cast<const V*>(variant));
        *static_cast<T*>(to) = from ? *from : T();
    }
    template <std::size_t i>
    static void set(void* variant, const void* from) {
        static_cast<V*>(variant)->template emplace<i>(*static_cast<const std::variant_alternative_t<i, V>*>(from));
    }

    static void* at(void* variant, std::size_t i) {
        static constexpr void* (*all[])(void*) = {&get<I>...};
        return all[i](variant);
    }
    static void load(const void* variant, std::size_t i, void* to) {
        static constexpr void (*all[])(const void*, void*) = {&copy<I>...};
        all[i](variant, to);
    }
    static void store(void* variant, std::size_t i, const void* from) {
        static constexpr void (*all[])(void*, const void*) = {&set<I>...};
        all[i](variant, from);
    }
    template <std::size_t i>
    static void emplace(void* variant) {
        static_cast<V*>(variant)->template emplace<i>();
    }
    static void choose(void* variant, std::size_t i) {
        static constexpr void (*all[])(void*) = {&emplace<I>...};
        all[i](variant);
    }
    static constexpr TypeRef types[] = {&typeRef<std::variant_alternative_t<I, V>>...};
};

/** `names` are those of the alternatives, in order. */
RTT_API TypeInfoGenerator* newVariantGenerator(const char* name, const char* const* names, const VariantOps& variant,
                                               const TypeOps& ops, const TypeThunks& thunks);

}  // namespace detail

template <class V>
const VariantOps& variantOps() {
    using A = detail::Alternatives<V>;
    static constexpr VariantOps table = {
        &A::index,
        &A::choose,
        {&A::count, &A::count, nullptr, &A::at, &A::load, &A::store, nullptr},
        A::types,
        std::variant_size_v<V>,
    };
    return table;
}

/** A std::variant, with the members "alternative", which is the name, and "value". */
template <class V>
TypeInfoGenerator* makeVariantType(const char* name, const char* const* alternatives) {
    return detail::newVariantGenerator(name, alternatives, variantOps<V>(), typeOps<V>(), typeThunks<V>());
}

}  // namespace types
}  // namespace RTT

#endif
