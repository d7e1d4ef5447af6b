// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values of restricted types: without a default constructor, or not assignable because of a constant member.
#ifndef ORO_TYPES_VALUE_TRAITS_HPP
#define ORO_TYPES_VALUE_TRAITS_HPP

#include <type_traits>
#include <utility>

namespace RTT {
namespace types {

/** The first value of a variable or property. Typekits specialise it for types with `[[oro::make(…)]]`. */
template <class T>
struct ValueTraits {
    static T make() { return T(); }
};

/** Whether ports can have T, because their storage makes values in advance and assigns them. */
template <class T>
inline constexpr bool isSample =
    std::is_default_constructible<T>::value&& std::is_copy_constructible<T>::value&& std::is_copy_assignable<T>::value;

namespace detail {
// For types that are costly to copy, the code is in one place instead of being inlined at each use.
template <class T>
[[gnu::noinline]] T copyApart(const T& value) {
    return value;
}
template <class T>
[[gnu::noinline]] T moveApart(T& value) {
    return std::move(value);
}
template <class T>
[[gnu::noinline]] void assignApart(T& to, const T& from) {
    to = from;
}
template <class T>
[[gnu::cold, gnu::noinline]] void resetApart(T& value) {
    // Not moved, because that would instantiate another function of T.
    const T first = ValueTraits<T>::make();
    assignApart(value, first);
}
}  // namespace detail

/** Assigns; false if values of T cannot be assigned, so that properties and attributes of T are read-only. */
template <class T>
bool assignValue(T& to, const T& from) {
    if constexpr (std::is_trivially_copyable<T>::value && std::is_copy_assignable<T>::value) {
        to = from;
        return true;
    } else if constexpr (std::is_copy_assignable<T>::value) {
        detail::assignApart(to, from);
        return true;
    } else {
        (void)to;
        (void)from;
        return false;
    }
}

/** Resets it to its first value, if values of T can be assigned. */
template <class T>
void resetValue(T& value) {
    if constexpr (std::is_copy_assignable<T>::value)
        detail::resetApart(value);
    else
        (void)value;
}

/** The same for code that does not know T. */
template <class T>
[[gnu::cold]] void resetValueAt(void* value) {
    resetValue(*static_cast<T*>(value));
}

/** `value` as a function returns it. */
template <class Result, class T>
Result copyOf(T& value) {
    typedef std::remove_cv_t<Result> Plain;
    if constexpr (std::is_reference<Result>::value || std::is_trivially_copyable<Plain>::value)
        return value;
    else
        return detail::copyApart<Plain>(value);
}

/** Passes on `value`, which is not used later. */
template <class T>
T movedFrom(T& value) {
    if constexpr (std::is_trivially_copyable<T>::value)
        return value;
    else
        return detail::moveApart(value);
}

}  // namespace types
}  // namespace RTT

#endif
