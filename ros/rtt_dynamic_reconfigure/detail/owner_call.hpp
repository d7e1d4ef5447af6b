// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DYNAMIC_RECONFIGURE_DETAIL_OWNER_CALL_HPP
#define RTT_DYNAMIC_RECONFIGURE_DETAIL_OWNER_CALL_HPP

#include <rtt/PropertyBag.hpp>

#include <cstdint>
#include <string>

namespace RTT {
class TaskContext;
}

namespace rtt_dynamic_reconfigure::detail {

/** Gives the component new values of its properties: by its operation `updateProperties(bag, level)`, or all at once.
    False, with the reason, and without a change by this, if it refuses them or they do not fit. In its thread. */
bool setProperties(RTT::TaskContext& owner, const RTT::PropertyBag& bag, std::uint32_t level, std::string& why);

/** Calls its operation `notifyPropertiesUpdate(level)` or `notifyPropertiesUpdated(level)`, if it has one. */
void tellChanged(RTT::TaskContext& owner, std::uint32_t level);

}  // namespace rtt_dynamic_reconfigure::detail

#endif
