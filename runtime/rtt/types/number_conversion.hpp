// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_NUMBER_CONVERSION_HPP
#define OROFORGE_NUMBER_CONVERSION_HPP

#include <limits>
#include <type_traits>

namespace RTT {
namespace types {
namespace detail {

/** As static_cast, but a real number beyond the range of an integer type gives the nearest integer of that type, and
    NaN gives 0. */
template <class To, class From>
To converted(From value) {
    if constexpr (std::is_floating_point_v<From> && std::is_integral_v<To> && !std::is_same_v<To, bool>) {
        typedef std::numeric_limits<To> Limits;
        if (value != value) return 0;
        if (value <= static_cast<From>(Limits::min())) return Limits::min();
        if (value >= static_cast<From>(Limits::max())) return Limits::max();
    }
    return static_cast<To>(value);
}

}  // namespace detail
}  // namespace types
}  // namespace RTT

#endif
