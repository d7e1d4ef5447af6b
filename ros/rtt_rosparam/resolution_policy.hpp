// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSPARAM_RESOLUTION_POLICY_HPP
#define RTT_ROSPARAM_RESOLUTION_POLICY_HPP

namespace rtt_rosparam {

/** The parameter that belongs to the property n of component C. */
enum ResolutionPolicy {
    RELATIVE = 0,           ///< n: in the namespace of the node
    ABSOLUTE = 1,           ///< /n
    PRIVATE = 2,            ///< ~n: below the node
    COMPONENT_PRIVATE = 3,  ///< ~C/n
    COMPONENT = 3,
    COMPONENT_RELATIVE = 4,  ///< C/n
    COMPONENT_ABSOLUTE = 5   ///< /C/n
};

}  // namespace rtt_rosparam

#endif
