// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_CAS_HPP
#define ORO_OS_CAS_HPP

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace RTT {
namespace os {

/**
 * Replaces *address by value if it still holds expected. Returns true if it did. Sequentially consistent,
 * lock-free, real-time safe. For integers, pointers and plain structs of 1, 2, 4 or 8 bytes.
 */
template <typename T, typename V, typename W>
bool CAS(volatile T* address, const V& expected, const W& value) noexcept {
    static_assert(std::is_trivially_copyable<T>::value, "CAS needs a trivially copyable type");
    static_assert(sizeof(T) == 1 || sizeof(T) == 2 || sizeof(T) == 4 || sizeof(T) == 8,
                  "CAS works on 1, 2, 4 or 8 bytes");
    // Uses a number of that size: for a struct of smaller members, Clang would call a function that may lock.
    using Number = std::conditional_t<sizeof(T) <= 2, std::conditional_t<sizeof(T) == 1, std::uint8_t, std::uint16_t>,
                                      std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>;
    typedef Number __attribute__((may_alias)) Bits;
    const T wanted = T(expected);
    const T next = T(value);
    Bits from, to;
    std::memcpy(&from, &wanted, sizeof(T));
    std::memcpy(&to, &next, sizeof(T));
    return __atomic_compare_exchange_n(reinterpret_cast<Bits*>(const_cast<T*>(address)), &from, to, false,
                                       __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST);
}

}  // namespace os
}  // namespace RTT
#endif
