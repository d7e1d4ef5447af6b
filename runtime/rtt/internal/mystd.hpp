// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Small function objects that typekits expect here, one of them in namespace std.
#ifndef ORO_MYSTD_HPP
#define ORO_MYSTD_HPP

namespace std {
/** Base of three-argument function objects; typekits of RTT find it in this namespace. */
template <class Arg1, class Arg2, class Arg3, class Result>
struct ternary_function {
    typedef Arg1 first_argument_type;
    typedef Arg2 second_argument_type;
    typedef Arg3 third_argument_type;
    typedef Result result_type;
};
}  // namespace std

namespace RTT {
namespace internal {

template <class T>
struct identity {
    typedef T argument_type;
    typedef T result_type;
    const T& operator()(const T& value) const { return value; }
};

template <class R, class A, class B>
struct multiplies3 {
    typedef A first_argument_type;
    typedef B second_argument_type;
    typedef R result_type;
    R operator()(A a, B b) const { return a * b; }
};

template <class R, class A, class B>
struct divides3 {
    typedef A first_argument_type;
    typedef B second_argument_type;
    typedef R result_type;
    R operator()(A a, B b) const { return a / b; }
};

template <class R, class A, class B>
struct adds3 {
    typedef A first_argument_type;
    typedef B second_argument_type;
    typedef R result_type;
    R operator()(A a, B b) const { return a + b; }
};

template <class R, class A, class B>
struct subs3 {
    typedef A first_argument_type;
    typedef B second_argument_type;
    typedef R result_type;
    R operator()(A a, B b) const { return a - b; }
};

}  // namespace internal
}  // namespace RTT

#endif
