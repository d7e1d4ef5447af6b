// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_BUILTIN_OPERATOR_ROWS_HPP
#define ORO_BUILTIN_OPERATOR_ROWS_HPP

#include <rtt/types/Operators.hpp>
#include <functional>

namespace RTT {
namespace types {
namespace builtin {

template <class F, class R, class A>
bool callUnary(const void*, const void* const* arguments, void* result) {
    *static_cast<R*>(result) = F()(*static_cast<const A*>(arguments[0]));
    return true;
}

template <class F, class R, class A, class B>
bool callBinary(const void*, const void* const* arguments, void* result) {
    *static_cast<R*>(result) = F()(*static_cast<const A*>(arguments[0]), *static_cast<const B*>(arguments[1]));
    return true;
}

template <class F, class A, class R = A>
constexpr OperatorRow unary(const char* op) {
    return {op, &typeRef<R>, &typeRef<A>, nullptr, &callUnary<F, R, A>};
}

template <class F, class A, class R = A, class B = A>
constexpr OperatorRow binary(const char* op) {
    return {op, &typeRef<R>, &typeRef<A>, &typeRef<B>, &callBinary<F, R, A, B>};
}

template <class T>
void addComparisons() {
    static constexpr OperatorRow rows[] = {
        binary<std::equal_to<>, T, bool>("=="), binary<std::not_equal_to<>, T, bool>("!="),
        binary<std::less<>, T, bool>("<"),      binary<std::less_equal<>, T, bool>("<="),
        binary<std::greater<>, T, bool>(">"),   binary<std::greater_equal<>, T, bool>(">="),
    };
    operators()->add(rows, sizeof rows / sizeof rows[0]);
}

}  // namespace builtin
}  // namespace types
}  // namespace RTT

#endif
