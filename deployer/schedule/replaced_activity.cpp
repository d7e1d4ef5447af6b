// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "replaced_activity.hpp"

#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt/extras/FileDescriptorActivity.hpp>
#include <rtt/extras/FileDescriptorSimulationActivity.hpp>
#include <rtt/extras/PeriodicActivity.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SimulationActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/engine/deferred_activity.hpp>

#include <algorithm>
#include <typeinfo>

namespace OCL::schedule {
namespace {

using RTT::base::ActivityInterface;

template <class Class>
bool is(const ActivityInterface& activity) {
    return typeid(activity) == typeid(Class);
}

RTT::nsecs periodOf(const ActivityInterface& activity) {
    const RTT::Seconds period = activity.getPeriod();
    return period > 0 ? std::clamp<RTT::nsecs>(RTT::Seconds_to_nsecs(period), 1, RTT::InfiniteNSecs / 2) : 0;
}

std::optional<Kind> kindOf(const ActivityInterface& given) {
    namespace extras = RTT::extras;
    if (is<RTT::Activity>(given)) return Kind::Thread;
    if (is<extras::PeriodicActivity>(given) || is<extras::SimulationActivity>(given)) return Kind::Periods;
    if (is<extras::FileDescriptorActivity>(given) || is<extras::FileDescriptorSimulationActivity>(given))
        return Kind::FileEvents;
    return std::nullopt;
}

}  // namespace

bool hasOwnThread(const ActivityInterface& given) {
    return !dynamic_cast<const RTT::extras::SequentialActivity*>(&given) &&
           !dynamic_cast<const RTT::extras::SlaveActivity*>(&given) && !dynamic_cast<const ScheduledActivity*>(&given);
}

std::optional<Timing> timingOf(ActivityInterface* given, const std::string& component) {
    if (!given || is<RTT::internal::DeferredActivity>(*given)) return Timing();
    if (!hasOwnThread(*given)) return std::nullopt;
    const std::optional<Kind> kind = kindOf(*given);
    if (!kind) {
        RTT::log(RTT::Warning)
            << "warning: ["
            << "RPL003"
            << "] component '" << component
            << "' has an activity of a class of its own, which a replay cannot execute: it keeps its "
               "thread, and the replay is not exact"
            << RTT::endlog();
        return std::nullopt;
    }
    if (*kind == Kind::FileEvents)
        RTT::log(RTT::Warning) << "warning: ["
                               << "RPL004"
                               << "] component '" << component
                               << "' waits for file descriptors, which are never ready in a replay" << RTT::endlog();
    Timing timing;
    timing.kind = *kind;
    timing.period = periodOf(*given);
    if (const RTT::os::ThreadInterface* const thread = given->thread()) {
        timing.priority = thread->getPriority();
        timing.scheduler = thread->getScheduler();
    }
    return timing;
}

}  // namespace OCL::schedule
