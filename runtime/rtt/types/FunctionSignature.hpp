// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Finds the signature of function objects that typekits pass to newConstructor(), newBinaryOperator() and others.
#ifndef ORO_FUNCTION_SIGNATURE_HPP
#define ORO_FUNCTION_SIGNATURE_HPP

#include <type_traits>

namespace RTT {
namespace types {
namespace detail {

template <class S>
struct Signature;
template <class R, class... A>
struct Signature<R(A...)> {
    typedef R result;
};

template <class M>
struct OfMember;
template <class C, class R, class... A>
struct OfMember<R (C::*)(A...)> {
    typedef Signature<R(A...)> type;
};
template <class C, class R, class... A>
struct OfMember<R (C::*)(A...) const> {
    typedef Signature<R(A...)> type;
};
template <class C, class R, class... A>
struct OfMember<R (C::*)(A...) const noexcept> {
    typedef Signature<R(A...)> type;
};

// In order of preference: `typedef R Signature(A…)`, the typedefs of std::unary_function and its siblings, operator().
template <class F, class = void>
struct ByOperator : OfMember<decltype(&F::operator())> {};
template <class F, class = void>
struct ByUnary : ByOperator<F> {};
template <class F>
struct ByUnary<F, std::void_t<typename F::result_type, typename F::argument_type>> {
    typedef Signature<typename F::result_type(typename F::argument_type)> type;
};
template <class F, class = void>
struct ByBinary : ByUnary<F> {};
template <class F>
struct ByBinary<
    F, std::void_t<typename F::result_type, typename F::first_argument_type, typename F::second_argument_type>> {
    typedef Signature<typename F::result_type(typename F::first_argument_type, typename F::second_argument_type)> type;
};
template <class F, class = void>
struct ByTernary : ByBinary<F> {};
template <class F>
struct ByTernary<F, std::void_t<typename F::result_type, typename F::first_argument_type,
                                typename F::second_argument_type, typename F::third_argument_type>> {
    typedef Signature<typename F::result_type(typename F::first_argument_type, typename F::second_argument_type,
                                              typename F::third_argument_type)>
        type;
};
template <class F, class = void>
struct SignatureOf : ByTernary<F> {};
template <class F>
struct SignatureOf<F, std::void_t<typename F::Signature>> {
    typedef Signature<typename F::Signature> type;
};
template <class R, class... A>
struct SignatureOf<R (*)(A...), void> {
    typedef Signature<R(A...)> type;
};
template <class R, class... A>
struct SignatureOf<R (*)(A...) noexcept, void> {
    typedef Signature<R(A...)> type;
};

}  // namespace detail
}  // namespace types
}  // namespace RTT

#endif
