// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_CAS_HPP
#define ORO_OS_CAS_HPP

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
    static_assert(sizeof(T) <= sizeof(long long), "CAS works on at most 8 bytes");
    T from = T(expected);
    T to = T(value);
    return __atomic_compare_exchange(const_cast<T*>(address), &from, &to, false, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST);
}

}  // namespace os
}  // namespace RTT
#endif
