// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Finds the signature of anything that can be called.
#ifndef ORO_INTERNAL_SIGNATURE_HPP
#define ORO_INTERNAL_SIGNATURE_HPP

#include <functional>

namespace boost {
template <typename Signature>
class function;
}

namespace RTT {
namespace internal {

template <class F>
struct SignatureOf : SignatureOf<decltype(&F::operator())> {};
template <class R, class... A>
struct SignatureOf<R(A...)> {
    typedef R type(A...);
};
template <class R, class... A>
struct SignatureOf<R (*)(A...)> {
    typedef R type(A...);
};
template <class R, class... A>
struct SignatureOf<R (*)(A...) noexcept> {
    typedef R type(A...);
};
template <class C, class R, class... A>
struct SignatureOf<R (C::*)(A...)> {
    typedef R type(A...);
};
template <class C, class R, class... A>
struct SignatureOf<R (C::*)(A...) const> {
    typedef R type(A...);
};
template <class C, class R, class... A>
struct SignatureOf<R (C::*)(A...) noexcept> {
    typedef R type(A...);
};
template <class C, class R, class... A>
struct SignatureOf<R (C::*)(A...) const noexcept> {
    typedef R type(A...);
};
template <class S>
struct SignatureOf<boost::function<S>> {
    typedef S type;
};
template <class S>
struct SignatureOf<std::function<S>> {
    typedef S type;
};

/** A member function bound to an object, which is anything that `->` works on. */
template <class Member, class Object, class Signature = typename SignatureOf<Member>::type>
struct BoundMember;
template <class Member, class Object, class R, class... A>
struct BoundMember<Member, Object, R(A...)> {
    Member member;
    Object object;
    R operator()(A... args) const { return ((*object).*member)(static_cast<A>(args)...); }
};

}  // namespace internal
}  // namespace RTT

#endif
