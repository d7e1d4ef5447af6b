// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What all that walk through a value share.
#ifndef ORO_ENCODING_DETAIL_WALK_HPP
#define ORO_ENCODING_DETAIL_WALK_HPP

#include <rtt/encoding/Plan.hpp>
#include <rtt/types/Temporary.hpp>
#include <rtt/types/visit_elements.hpp>

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

using types::Temporary;
using types::visitWhile;

}  // namespace detail
}  // namespace encoding
}  // namespace RTT

#endif
