// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_NA_HPP
#define ORO_INTERNAL_NA_HPP

#include <type_traits>

namespace RTT {
namespace internal {

/** The value of type T that stands for "there is none": a default one. */
template <class T>
struct NA {
    static T na() { return T(); }
};
template <class T>
struct NA<const T> : NA<T> {};
template <class T>
struct NA<T&> {
    static T& na() {
        static std::remove_const_t<T> none{};
        return none;
    }
};
template <>
struct NA<void> {
    static void na() {}
};

}  // namespace internal
}  // namespace RTT

#endif
