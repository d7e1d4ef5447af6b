// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Combines function objects, for std::visit.
#ifndef ORO_SCRIPTING_DETAIL_OVERLOADED_HPP
#define ORO_SCRIPTING_DETAIL_OVERLOADED_HPP

namespace RTT::scripting::detail {

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

}  // namespace RTT::scripting::detail

#endif
