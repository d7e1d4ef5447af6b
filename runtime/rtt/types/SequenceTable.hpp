// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SEQUENCE_TABLE_HPP
#define ORO_SEQUENCE_TABLE_HPP

#include <rtt/rtt-config.h>
#include "SequenceOps.hpp"
#include "StructTable.hpp"
#include "carray.hpp"
#include <memory>

namespace RTT {
namespace types {

namespace detail {

template <class C, class = void>
struct HasCapacity : std::false_type {};
template <class C>
struct HasCapacity<C, std::void_t<decltype(std::declval<const C&>().capacity())>> : std::true_type {};

template <class C, class = void>
struct HasResize : std::false_type {};
template <class C>
struct HasResize<C, std::void_t<decltype(std::declval<C&>().resize(std::size_t(1)))>> : std::true_type {};

template <class C, class = void>
struct HasData : std::false_type {};
template <class C>
struct HasData<C, std::enable_if_t<std::is_same_v<decltype(std::declval<C&>().data()), typename C::value_type*>>>
    : std::true_type {};

/** The functions of SequenceOps for containers with size() and operator[]. */
template <class C>
struct Sequence {
    using Element = typename C::value_type;
    static constexpr bool addressable =
        std::is_same_v<decltype(std::declval<C&>()[0]), std::add_lvalue_reference_t<Element>>;

    static C& of(void* c) { return *static_cast<C*>(c); }
    static const C& of(const void* c) { return *static_cast<const C*>(c); }

    static std::size_t size(const void* c) { return static_cast<std::size_t>(of(c).size()); }
    static std::size_t capacity(const void* c) {
        if constexpr (HasCapacity<C>::value)
            return static_cast<std::size_t>(of(c).capacity());
        else
            return size(c);
    }
    static bool resize(void* c, std::size_t n) {
        of(c).resize(n);
        return true;
    }
    static void* at(void* c, std::size_t i) {
        return const_cast<void*>(static_cast<const void*>(std::addressof(of(c)[i])));
    }
    static void load(const void* c, std::size_t i, void* to) { *static_cast<Element*>(to) = of(c)[i]; }
    static void store(void* c, std::size_t i, const void* from) { of(c)[i] = *static_cast<const Element*>(from); }

    using Resize = bool (*)(void*, std::size_t);
    using At = void* (*)(void*, std::size_t);
    static constexpr Resize resizeOrNull() {
        if constexpr (HasResize<C>::value)
            return &resize;
        else
            return nullptr;
    }
    static void* data(void* c) { return of(c).data(); }
    using Data = void* (*)(void*);
    static constexpr Data dataOrNull() {
        if constexpr (HasData<C>::value)
            return &data;
        else
            return nullptr;
    }
    static constexpr At atOrNull() {
        if constexpr (addressable)
            return &at;
        else
            return nullptr;
    }
};

RTT_API TypeInfoGenerator* newSequenceGenerator(const char* name, const SequenceOps& sequence, const TypeOps& ops,
                                                const TypeThunks& thunks);
RTT_API TypeInfoGenerator* newArrayGenerator(const char* name, const SequenceOps& sequence, const TypeOps& ops,
                                             const TypeThunks& thunks);
}  // namespace detail

/** For std::vector, std::array, boost::array and the like. */
template <class C>
const SequenceOps& sequenceOps() {
    using S = detail::Sequence<C>;
    static constexpr SequenceOps table = {
        &S::size, &S::capacity, S::resizeOrNull(), S::atOrNull(), &S::load, &S::store, &typeRef<typename C::value_type>,
        nullptr,  nullptr,      S::dataOrNull()};
    return table;
}

/** For carray<E>. */
template <class E>
const SequenceOps& arrayOps() {
    return sequenceOps<carray<E>>();
}

}  // namespace types
}  // namespace RTT

#endif
