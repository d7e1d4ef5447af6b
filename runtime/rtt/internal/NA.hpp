// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_NA_HPP
#define ORO_INTERNAL_NA_HPP

#include <rtt/rtt-config.h>

#include <type_traits>

namespace RTT {
namespace internal {

/** Throws std::logic_error: there is neither a result nor a default value of its type. */
[[noreturn]] RTT_API void throwNoValue();

/** The value of type T that means "there is none": a default value. Throws for types that have none. */
template <class T>
struct NA {
    static T na() {
        if constexpr (std::is_default_constructible_v<T>)
            return T();
        else
            throwNoValue();
    }
};
template <class T>
struct NA<const T> : NA<T> {};
template <class T>
struct NA<T&> {
    static T& na() {
        if constexpr (std::is_default_constructible_v<std::remove_const_t<T>>) {
            static std::remove_const_t<T> none{};
            return none;
        } else {
            throwNoValue();
        }
    }
};
template <>
struct NA<void> {
    static void na() {}
};

}  // namespace internal
}  // namespace RTT

#endif
