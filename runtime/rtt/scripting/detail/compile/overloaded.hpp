// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// One function object of several, for std::visit.
#ifndef ORO_SCRIPTING_DETAIL_OVERLOADED_HPP
#define ORO_SCRIPTING_DETAIL_OVERLOADED_HPP

namespace RTT {
namespace scripting {
namespace detail {

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

}  // namespace detail
}  // namespace scripting
}  // namespace RTT

#endif
