// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What all that walk through a value share.
#ifndef ORO_ENCODING_DETAIL_WALK_HPP
#define ORO_ENCODING_DETAIL_WALK_HPP

#include <rtt/encoding/Plan.hpp>
#include <rtt/types/SequenceOps.hpp>

namespace RTT {
namespace encoding {
namespace detail {

/** One level more, as long as it exists. False if that is too deep. */
class Deeper {
public:
    explicit Deeper(unsigned& depth) : depth_(depth) { ++depth_; }
    ~Deeper() { --depth_; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;
    explicit operator bool() const { return depth_ <= Plan::kDeepest; }

private:
    unsigned& depth_;
};

/** Calls `each(element)` by way of ops.visit until one call returns false; the result is that of the last call. */
template <class Each>
bool visitWhile(const types::SequenceOps& ops, const void* container, Each each) {
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

}  // namespace detail
}  // namespace encoding
}  // namespace RTT

#endif
