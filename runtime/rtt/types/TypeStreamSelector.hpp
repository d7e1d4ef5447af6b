// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPE_STREAM_SELECTOR_HPP
#define ORO_TYPE_STREAM_SELECTOR_HPP

#include <istream>
#include <ostream>
#include <type_traits>
#include <utility>

namespace RTT {
namespace types {

namespace detail {
template <class T, class = void>
struct HasOstream : std::false_type {};
template <class T>
struct HasOstream<T, std::void_t<decltype(std::declval<std::ostream&>() << std::declval<const T&>())>>
    : std::true_type {};
template <class T, class = void>
struct HasIstream : std::false_type {};
template <class T>
struct HasIstream<T, std::void_t<decltype(std::declval<std::istream&>() >> std::declval<T&>())>> : std::true_type {};
}  // namespace detail

/** Uses the stream operators of T if `use_ostream`; even then, T need not have an operator>>. */
template <class T, bool use_ostream>
struct TypeStreamSelector {
    static std::ostream& write(std::ostream& os, const T& value) { return os << value; }
    static std::istream& read(std::istream& is, T& value) {
        if constexpr (detail::HasIstream<T>::value)
            is >> value;
        else
            is.setstate(std::ios::failbit);
        return is;
    }
};

template <class T>
struct TypeStreamSelector<T, false> {
    static std::ostream& write(std::ostream& os, const T&) { return os; }
    static std::istream& read(std::istream& is, T&) { return is; }
};

}  // namespace types
}  // namespace RTT

#endif
