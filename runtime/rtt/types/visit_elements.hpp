// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPES_VISIT_ELEMENTS_HPP
#define ORO_TYPES_VISIT_ELEMENTS_HPP

#include "SequenceOps.hpp"

namespace RTT {
namespace types {

/** Calls `each(element)` by way of ops.visit until one call returns false; the result is that of the last call. */
template <class Each>
bool visitWhile(const SequenceOps& ops, const void* container, Each each) {
    struct Visit {
        Each& each;
        bool goesOn;
    } visit{each, true};
    ops.visit(
        container,
        [](void* context, const void* element) {
            Visit& one = *static_cast<Visit*>(context);
            one.goesOn = one.goesOn && one.each(element);
        },
        &visit);
    return visit.goesOn;
}

}  // namespace types
}  // namespace RTT

#endif
