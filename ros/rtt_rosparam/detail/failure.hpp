// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSPARAM_DETAIL_FAILURE_HPP
#define RTT_ROSPARAM_DETAIL_FAILURE_HPP

#include <stdexcept>

namespace rtt_rosparam {

/** Why a parameter could not be read, written or converted: text for the log. */
struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace rtt_rosparam

#endif
