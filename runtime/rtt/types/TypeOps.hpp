// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What storage must know of a C++ type to keep samples of it without being a template.
#ifndef ORO_TYPES_TYPE_OPS_HPP
#define ORO_TYPES_TYPE_OPS_HPP

#include <cstddef>
#include <new>
#include <type_traits>
#include <typeinfo>

namespace RTT {
namespace types {

/** One constant table per C++ type. Neither its address nor that of `id` identifies the type: compare id->name() as text. */
struct TypeOps {
    std::size_t size, align;
    bool trivial;  ///< trivially copyable and destructible: memcpy will do
    const std::type_info* id;
    void (*construct)(void* at);  ///< value-initialises; null if not default constructible
    void (*copyConstruct)(void* at, const void* from);
    void (*assign)(void* to, const void* from);
    void (*destroy)(void* at) noexcept;
};

namespace detail {

template <class T>
struct Ops {
    static void construct(void* at) { new (at) T(); }
    static void copyConstruct(void* at, const void* from) { new (at) T(*static_cast<const T*>(from)); }
    static void assign(void* to, const void* from) { *static_cast<T*>(to) = *static_cast<const T*>(from); }
    static void destroy(void* at) noexcept { static_cast<T*>(at)->~T(); }

    using Construct = void (*)(void*);
    static constexpr Construct constructOrNull() {
        if constexpr (std::is_default_constructible<T>::value)
            return &construct;
        else
            return nullptr;
    }
};

}  // namespace detail

/** The table of T. Thread-safe, real-time safe. */
template <class T>
inline const TypeOps& typeOps() noexcept {
    static constexpr TypeOps table = {
        sizeof(T),
        alignof(T),
        std::is_trivially_copyable<T>::value && std::is_trivially_destructible<T>::value,
        &typeid(T),
        detail::Ops<T>::constructOrNull(),
        &detail::Ops<T>::copyConstruct,
        &detail::Ops<T>::assign,
        &detail::Ops<T>::destroy,
    };
    return table;
}

}  // namespace types
}  // namespace RTT

#endif
