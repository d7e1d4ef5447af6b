// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEDULE_REPLACED_ACTIVITY_HPP
#define OROFORGE_SCHEDULE_REPLACED_ACTIVITY_HPP

#include "scheduled_activity.hpp"

#include <optional>
#include <string>

namespace OCL::schedule {

/** How a schedule executes what `given` would; null is the default activity. None if it stays as it is: it executes in
    the thread that triggers it, or it is of an unknown class, which is reported (RPL003). */
std::optional<Timing> timingOf(RTT::base::ActivityInterface* given, const std::string& component);

/** True for one that is not executed in the thread that triggers it. */
bool hasOwnThread(const RTT::base::ActivityInterface& given);

}  // namespace OCL::schedule

#endif
