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

/** The numbers of an activity, as the deployer's operations take them. */
struct ActivityNumbers {
    double period = 0;  // seconds; for a FileDescriptorActivity the timeout in milliseconds
    int priority = 0;
    int scheduler = 0;         // ORO_SCHED_…
    unsigned cpuAffinity = 0;  // 0: all
};

ActivityNumbers numbersOf(const ActivityPlan& plan);

/**
 * Gives a component, which must not run, a new activity. Which numbers are used depends on `kind`; `master` is for a
 * slave and may be null; `waitPolicy` is for the thread. False, with the reason, if the component keeps its old
 * activity.
 */
bool setActivity(RTT::TaskContext& component, ActivityKind kind, const ActivityNumbers& numbers,
                 RTT::TaskContext* master, int waitPolicy, std::string& error);

struct Session;

/** As above, and also gives the slaves of the component new slave activities of the new activity. */
bool changeActivity(Session& session, RTT::TaskContext& component, ActivityKind kind, const ActivityNumbers& numbers,
                    RTT::TaskContext* master, std::string& error);

/** Releases the slaves, which are stopped, of a component that is about to be deleted. */
void releaseSlaves(Session& session, const RTT::TaskContext& master);

}  // namespace OCL::deploy

#endif
