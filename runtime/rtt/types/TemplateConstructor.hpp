// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TEMPLATE_CONSTRUCTOR_HPP
#define ORO_TEMPLATE_CONSTRUCTOR_HPP

#include "ErasedFunction.hpp"
#include "TypeConstructor.hpp"
#include "Types.hpp"

namespace RTT {
namespace types {

namespace detail {
RTT_API TypeConstructor* newErasedConstructor(const ErasedFunction& function, bool automatic);
}

/**
 * A constructor from a function or function object of up to three values, for TypeInfo::addConstructor().
 * With one argument it is a conversion, too: silent if `automatic`, else with a warning in the log.
 */
template <class F>
TypeConstructor* newConstructor(F function, bool automatic = false) {
    return detail::newErasedConstructor(eraseFunction(std::move(function)), automatic);
}

}  // namespace types
}  // namespace RTT

#endif
