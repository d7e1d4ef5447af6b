// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Small function objects that typekits expect here, some of them in namespace std.
#ifndef ORO_MYSTD_HPP
#define ORO_MYSTD_HPP

#include <functional>

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

namespace std {
/** Base of three-argument function objects; typekits of RTT find it in this namespace. */
template <class Arg1, class Arg2, class Arg3, class Result>
struct ternary_function {
    typedef Arg1 first_argument_type;
    typedef Arg2 second_argument_type;
    typedef Arg3 third_argument_type;
    typedef Result result_type;
};

template <class Arg1, class Arg2, class Arg3, class Result>
class pointer_to_ternary_function : public ternary_function<Arg1, Arg2, Arg3, Result> {
public:
    explicit pointer_to_ternary_function(Result (*function)(Arg1, Arg2, Arg3)) : function_(function) {}
    Result operator()(Arg1 a, Arg2 b, Arg3 c) const { return function_(a, b, c); }

private:
    Result (*function_)(Arg1, Arg2, Arg3);
};

/** Complements the overloads of the standard library for one and two arguments. */
template <class Arg1, class Arg2, class Arg3, class Result>
pointer_to_ternary_function<Arg1, Arg2, Arg3, Result> ptr_fun(Result (*function)(Arg1, Arg2, Arg3)) {
    return pointer_to_ternary_function<Arg1, Arg2, Arg3, Result>(function);
}

using RTT::internal::adds3;
using RTT::internal::divides3;
using RTT::internal::multiplies3;
using RTT::internal::subs3;
}  // namespace std

#endif
