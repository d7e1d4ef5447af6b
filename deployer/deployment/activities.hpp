// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_ACTIVITIES_HPP
#define OROFORGE_DEPLOYMENT_ACTIVITIES_HPP

#include "plan.hpp"

#include <string>

namespace RTT {
class TaskContext;
}

namespace OCL::deploy {

/** Numbers of an activity as the operations of the deployer take them. */
struct ActivityNumbers {
    double period = 0;  // seconds; of a FileDescriptorActivity: the timeout in milliseconds
    int priority = 0;
    int scheduler = 0;         // ORO_SCHED_…
    unsigned cpuAffinity = 0;  // 0: all
};

ActivityNumbers numbersOf(const ActivityPlan& plan);

/**
 * Gives a component, which must not run, a new activity. `kind` tells which numbers count; `master` is for a slave
 * and may be null. `waitPolicy` is for its thread. False, with the reason, if the component keeps its old activity.
 */
bool setActivity(RTT::TaskContext& component, ActivityKind kind, const ActivityNumbers& numbers,
                 RTT::TaskContext* master, int waitPolicy, std::string& error);

struct Session;

/** As above, and keeps the slaves of the component with it: they get slave activities of the new one. */
bool changeActivity(Session& session, RTT::TaskContext& component, ActivityKind kind, const ActivityNumbers& numbers,
                    RTT::TaskContext* master, std::string& error);

/** Takes its slaves, which are stopped, from a component that is going to be deleted. */
void releaseSlaves(Session& session, const RTT::TaskContext& master);

}  // namespace OCL::deploy

#endif
