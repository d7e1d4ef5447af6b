// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The operations on a C++ type by which storage keeps samples without being a template.
#ifndef ORO_TYPES_TYPE_OPS_HPP
#define ORO_TYPES_TYPE_OPS_HPP

#include "ValueTraits.hpp"
#include <cstddef>
#include <new>
#include <type_traits>
#include <typeinfo>
#include <utility>

namespace RTT {
namespace types {

/** One constant table per C++ type. Neither its address nor that of `id` identifies the type: compare id->name() as
    text. */
struct TypeOps {
    std::size_t size, align;
    bool trivial;  ///< trivially copyable and destructible: memcpy will do
    const std::type_info* id;
    void (*construct)(void* at);  ///< value-initialises; null if not default constructible
    void (*copyConstruct)(void* at, const void* from);
    void (*assign)(void* to, const void* from);
    void (*destroy)(void* at) noexcept;
    std::size_t (*extent)(const void* sample);  ///< see SampleExtent; null if trivial
};

/**
 * The amount of memory that a sample owns, in any unit that grows with it. When a sample is larger than all before,
 * storage enlarges its free elements, so that it need not allocate later. For unknown types it is 1, so the first
 * sample counts as the largest.
 */
template <class T, class = void>
struct SampleExtent {
    static std::size_t of(const T&) { return 1; }
};
/** Shared pointers have 0, because copies own no memory but share it. */
template <class T>
struct SampleExtent<T, std::void_t<decltype(*std::declval<const T&>()), decltype(std::declval<const T&>().get())>> {
    static std::size_t of(const T&) { return 0; }
};
/** Strings, vectors and other containers have the number of all elements, including those inside elements. */
template <class T>
struct SampleExtent<
    T, std::enable_if_t<!std::is_same<typename T::value_type, T>::value &&
                            std::is_convertible<decltype(std::declval<const T&>().size()), std::size_t>::value,
                        std::void_t<decltype(std::declval<const T&>().begin())>>> {
    static std::size_t of(const T& sample) {
        typedef typename T::value_type Element;
        std::size_t sum = 1 + static_cast<std::size_t>(sample.size());
        if constexpr (!std::is_trivially_copyable<Element>::value)
            for (const Element& element : sample) sum += SampleExtent<Element>::of(element);
        return sum;
    }
};

namespace detail {

template <class T>
struct Ops {
    // Cold, because it is not on the data path, so that the compiler shares code instead of inlining it.
    [[gnu::cold]] static void construct(void* at) { ::new (at) T(); }
    [[gnu::cold]] static void copyConstruct(void* at, const void* from) {
        ::new (at) T(copyOf<T>(*static_cast<const T*>(from)));
    }
    static void assign(void* to, const void* from) { assignValue(*static_cast<T*>(to), *static_cast<const T*>(from)); }
    [[gnu::cold]] static void destroy(void* at) noexcept { static_cast<T*>(at)->~T(); }
    static std::size_t extent(const void* sample) { return SampleExtent<T>::of(*static_cast<const T*>(sample)); }
    static constexpr bool trivial = std::is_trivially_copyable<T>::value && std::is_trivially_destructible<T>::value;

    using Construct = void (*)(void*);
    static constexpr Construct constructOrNull() {
        if constexpr (std::is_default_constructible<T>::value)
            return &construct;
        else
            return nullptr;
    }
    using Extent = std::size_t (*)(const void*);
    static constexpr Extent extentOrNull() {
        if constexpr (trivial)
            return nullptr;
        else
            return &extent;
    }
};

}  // namespace detail

/** The table of T. Thread-safe, real-time safe. */
template <class T>
inline const TypeOps& typeOps() noexcept {
    static constexpr TypeOps table = {
        sizeof(T),
        alignof(T),
        detail::Ops<T>::trivial,
        &typeid(T),
        detail::Ops<T>::constructOrNull(),
        &detail::Ops<T>::copyConstruct,
        &detail::Ops<T>::assign,
        &detail::Ops<T>::destroy,
        detail::Ops<T>::extentOrNull(),
    };
    return table;
}

}  // namespace types
}  // namespace RTT

#endif
